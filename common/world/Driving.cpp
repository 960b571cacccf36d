#include "common/world/Driving.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"
#include "common/world/Plan.h"

namespace coherency {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kPushSpeed = 2.0;  // m/s
constexpr int kPushes = 4;          // in one step: a corner has two walls
constexpr double kTouching = 2e-9;  // m, what rounding to nanometres leaves

double control(const MotionSample& sample, Dof dof) {
  return sample.isValid(dof) ? sample.si(dof) : 0.0;
}

/// Speeds in um/s, in the base's axes.
struct Planar {
  double right = 0.0;
  double ahead = 0.0;
  double length() const { return std::sqrt(right * right + ahead * ahead); }
};

Planar wishedVelocity(const DriveControls& c, const DriveLimits& limits) {
  const double factor = 1.0 + (limits.boost - 1.0) * c.boost;
  const double full = limits.speed * factor * (1.0 - c.brake) / kMicrometre;
  const Planar stick{c.right, c.ahead};
  const double deflection =
      std::max(1.0, stick.length());  // the stick's corners are no faster than its edges
  const double fastest = kFastestUm;
  return {std::clamp(stick.right / deflection * full, -fastest, fastest),
          std::clamp(stick.ahead / deflection * full, -fastest, fastest)};
}

/// The part of a change that limits allow, in whole units: rounded towards zero so that they are kept, but a
/// limit that is a whole number is not missed for want of a last bit.
double wholePart(double part) {
  const double nearest = std::round(part);
  return std::abs(part - nearest) < 1e-6 ? nearest : std::trunc(part);
}

/// `now` moved by `share` of the way to `wished`; reaches it for a share of 1 or more.
std::int32_t approach(std::int32_t now, double wished, double share) {
  const double change = wished - now;
  return static_cast<std::int32_t>(now + (share >= 1.0 ? std::round(change) : wholePart(change * share)));
}

void accelerate(Vehicle& vehicle, const DriveControls& controls, double period_s, const DriveLimits& limits) {
  const Planar wished = wishedVelocity(controls, limits);
  const Planar now{static_cast<double>(vehicle.velocity_right_um),
                   static_cast<double>(vehicle.velocity_ahead_um)};
  const double change = Planar{wished.right - now.right, wished.ahead - now.ahead}.length();
  if (change == 0.0) return;
  const bool slower = wished.length() < now.length();
  const double hardest =
      slower ? limits.acceleration + controls.brake * std::max(0.0, limits.brake - limits.acceleration)
             : limits.acceleration;
  const double allowed = hardest * period_s / kMicrometre;
  const double share = change <= allowed ? 1.0 : allowed / change;
  vehicle.velocity_right_um = approach(vehicle.velocity_right_um, wished.right, share);
  vehicle.velocity_ahead_um = approach(vehicle.velocity_ahead_um, wished.ahead, share);
}

void accelerateTurn(Vehicle& vehicle, double twist, double period_s, const DriveLimits& limits) {
  const double wished =
      std::clamp<double>(twist * limits.turn_rate / kAngleUnit, -kFastestTurn, kFastestTurn);
  const double change = std::abs(wished - vehicle.turn_rate_units);
  if (change == 0.0) return;
  const double allowed = limits.turn_acceleration * period_s / kAngleUnit;
  vehicle.turn_rate_units =
      approach(vehicle.turn_rate_units, wished, change <= allowed ? 1.0 : allowed / change);
}

void turn(Vehicle& vehicle, std::int64_t period_ns) {
  const std::int64_t product = vehicle.turn_rate_units * period_ns;
  const std::int64_t units = (product + (product < 0 ? -kSecond : kSecond) / 2) / kSecond;
  vehicle.base.heading_units = static_cast<std::int32_t>(
      static_cast<std::uint32_t>(vehicle.base.heading_units) + static_cast<std::uint32_t>(units));
}

void moveBy(BasePose& base, PlanPoint metres) {
  base.x_nm = movedBy(base.x_nm, metres.x);
  base.z_nm = movedBy(base.z_nm, metres.z);
}

bool heightsMeet(double low, double high, double other_low, double other_high) {
  return low < other_high && other_low < high;
}

/// The deepest of all contacts of one disc.
class DiscContacts {
 public:
  DiscContacts(const FootprintDisc& disc, const BasePose& centre) : disc_(disc), centre_(centre) {}

  void with(const SolidBox& box) {
    const double low = metresFromNanometres(box.centre.y_nm - centre_.y_nm);
    if (!heightsMeet(disc_.low, disc_.high, low, low + box.height)) return;
    const PlanPoint apart = between(centre_, box.centre);
    const double reach = disc_.radius + box.half_x + box.half_z;
    if (std::abs(apart.x) > reach || std::abs(apart.z) > reach) return;
    keep(discInRectangle(disc_.radius, rectangle(box, centre_)), &box);
  }

  void with(const Vehicle& other, const VehicleModel& model) {
    const SineCosine heading = sineCosine(radiansFromUnits(other.base.heading_units));
    for (const FootprintDisc& theirs : model.footprint) {
      if (!heightsMeet(disc_.low, disc_.high, theirs.low, theirs.high)) continue;
      keep(discInDisc(disc_.radius, between(centre_, discCentre(other.base, theirs, heading)), theirs.radius),
           nullptr);
    }
  }

  const PlanContact& deepest() const { return deepest_; }
  const SolidBox* solid() const { return solid_; }

 private:
  void keep(const PlanContact& contact, const SolidBox* solid) {
    if (contact.depth > deepest_.depth) deepest_ = contact, solid_ = solid;
  }

  const FootprintDisc& disc_;
  const BasePose& centre_;
  PlanContact deepest_;
  const SolidBox* solid_ = nullptr;
};

struct Contact {
  PlanContact plan;
  std::string_view owner;
};

Contact contactOf(const BasePose& base, const VehicleModel& model, const Surroundings& around) {
  const SineCosine heading = sineCosine(radiansFromUnits(base.heading_units));
  Contact deepest;
  for (const FootprintDisc& disc : model.footprint) {
    const BasePose centre = discCentre(base, disc, heading);
    DiscContacts contacts(disc, centre);
    for (const SolidBox& box : around.solids) contacts.with(box);
    for (std::size_t i = 0; i < around.doors.size(); ++i)
      if (around.openings[i] < kDoorPassable) contacts.with(around.doors[i].barrier);
    if (around.other != nullptr) contacts.with(*around.other, *around.other_model);
    if (contacts.deepest().depth <= deepest.plan.depth) continue;
    deepest.plan = contacts.deepest();
    deepest.owner =
        contacts.solid() != nullptr ? std::string_view(contacts.solid()->owner) : "the other vehicle";
  }
  return deepest;
}

/// Moves as velocity and turn rate say, then out of whatever that led into.
void move(Vehicle& vehicle, double period_s, const VehicleModel& model, const Surroundings& around,
          const BasePose& before) {
  const SineCosine heading = sineCosine(radiansFromUnits(vehicle.base.heading_units));
  PlanPoint velocity{heading.cosine * vehicle.velocity_right_um - heading.sine * vehicle.velocity_ahead_um,
                     -heading.sine * vehicle.velocity_right_um - heading.cosine * vehicle.velocity_ahead_um};
  moveBy(vehicle.base, velocity * (period_s * kMicrometre));
  if (around.nothing()) return;
  Contact contact = contactOf(vehicle.base, model, around);
  if (contact.plan.depth <= kTouching) return;
  double budget = length(velocity) * period_s * kMicrometre + kPushSpeed * period_s;
  for (int push = 0; push < kPushes && contact.plan.depth > kTouching; ++push) {
    const double inwards = dot(velocity, contact.plan.away);
    if (inwards < 0.0) velocity = velocity - contact.plan.away * inwards;
    // A nanometre more, so that what is rounded is clear.
    const double by = std::min(contact.plan.depth + kNanometre, budget);
    moveBy(vehicle.base, contact.plan.away * by);
    budget -= by;
    contact = contactOf(vehicle.base, model, around);
  }
  if (contact.plan.depth > std::max(kTouching, contactOf(before, model, around).plan.depth)) {
    vehicle = Vehicle{before};  // no room: it stays where it was
    return;
  }
  vehicle.velocity_right_um =
      static_cast<std::int32_t>(heading.cosine * velocity.x - heading.sine * velocity.z);
  vehicle.velocity_ahead_um =
      static_cast<std::int32_t>(-heading.sine * velocity.x - heading.cosine * velocity.z);
}

}  // namespace

DriveControls driveControls(const MotionSample& sample) {
  return {control(sample, Dof::StickX), control(sample, Dof::StickY), control(sample, Dof::StickTwist),
          control(sample, Dof::PedalLeft), control(sample, Dof::PedalRight)};
}

bool isWithinLimits(const Vehicle& vehicle, const DriveLimits& limits) {
  constexpr double kRounding = 4.0;
  const Planar now{static_cast<double>(vehicle.velocity_right_um),
                   static_cast<double>(vehicle.velocity_ahead_um)};
  return now.length() <= limits.speed * std::max(1.0, limits.boost) / kMicrometre + kRounding &&
         std::abs(vehicle.turn_rate_units * kAngleUnit) <= limits.turn_rate + kRounding * kAngleUnit;
}

void drive(Vehicle& vehicle, const DriveControls& controls, std::int64_t period_ns, const VehicleModel& model,
           const Surroundings& surroundings) {
  assert(period_ns > 0 && period_ns <= kSecond);
  const double period_s = static_cast<double>(period_ns) * 1e-9;
  const BasePose before = vehicle.base;
  accelerate(vehicle, controls, period_s, model.limits);
  accelerateTurn(vehicle, controls.twist, period_s, model.limits);
  if (vehicle == Vehicle{before}) return;  // at rest: what stands still runs into nothing
  turn(vehicle, period_ns);
  move(vehicle, period_s, model, surroundings, before);
}

BasePose discCentre(const BasePose& base, const FootprintDisc& disc, const SineCosine& heading) {
  BasePose centre = base;
  centre.x_nm += std::llround((heading.cosine * disc.x + heading.sine * disc.z) / kNanometre);
  centre.z_nm += std::llround((-heading.sine * disc.x + heading.cosine * disc.z) / kNanometre);
  return centre;
}

double deepestContact(const BasePose& base, const VehicleModel& model, const Surroundings& surroundings,
                      std::string* owner) {
  const Contact contact = contactOf(base, model, surroundings);
  if (owner != nullptr) *owner = contact.owner;
  return contact.plan.depth;
}

}  // namespace coherency
