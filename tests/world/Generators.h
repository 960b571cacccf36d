#pragma once

#include "common/world/WorldState.h"
#include "tests/math/Random.h"

namespace coherency::random {

inline BasePose base() {
  const auto coordinate = [] { return *rc::gen::inRange<std::int64_t>(-kWorldLimitNm, kWorldLimitNm + 1); };
  return {coordinate(), coordinate(), coordinate(), *rc::gen::arbitrary<std::int32_t>()};
}

/// Any state that can be.
inline WorldState state() {
  const auto speed = [] { return *rc::gen::inRange(-1'100'000, 1'100'000); };  // um/s, both ways at once
  const auto turn_rate = [] { return *rc::gen::inRange(-500'000'000, 500'000'000); };
  WorldState s;
  s.tick = *rc::gen::arbitrary<std::uint64_t>();
  s.mode = *rc::gen::element(Mode::Operator, Mode::Robot);
  s.master = {base(), speed(), speed(), turn_rate()};
  s.robot = {base(), speed(), speed(), turn_rate()};
  s.closed_hands = static_cast<std::uint8_t>(*rc::gen::inRange(0, 4));
  const auto movables = *rc::gen::inRange<std::size_t>(0, kMaxMovables + 1);
  for (std::size_t i = 0; i < movables; ++i) {
    const BasePose at = base();
    Movable m{*rc::gen::element(Holder::Nobody, Holder::OperatorHand, Holder::RobotHand), at.x_nm, at.y_nm,
              at.z_nm};
    setAttitude(m, quaternion(rotationMatrix()));
    m.fall_um = *rc::gen::inRange(0, kFastestFallUm + 1);
    m.resting = *rc::gen::arbitrary<bool>();
    m.unrest_us = *rc::gen::inRange<std::uint32_t>(0, kPatienceUs + 1);
    s.movables.push_back(m);
  }
  const auto doors = *rc::gen::inRange<std::size_t>(0, kMaxDoors + 1);
  for (std::size_t i = 0; i < doors; ++i) s.doors.push_back(*rc::gen::inRange(0, kDoorOpen + 1));
  s.task = {*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(),
            *rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<bool>()};
  return s;
}

}  // namespace coherency::random
