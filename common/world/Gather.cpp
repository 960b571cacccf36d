#include "common/world/Gather.h"

#include <cmath>
#include <stdexcept>

#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr double kRigid = 1e-9;

[[noreturn]] void refuse(const VRObject& object, const std::string& why) {
  throw std::invalid_argument("'" + object.path() + "' " + why);
}

std::int64_t coordinate(const VRObject& object, double metres) {
  if (!(std::abs(metres) <= static_cast<double>(kWorldLimitNm) * kNanometre))
    refuse(object, "lies beyond the end of the world, 1e9 m from its origin");
  return nanometresFromMetres(metres);
}

BasePose place(const VRObject& object, const Coord3& at) {
  return {coordinate(object, at.x), coordinate(object, at.y), coordinate(object, at.z), 0};
}

/// What turns, tilts or scales things otherwise than about the vertical is refused.
void checkUpright(const VRObject& object, const TransformMatrix& t_world_object) {
  if (!t_world_object.isRigid(kRigid) || std::abs(t_world_object(1, 1) - 1.0) > kRigid)
    refuse(object,
           "is tilted or scaled; what stands in the way, opens or is grasped may be turned about the "
           "vertical only");
}

/// Nearest heading by the project's own sines: the C library only says where to look, and its last bit does
/// not get into a state.
std::int32_t headingOf(const TransformMatrix& t_world_object) {
  std::int32_t units = unitsFromRadians(std::atan2(t_world_object(0, 2), t_world_object(0, 0)));
  const auto off = [&] {
    const SineCosine heading = sineCosine(radiansFromUnits(units));
    return (t_world_object(0, 2) * heading.cosine - t_world_object(0, 0) * heading.sine) / kAngleUnit;
  };
  const auto turn = [&](std::uint32_t by) {
    units = static_cast<std::int32_t>(static_cast<std::uint32_t>(units) + by);
  };
  while (off() > 0.5) turn(1);
  while (off() < -0.5) turn(~std::uint32_t{0});
  return units;
}

SolidBox solidBox(const VRObject& object, const TransformMatrix& t_world_object, const Solid& solid) {
  checkUpright(object, t_world_object);
  SolidBox box;
  const Coord3 bottom = solid.centre - Coord3{0.0, 0.5 * solid.size.y, 0.0};
  box.centre = place(object, t_world_object.point(bottom));
  box.half_x = 0.5 * solid.size.x;
  box.half_z = 0.5 * solid.size.z;
  box.height = solid.size.y;
  box.cosine = t_world_object(0, 0);
  box.sine = t_world_object(0, 2);
  box.owner = object.path();
  return box;
}

class Gatherer {
 public:
  Gathered take() { return std::move(found_); }

  void visitMember(VRObject& object) {
    ++member_;
    visit(object, object.globalTransform());
  }

 private:
  void visit(VRObject& object, const TransformMatrix& t_world_object) {
    if (const auto* solids = object.attribute<Solids>(); solids != nullptr)
      for (const Solid& solid : solids->boxes)
        found_.solids.push_back(solidBox(object, t_world_object, solid));
    if (const auto* doorway = object.attribute<Doorway>(); doorway != nullptr)
      add(object, t_world_object, *doorway);
    if (const auto* graspable = object.attribute<Graspable>(); graspable != nullptr)
      add(object, t_world_object, *graspable);
    if (const auto* light = object.attribute<Light>(); light != nullptr) {
      found_.lights.push_back(*light);
      found_.lights.back().position = t_world_object.point(light->position);
    }
    if (const auto* ambient = object.attribute<Ambient>(); ambient != nullptr)
      found_.ambients.push_back(*ambient);
    if (const auto* reachable = object.attribute<Reachable>(); reachable != nullptr)
      found_.targets.push_back(t_world_object.point(reachable->point));
    for (VRObject* member : object.members()) visit(*member, t_world_object * member->transform());
  }

  SolidBox solidBox(const VRObject& object, const TransformMatrix& t_world_object, const Solid& solid) const {
    SolidBox box = coherency::solidBox(object, t_world_object, solid);
    box.member = member_;
    return box;
  }

  void add(const VRObject& object, const TransformMatrix& t_world_object, const Doorway& doorway) {
    found_.doors.push_back({solidBox(object, t_world_object, doorway.barrier), doorway.sensor});
    found_.leaves.push_back({doorway.leaf, doorway.leaf->position(), doorway.slide});
  }

  void add(VRObject& object, const TransformMatrix& t_world_object, const Graspable& graspable) {
    checkUpright(object, t_world_object);
    MovableModel movable;
    movable.edge = graspable.edge;
    movable.start = place(object, t_world_object.origin());
    movable.start.heading_units = headingOf(t_world_object);
    movable.member = member_;
    movable.name = object.path();
    found_.movables.push_back(movable);
    found_.carried.push_back(&object);
  }

  Gathered found_;
  int member_ = 0;
};

}  // namespace

Gathered gather(const std::vector<VRObject*>& objects) {
  Gatherer gatherer;
  for (VRObject* object : objects) gatherer.visitMember(*object);
  return gatherer.take();
}

}  // namespace coherency
