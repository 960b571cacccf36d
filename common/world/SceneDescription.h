#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/world/BasePose.h"
#include "common/world/Scatter.h"

namespace coherency {

/// One thing that a scene names.
struct ObjectPlacement {
  std::string kind;        ///< a name of the catalogue (Catalogue.h)
  std::string name;        ///< what it is called in the world; unique in its scene
  BasePose place;          ///< of its origin
  std::string colour;      ///< "#rrggbb" for kinds that come in colours; empty: the kind's own
  std::int32_t count = 0;  ///< of parts, for kinds that are made of any number; 0: not given
  bool operator==(const ObjectPlacement&) const = default;
};

/// The slave robot, where a scene has one.
struct RobotPlacement {
  BasePose start;
  BasePose workplace;  ///< where its base should be to reach what can be grasped
  bool operator==(const RobotPlacement&) const = default;
};

/// What a scene may ask of each machine that shows it, be it a file's or a server's on the network. A part
/// (ObjectPlacement::count) costs a client about 12 KB.
inline constexpr std::size_t kMaxSceneObjects = 200;
inline constexpr std::int32_t kMaxSceneParts = 200'000;  ///< the sum of all counts

/// A world in words: what configs/scenes/ files say and the server hands to every client. A scene has in it
/// what is named here and nothing else.
struct SceneDescription {
  std::string name;
  bool operator_shown =
      true;  ///< false: the operator is a pair of eyes (and, where things are to be grasped, a hand)
  bool driving = true;  ///< false: one stays where one is; stick and pedals are not needed
  BasePose start;
  BasePose workplace;
  std::optional<RobotPlacement> robot;
  std::optional<ScatterArea> scatter;
  std::vector<ObjectPlacement> objects;
  bool operator==(const SceneDescription&) const = default;
};

}  // namespace coherency
