#pragma once

#include <string>
#include <utility>

#include "common/scene/Primitives.h"

namespace coherency {

/// Names and paints `part`, a data member of `owner`'s class, and makes it a member of `owner` standing at
/// `at`.
template <class Shape>
void assemble(VRObject& owner, Shape& part, std::string name, const Material& material,
              const Coord3& at = {}) {
  part.setName(std::move(name));
  part.setMaterial(material);
  part.setPosition(at);
  owner.addMember(&part);
}

/// The same for a box that gets its size here.
inline void assembleBox(VRObject& owner, Box& box, std::string name, const Material& material,
                        const Coord3& size, const Coord3& centre) {
  box.setSize(size);
  assemble(owner, box, std::move(name), material, centre);
}

}  // namespace coherency
