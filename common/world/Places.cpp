#include "common/world/Places.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "common/math/FixedPoint.h"
#include "common/world/Driving.h"
#include "common/world/Plan.h"

namespace coherency {

namespace {

constexpr double kAllowed = 2e-3;  // m, that neighbours may reach into each other

std::string millimetres(double metres) {
  std::ostringstream text;
  text << std::round(metres * 1e4) / 10.0 << " mm";
  return text.str();
}

std::string at(const BasePose& place) {
  std::ostringstream text;
  text << "x " << metresFromNanometres(place.x_nm) << ", z " << metresFromNanometres(place.z_nm) << " m";
  return text.str();
}

void checkApart(const SolidBox& a, const SolidBox& b) {
  const double lift = metresFromNanometres(b.centre.y_nm - a.centre.y_nm);
  const double up = lift + b.height;
  const double down = a.height - lift;
  const double aside = rectangleInRectangle(rectangle(a, a.centre), rectangle(b, a.centre)).depth;
  const double least = std::min({up, down, aside});
  if (least <= kAllowed) return;
  const std::string by = millimetres(least);
  throw std::invalid_argument("'" + a.owner + "' stands in '" + b.owner + "' by " + by + " at " +
                              at(a.centre) +
                              (least == up     ? "; raise it by " + by
                               : least == down ? "; lower it by " + by
                                               : "; move it aside by " + by));
}

void checkOverFloor(const SolidBox& movable) {
  const double low = -metresFromNanometres(movable.centre.y_nm);
  if (low > kAllowed)
    throw std::invalid_argument("'" + movable.owner + "' stands in the floor by " + millimetres(low) +
                                " at " + at(movable.centre) + "; raise it by as much");
}

/// One vehicle at one place, and what must not be there.
struct Visit {
  const WorldModel& model;
  const VehicleModel& vehicle;
  std::string who;
  std::string key;
  const BasePose& place;
};

[[noreturn]] void refuse(const Visit& v, const std::string& in, double depth) {
  throw std::invalid_argument(v.who + " would stand in " + in + " by " + millimetres(depth) + " at its " +
                              v.key + ", " + at(v.place) + "; give another " + v.key);
}

void checkClear(const Visit& v, const std::vector<SolidBox>& solids) {
  std::string owner;
  const std::vector<std::int32_t> closed(v.model.doors.size(), 0);
  const double depth = deepestContact(v.place, v.vehicle, {solids, v.model.doors, closed}, &owner);
  if (depth > kAllowed) refuse(v, "'" + owner + "'", depth);
}

void checkClear(const Visit& v, const std::string& other, const BasePose& other_start,
                const VehicleModel& model) {
  const Vehicle there{other_start};
  Surroundings around;
  around.other = &there;
  around.other_model = &model;
  const double depth = deepestContact(v.place, v.vehicle, around, nullptr);
  if (depth > kAllowed) refuse(v, other + " at its start", depth);
}

}  // namespace

SolidBox boxOf(const MovableModel& movable, const BasePose& centre) {
  SolidBox box;
  box.centre = centre;
  box.centre.y_nm -= nanometresFromMetres(0.5 * movable.edge);
  box.half_x = box.half_z = 0.5 * movable.edge;
  box.height = movable.edge;
  const SineCosine turn = sineCosine(radiansFromUnits(centre.heading_units));
  box.cosine = turn.cosine;
  box.sine = turn.sine;
  box.owner = movable.name;
  box.member = movable.member;
  return box;
}

bool begins(const WorldModel& model, const SolidBox& box) {
  const auto in = [&](const VehicleModel& vehicle) {
    return deepestContact(vehicle.start, vehicle, {{&box, 1}}, nullptr) > kAllowed;
  };
  return in(model.master) || (model.robot && in(*model.robot));
}

bool standsFree(const BasePose& base, const VehicleModel& vehicle, const WorldModel& model) {
  const std::vector<std::int32_t> closed(model.doors.size(), 0);
  return deepestContact(base, vehicle, {model.solids, model.doors, closed}, nullptr) <= kAllowed;
}

void checkPlaces(const WorldModel& model, const VehiclePlaces& master, const VehiclePlaces& robot) {
  std::vector<SolidBox> movables;
  for (const MovableModel& m : model.movables) movables.push_back(boxOf(m, m.start));
  std::for_each(movables.begin(), movables.end(), checkOverFloor);
  std::vector<SolidBox> boxes = model.solids;
  for (const DoorModel& door : model.doors) boxes.push_back(door.barrier);
  boxes.insert(boxes.end(), movables.begin(), movables.end());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].member != boxes[j].member) checkApart(boxes[j], boxes[i]);
  std::vector<SolidBox> in_the_way = model.solids;
  in_the_way.insert(in_the_way.end(), movables.begin(), movables.end());
  const auto check = [&](const VehicleModel& vehicle, const std::string& who, const VehiclePlaces& places,
                         const VehicleModel* other, const std::string& other_who,
                         const BasePose& other_start) {
    const Visit start{model, vehicle, who, "start", places.start};
    checkClear(start, in_the_way);
    if (other != nullptr) checkClear(start, other_who, other_start, *other);
    if (!places.workplace) return;
    const Visit work{model, vehicle, who, "workplace", *places.workplace};
    checkClear(work, model.solids);
    if (other != nullptr) checkClear(work, other_who, other_start, *other);
  };
  const VehicleModel* other = model.robot ? &*model.robot : nullptr;
  check(model.master, "the master system", master, other, "the slave robot", robot.start);
  if (other != nullptr)
    check(*other, "the slave robot", robot, &model.master, "the master system", master.start);
}

}  // namespace coherency
