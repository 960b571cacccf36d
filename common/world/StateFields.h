#pragma once

#include <algorithm>
#include <type_traits>

#include "common/world/WorldState.h"

namespace coherency {

/// Calls visit(name, field) for every field, and for the number of movables and doors as std::uint8_t, in the
/// order in which hash and snapshot take them. The one list of what a state is.
template <class State, class Visit>
void forEachField(State& s, Visit&& visit) {
  const auto vehicle = [&](auto& v) {
    visit("base x", v.base.x_nm);
    visit("base y", v.base.y_nm);
    visit("base z", v.base.z_nm);
    visit("heading", v.base.heading_units);
    visit("velocity right", v.velocity_right_um);
    visit("velocity ahead", v.velocity_ahead_um);
    visit("turn rate", v.turn_rate_units);
  };
  const auto resized = [&](const char* name, auto& list) {
    auto count = static_cast<std::uint8_t>(list.size());
    visit(name, count);
    if constexpr (!std::is_const_v<State>) list.resize(std::min<std::size_t>(count, list.capacity()));
  };
  visit("tick", s.tick);
  visit("mode", s.mode);
  vehicle(s.master);
  vehicle(s.robot);
  visit("closed hands", s.closed_hands);
  resized("number of movables", s.movables);
  for (auto& m : s.movables) {
    visit("holder", m.holder);
    visit("movable x", m.x_nm);
    visit("movable y", m.y_nm);
    visit("movable z", m.z_nm);
    for (auto& component : m.attitude) visit("movable attitude", component);
    visit("fall", m.fall_um);
    visit("resting", m.resting);
    visit("unrest", m.unrest_us);
  }
  resized("number of doors", s.doors);
  for (auto& door : s.doors) visit("door", door);
  visit("task started", s.task.started_tick);
  visit("task done", s.task.done_tick);
  visit("towers", s.task.towers);
  visit("tower stands", s.task.standing);
}

}  // namespace coherency
