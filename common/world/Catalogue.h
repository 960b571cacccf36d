#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/body/VirtualHuman.h"
#include "common/world/SceneDescription.h"

namespace coherency {

/// Whom a scene is made for: some objects fit themselves to the operator, or are attached to them.
struct Stage {
  const Rig& rig;
  VirtualHuman& human;
};

/// A kind of object that scenes can name.
struct CatalogueEntry {
  std::string_view kind;
  std::string_view what;  ///< for people
  std::unique_ptr<VRObject> (*make)(const ObjectPlacement&, Stage&);
  bool coloured = false;  ///< takes ObjectPlacement::colour
  bool counted = false;   ///< needs ObjectPlacement::count
};

/// All kinds. A new one is a class of its own and one line in Catalogue.cpp.
std::span<const CatalogueEntry> catalogue();

/// Null where there is no such kind.
const CatalogueEntry* findKind(std::string_view kind);

/// What one placement by itself can have wrong: no such kind (with those there are), a colour that is none or
/// not taken, a count that is missing or not taken.
struct PlacementFault {
  std::string_view key;  ///< "kind", "colour" or "count": where in a scene's file
  std::string what;
};
std::optional<PlacementFault> faultOf(const ObjectPlacement& placement);

/// Makes the object and puts it in its place. Throws std::invalid_argument naming the object and faultOf()
/// it.
std::unique_ptr<VRObject> makeObject(const ObjectPlacement& placement, Stage& stage);

}  // namespace coherency
