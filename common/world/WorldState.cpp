#include "common/world/WorldState.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kFastestUm = 2e9;  // what a speed's int32 holds

class Fnv1a {
 public:
  template <class Integer>
  void add(Integer value) {
    auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
    for (std::size_t byte = 0; byte < sizeof(Integer); ++byte) {
      hash_ = (hash_ ^ static_cast<std::uint8_t>(bits & 0xFFU)) * 0x100000001B3U;
      bits = static_cast<decltype(bits)>(bits >> 8);
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

/// Speeds in um/s, in the base's axes.
struct Planar {
  double right = 0.0;
  double ahead = 0.0;
  double length() const { return std::hypot(right, ahead); }
};

double control(const MotionSample& sample, Dof dof) {
  return sample.isValid(dof) ? sample.si(dof) : 0.0;
}

Planar wishedVelocity(const MotionSample& sample, const DriveLimits& limits) {
  const double factor = 1.0 + (limits.boost - 1.0) * control(sample, Dof::PedalRight);
  const double full = limits.speed * factor * (1.0 - control(sample, Dof::PedalLeft)) / kMicrometre;
  Planar stick{control(sample, Dof::StickX), control(sample, Dof::StickY)};
  const double deflection =
      std::max(1.0, stick.length());  // the stick's corners are no faster than its edges
  return {std::clamp(stick.right / deflection * full, -kFastestUm, kFastestUm),
          std::clamp(stick.ahead / deflection * full, -kFastestUm, kFastestUm)};
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

void accelerate(WorldState& state, const MotionSample& sample, double period_s, const DriveLimits& limits) {
  const Planar wished = wishedVelocity(sample, limits);
  const Planar now{static_cast<double>(state.velocity_right_um),
                   static_cast<double>(state.velocity_ahead_um)};
  const double brake = control(sample, Dof::PedalLeft);
  const bool slower = wished.length() < now.length();
  const double hardest = slower
                             ? limits.acceleration + brake * std::max(0.0, limits.brake - limits.acceleration)
                             : limits.acceleration;
  const double change = Planar{wished.right - now.right, wished.ahead - now.ahead}.length();
  const double allowed = hardest * period_s / kMicrometre;
  const double share = change <= allowed ? 1.0 : allowed / change;
  state.velocity_right_um = approach(state.velocity_right_um, wished.right, share);
  state.velocity_ahead_um = approach(state.velocity_ahead_um, wished.ahead, share);

  const double wished_turn =
      std::clamp(control(sample, Dof::StickTwist) * limits.turn_rate / kAngleUnit, -kFastestUm, kFastestUm);
  const double turn_change = std::abs(wished_turn - state.turn_rate_units);
  const double turn_allowed = limits.turn_acceleration * period_s / kAngleUnit;
  state.turn_rate_units = approach(state.turn_rate_units, wished_turn,
                                   turn_change <= turn_allowed ? 1.0 : turn_allowed / turn_change);
}

void turn(WorldState& state, std::int64_t period_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t product = state.turn_rate_units * period_ns;
  const std::int64_t units = (product + (product < 0 ? -kSecond : kSecond) / 2) / kSecond;
  state.base.heading_units = static_cast<std::int32_t>(static_cast<std::uint32_t>(state.base.heading_units) +
                                                       static_cast<std::uint32_t>(units));
}

/// Moves one coordinate as far as the border; true if the border stopped it. From outside one may only come
/// in.
bool moveWithin(std::int64_t& position_nm, std::int64_t by_nm, double min_m, double max_m) {
  const std::int64_t low = std::min(nanometresFromMetres(min_m), position_nm);
  const std::int64_t high = std::max(nanometresFromMetres(max_m), position_nm);
  const std::int64_t wished = position_nm + by_nm;
  position_nm = std::clamp(wished, low, high);
  return position_nm != wished;
}

void move(WorldState& state, double period_s, const DriveArea& area) {
  const double heading = radiansFromUnits(state.base.heading_units);
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  double world_x = c * state.velocity_right_um - s * state.velocity_ahead_um;
  double world_z = -s * state.velocity_right_um - c * state.velocity_ahead_um;
  const double nm = period_s * (kMicrometre / kNanometre);
  const bool stopped_x = moveWithin(state.base.x_nm, std::llround(world_x * nm), area.min_x, area.max_x);
  const bool stopped_z = moveWithin(state.base.z_nm, std::llround(world_z * nm), area.min_z, area.max_z);
  if (!stopped_x && !stopped_z) return;
  if (stopped_x) world_x = 0.0;
  if (stopped_z) world_z = 0.0;
  state.velocity_right_um = static_cast<std::int32_t>(c * world_x - s * world_z);
  state.velocity_ahead_um = static_cast<std::int32_t>(-s * world_x - c * world_z);
}

}  // namespace

TransformMatrix transform(const BasePose& base) {
  TransformMatrix t = TransformMatrix::rotationY(radiansFromUnits(base.heading_units));
  t.setOrigin(
      {metresFromNanometres(base.x_nm), metresFromNanometres(base.y_nm), metresFromNanometres(base.z_nm)});
  return t;
}

std::uint64_t stateHash(const WorldState& state, const MotionSample& sample) {
  Fnv1a hash;
  hash.add(state.tick);
  hash.add(state.base.x_nm);
  hash.add(state.base.y_nm);
  hash.add(state.base.z_nm);
  hash.add(state.base.heading_units);
  hash.add(state.velocity_right_um);
  hash.add(state.velocity_ahead_um);
  hash.add(state.turn_rate_units);
  hash.add(sample.sequence);
  hash.add(sample.server_time_ns);
  hash.add(sample.device_time_us);
  hash.add(sample.valid);
  for (const std::int32_t units : sample.units) hash.add(units);
  return hash.value();
}

void step(WorldState& state, const MotionSample& sample, std::int64_t period_ns, const DriveLimits& limits,
          const DriveArea& area) {
  assert(period_ns > 0 && period_ns <= 1'000'000'000);
  const double period_s = static_cast<double>(period_ns) * 1e-9;
  ++state.tick;
  accelerate(state, sample, period_s, limits);
  turn(state, period_ns);
  move(state, period_s, area);
}

}  // namespace coherency
