#include "common/world/Gather.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "common/math/FixedPoint.h"
#include "common/scene/Physical.h"
#include "common/world/Driving.h"
#include "common/world/Plan.h"

namespace coherency {

namespace {

constexpr double kRigid = 1e-9;
constexpr double kTouching = 2e-3;  // m, that neighbours may reach into each other

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

 private:
  void add(const VRObject& object, const TransformMatrix& t_world_object, const Doorway& doorway) {
    found_.doors.push_back({solidBox(object, t_world_object, doorway.barrier), doorway.sensor});
    found_.leaves.push_back({doorway.leaf, doorway.leaf->position(), doorway.slide});
  }

  void add(VRObject& object, const TransformMatrix& t_world_object, const Graspable& graspable) {
    checkUpright(object, t_world_object);
    MovableModel movable;
    movable.edge = graspable.edge;
    movable.start = place(object, t_world_object.origin());
    movable.start.heading_units = unitsFromRadians(yawPitchRoll(t_world_object).yaw);
    movable.name = object.path();
    found_.movables.push_back(movable);
    found_.carried.push_back(&object);
  }

  Gathered found_;
};

/// The scene's member that a path goes through: "scene/table/leg" -> "table".
std::string memberOf(const std::string& path) {
  const std::size_t first = path.find('/');
  return path.substr(first + 1, path.find('/', first + 1) - first - 1);
}

SolidBox boxOf(const MovableModel& m) {
  SolidBox box;
  box.centre = m.start;
  box.centre.y_nm -= nanometresFromMetres(0.5 * m.edge);
  box.half_x = box.half_z = 0.5 * m.edge;
  box.height = m.edge;
  const TransformMatrix turn = TransformMatrix::rotationY(radiansFromUnits(m.start.heading_units));
  box.cosine = turn(0, 0);
  box.sine = turn(0, 2);
  box.owner = m.name;
  return box;
}

void checkApart(const SolidBox& a, const SolidBox& b) {
  const double lift = metresFromNanometres(b.centre.y_nm - a.centre.y_nm);
  if (lift > a.height - kTouching || -lift > b.height - kTouching) return;
  const double depth = rectangleInRectangle(rectangle(a, a.centre), rectangle(b, a.centre)).depth;
  if (depth <= kTouching) return;
  std::ostringstream text;
  text << "'" << a.owner << "' stands in '" << b.owner << "' by " << std::round(depth * 1000.0) << " mm at x "
       << metresFromNanometres(a.centre.x_nm) << ", z " << metresFromNanometres(a.centre.z_nm)
       << " m; move one of them";
  throw std::invalid_argument(text.str());
}

void checkVehicle(const WorldModel& model, const VehicleModel& vehicle, const BasePose& at, const char* who) {
  std::string owner;
  const std::vector<std::int32_t> closed(model.doors.size(), 0);
  const double depth = deepestContact(at, vehicle, {model.solids, model.doors, closed}, &owner);
  if (depth <= kTouching) return;
  std::ostringstream text;
  text << who << " at x " << metresFromNanometres(at.x_nm) << ", z " << metresFromNanometres(at.z_nm)
       << " m would stand in '" << owner << "' by " << std::round(depth * 1000.0)
       << " mm; give another place";
  throw std::invalid_argument(text.str());
}

}  // namespace

Gathered gather(const std::vector<VRObject*>& objects) {
  Gatherer gatherer;
  for (VRObject* object : objects) gatherer.visit(*object, object->globalTransform());
  return gatherer.take();
}

void checkPlaces(const WorldModel& model, const std::vector<BasePose>& master_places,
                 const std::vector<BasePose>& robot_places) {
  std::vector<SolidBox> boxes = model.solids;
  for (const DoorModel& door : model.doors) boxes.push_back(door.barrier);
  for (const MovableModel& m : model.movables) boxes.push_back(boxOf(m));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (memberOf(boxes[i].owner) != memberOf(boxes[j].owner)) checkApart(boxes[j], boxes[i]);
  if (!model.driving) return;
  for (const BasePose& at : master_places) checkVehicle(model, model.master, at, "the master system");
  if (!model.robot) return;
  for (const BasePose& at : robot_places) checkVehicle(model, *model.robot, at, "the slave robot");
}

}  // namespace coherency
