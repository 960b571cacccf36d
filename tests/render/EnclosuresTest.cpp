// What walls are said to hide is hidden: against the straight ways from the eye; needs no OpenGL.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render_client/cull/Enclosures.h"
#include "tests/render/Chance.h"

namespace coherency {
namespace {

double component(const Coord3& v, std::size_t axis) {
  return v.glm()[static_cast<int>(axis)];
}

/// A room about the origin of its own frame, with rectangular openings in some of its faces.
struct TestRoom {
  struct Opening {
    std::size_t axis;  ///< of the face's normal
    double wall;       ///< where the face is, on it
    Coord3 low, high;
  };

  Coord3 half;
  std::vector<Opening> openings;
  TransformMatrix t_world_room;

  explicit TestRoom(Chance& chance)
      : half{chance.between(0.5, 5.0), chance.between(1.0, 2.0), chance.between(0.5, 5.0)} {
    for (auto count = chance.oneOf(4); count > 0; --count) addOpening(chance);
    const Coord3 axis = chance.oneOf(2) == 0 ? Coord3{0.0, 1.0, 0.0} : normalized(chance.in({1.0, 1.0, 1.0}));
    t_world_room = TransformMatrix::translation(chance.in({20.0, 3.0, 20.0})) *
                   TransformMatrix::rotation(axis, chance.between(0.0, 6.0));
  }

  void addOpening(Chance& chance) {
    Opening opening{chance.oneOf(3), 0.0, chance.in(half), chance.in(half)};
    opening.wall = (chance.oneOf(2) == 0 ? -1.0 : 1.0) * component(half, opening.axis);
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 low = opening.low.glm();
      glm::dvec3 high = opening.high.glm();
      if (low[i] > high[i]) std::swap(low[i], high[i]);
      if (i == static_cast<int>(opening.axis)) low[i] = high[i] = opening.wall;
      opening.low = Coord3(low);
      opening.high = Coord3(high);
    }
    openings.push_back(opening);
  }

  PlacedEnclosure enclosure() const {
    PlacedEnclosure placed{{{}, 2.0 * half, {}}, t_world_room};
    for (const Opening& o : openings) {
      const int u = static_cast<int>(o.axis + 1) % 3;
      glm::dvec3 beside_low = o.low.glm();
      glm::dvec3 beside_high = o.high.glm();
      beside_low[u] = o.high.glm()[u];
      beside_high[u] = o.low.glm()[u];
      placed.enclosure.openings.push_back({o.low, Coord3(beside_low), o.high, Coord3(beside_high)});
    }
    return placed;
  }

  bool holds(const Coord3& p) const {
    return std::abs(p.x) <= half.x && std::abs(p.y) <= half.y && std::abs(p.z) <= half.z;
  }

  /// Whether the way from within to a point passes no wall; both in the room's frame.
  bool shows(const Coord3& eye, const Coord3& point) const {
    if (holds(point)) return true;
    double leaves = 1.0;
    std::size_t through = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = component(point, i) - component(eye, i);
      const double wall = std::copysign(component(half, i), along);
      const double at = along == 0.0 ? 1.0 : (wall - component(eye, i)) / along;
      if (at < leaves) {
        leaves = at;
        through = i;
      }
    }
    const Coord3 at = eye + leaves * (point - eye);
    const double wall = std::copysign(component(half, through), component(point - eye, through));
    return std::any_of(openings.begin(), openings.end(), [&](const Opening& o) {
      if (o.axis != through || o.wall != wall) return false;
      for (std::size_t i = 0; i < 3; ++i)
        if (i != through &&
            (component(at, i) < component(o.low, i) || component(at, i) > component(o.high, i)))
          return false;
      return true;
    });
  }

  /// In the room's frame: anywhere, just off a wall, or in line with an opening's edge.
  Coord3 anyEye(Chance& chance) const {
    glm::dvec3 eye = chance.in(1.1 * half).glm();
    if (chance.oneOf(3) == 0) {
      const int axis = static_cast<int>(chance.oneOf(3));
      const double off = chance.magnitude(-9.0, -1.0);
      eye[axis] = std::copysign(half.glm()[axis] - off, eye[axis]);
    }
    if (!openings.empty() && chance.oneOf(3) == 0) {
      const Opening& o = openings[chance.oneOf(openings.size())];
      const int axis = static_cast<int>(o.axis + 1) % 3;
      eye[axis] = o.low.glm()[axis];
      if (chance.oneOf(2) == 0) eye[static_cast<int>(o.axis)] = o.wall;
    }
    return Coord3(eye);
  }
};

struct TestView {
  TransformMatrix t_world_eye;
  double near_m;
};

TestView anyView(Chance& chance, const TestRoom& room) {
  return {room.t_world_room * TransformMatrix::translation(room.anyEye(chance)),
          chance.magnitude(-9.0, -1.0)};
}

void add(Enclosures& enclosures, const TestView& view) {
  enclosures.addView(view.t_world_eye, FieldOfView{1.0, 1.0, 1.0, 1.0}, view.near_m, 1e-3);
}

struct TestBox {
  Coord3 middle;
  Coord3 half;

  TestBox(Chance& chance, const TestRoom& room)
      : middle(room.t_world_room.point(chance.in(3.0 * room.half))), half(chance.in({1.0, 1.0, 1.0})) {
    half = Coord3(glm::abs(half.glm()) * chance.magnitude(-2.0, 0.3));
  }
};

TEST(Enclosures, HideNothingThatIsInTheRoomOrSeenThroughAnOpening) {
  Chance chance(1);
  int hidden = 0;
  int shown = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    const TestRoom room(chance);
    const TransformMatrix t_room_world = room.t_world_room.rigidInverse();
    Enclosures enclosures({room.enclosure()});
    for (int eyes = 0; eyes < 4; ++eyes) {
      enclosures.begin();
      const TestView view = anyView(chance, room);
      const Coord3 eye = t_room_world.point(view.t_world_eye.origin());
      add(enclosures, view);
      for (int boxes = 0; boxes < 10; ++boxes) {
        const TestBox box(chance, room);
        const bool hides = enclosures.hide(box.middle, box.half);
        ++(hides ? hidden : shown);
        if (!hides) continue;
        ASSERT_TRUE(room.holds(eye)) << scene << ": from outside nothing is known of what walls hide";
        for (int i = 0; i < 20; ++i) {
          const Coord3 point = t_room_world.point(box.middle + chance.in(box.half));
          ASSERT_FALSE(room.shows(eye, point)) << scene;
        }
      }
    }
  }
  EXPECT_GT(hidden, 20'000) << "or it is of no use";
  EXPECT_GT(shown, 20'000);
}

TEST(Enclosures, HideWhatIsHiddenFromAllViewsOnly) {
  Chance chance(2);
  int differing = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    const TestRoom here(chance);
    const TestRoom there(chance);
    Enclosures enclosures({here.enclosure(), there.enclosure()});
    const std::array views = {anyView(chance, here), anyView(chance, chance.oneOf(2) == 0 ? here : there)};
    const TestBox box(chance, here);
    std::array<bool, 2> alone{};
    for (std::size_t i = 0; i < 2; ++i) {
      enclosures.begin();
      add(enclosures, views[i]);
      alone[i] = enclosures.hide(box.middle, box.half);
    }
    enclosures.begin();
    add(enclosures, views[0]);
    add(enclosures, views[1]);
    ASSERT_EQ(enclosures.hide(box.middle, box.half), alone[0] && alone[1]) << scene;
    differing += alone[0] != alone[1] ? 1 : 0;
  }
  EXPECT_GT(differing, 300);
}

TEST(Enclosures, HideNothingWithoutAViewOrARoom) {
  const Coord3 far_away{1000.0, 0.0, 0.0};
  Enclosures none({});
  none.begin();
  EXPECT_FALSE(none.hide(far_away, {1.0, 1.0, 1.0})) << "no view";
  add(none, {{}, 0.01});
  EXPECT_FALSE(none.hide(far_away, {1.0, 1.0, 1.0})) << "no room";
  Enclosures closed({{{{}, {4.0, 3.0, 4.0}, {}}, {}}});
  closed.begin();
  add(closed, {{}, 0.01});
  EXPECT_TRUE(closed.hide(far_away, {1.0, 1.0, 1.0})) << "a room without openings hides all";
  EXPECT_FALSE(closed.hide({2.5, 0.0, 0.0}, {0.6, 0.1, 0.1})) << "but what comes through its wall";
  closed.begin();
  add(closed, {TransformMatrix::translation({1.99, 0.0, 0.0}), 0.01});
  EXPECT_FALSE(closed.hide(far_away, {1.0, 1.0, 1.0}))
      << "an eye so near to a wall that the near plane cuts it off sees through it";
}

}  // namespace
}  // namespace coherency
