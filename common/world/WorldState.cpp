#include "common/world/WorldState.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "common/math/FixedPoint.h"
#include "common/world/StateFields.h"

namespace coherency {

namespace {

class Fnv1a {
 public:
  template <class Value>
  void add(Value value) {
    if constexpr (std::is_enum_v<Value>) {
      add(static_cast<std::underlying_type_t<Value>>(value));
    } else if constexpr (std::is_same_v<Value, bool>) {
      add(static_cast<std::uint8_t>(value));
    } else {
      auto bits = static_cast<std::make_unsigned_t<Value>>(value);
      for (std::size_t byte = 0; byte < sizeof(Value); ++byte) {
        hash_ = (hash_ ^ static_cast<std::uint8_t>(bits & 0xFFU)) * 0x100000001B3U;
        if constexpr (sizeof(Value) > 1) bits = static_cast<decltype(bits)>(bits >> 8);
      }
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

}  // namespace

Quaternion attitude(const Movable& movable) {
  const auto& q = movable.attitude;
  return {ratioFromUnits(q[0]), ratioFromUnits(q[1]), ratioFromUnits(q[2]), ratioFromUnits(q[3])};
}

void setAttitude(Movable& movable, const Quaternion& q) {
  const Quaternion unit = normalized(q);
  const double sign = unit.w < 0.0 ? -1.0 : 1.0;
  movable.attitude = {unitsFromRatio(sign * unit.x), unitsFromRatio(sign * unit.y),
                      unitsFromRatio(sign * unit.z), unitsFromRatio(sign * unit.w)};
}

TransformMatrix transform(const Movable& movable) {
  TransformMatrix t = rotation(attitude(movable));
  t.setOrigin({metresFromNanometres(movable.x_nm), metresFromNanometres(movable.y_nm),
               metresFromNanometres(movable.z_nm)});
  return t;
}

bool isValid(const WorldState& state) {
  const auto within = [](std::int64_t nm) { return nm >= -kWorldLimitNm && nm <= kWorldLimitNm; };
  const auto good = [&](const auto& at) { return within(at.x_nm) && within(at.y_nm) && within(at.z_nm); };
  const auto goodMovable = [&](const Movable& m) {
    // Rounding and w >= 0 aside, the length is 1: far from it is no attitude of ours.
    double square = 0.0;
    for (const std::int32_t c : m.attitude) square += ratioFromUnits(c) * ratioFromUnits(c);
    return good(m) && m.fall_um >= 0 && m.fall_um <= kFastestFallUm && m.unrest_us <= kPatienceUs &&
           m.holder <= Holder::RobotHand && std::abs(square - 1.0) < 1e-6;
  };
  const auto goodVehicle = [&](const Vehicle& v) {
    const auto below = [](std::int64_t value, std::int64_t most) { return value >= -most && value <= most; };
    return good(v.base) && below(v.velocity_right_um, kFastestUm) && below(v.velocity_ahead_um, kFastestUm) &&
           below(v.turn_rate_units, kFastestTurn);
  };
  return state.mode <= Mode::Robot && goodVehicle(state.master) && goodVehicle(state.robot) &&
         state.closed_hands <= 3 && std::all_of(state.movables.begin(), state.movables.end(), goodMovable) &&
         std::all_of(state.doors.begin(), state.doors.end(),
                     [](std::int32_t door) { return door >= 0 && door <= kDoorOpen; });
}

std::uint64_t stateHash(const WorldState& state, const MotionSample& sample) {
  Fnv1a hash;
  forEachField(state, [&hash](const char*, const auto& field) { hash.add(field); });
  hash.add(sample.sequence);
  hash.add(sample.server_time_ns);
  hash.add(sample.device_time_us);
  hash.add(sample.valid);
  for (const std::int32_t units : sample.units) hash.add(units);
  return hash.value();
}

}  // namespace coherency
