// The rooms of the scenes that are shipped: what their walls hide makes no difference to any pixel, and they
// let nothing through but at the openings that they declare.

#include <cmath>
#include <limits>
#include <random>

#include "common/body/Posture.h"
#include "common/config/SceneFile.h"
#include "common/math/FixedPoint.h"
#include "common/motion/SampleGate.h"
#include "common/scene/Enclosure.h"
#include "render_client/draw/EyeViews.h"
#include "tests/render/SceneRays.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

struct Room {
  Enclosure enclosure;
  TransformMatrix t_world_room;
  const VRObject* shell;

  /// `share` of its half sizes, from its middle.
  Coord3 inWorld(const Coord3& share) const {
    return t_world_room.point(enclosure.centre + Coord3(0.5 * enclosure.size.glm() * share.glm()));
  }
  /// In its axes, from its middle, m.
  Coord3 inRoom(const Coord3& p_world) const {
    return t_world_room.rigidInverse().point(p_world) - enclosure.centre;
  }
};

std::vector<Room> roomsOf(const VRObject& root) {
  std::vector<Room> rooms;
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    if (const auto* enclosure = object.attribute<Enclosure>(); enclosure != nullptr)
      rooms.push_back({*enclosure, t_world_object, &object});
  });
  return rooms;
}

class Rooms : public DrawingTest {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Coord3 within(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  Coord3 direction() {
    Coord3 v;
    do v = within(1.0);
    while (norm(v) > 1.0 || norm(v) < 1e-3);
    return normalized(v);
  }
  const Room& anyOf(const std::vector<Room>& rooms) {
    return rooms[std::uniform_int_distribution<std::size_t>(0, rooms.size() - 1)(engine_)];
  }

  /// The vehicles anywhere in the rooms, doors open, closed or between.
  void shuffle(Scene& scene, const std::vector<Room>& rooms) {
    WorldState state = scene.initialState();
    for (Vehicle* vehicle : {&state.master, &state.robot}) {
      const Coord3 at = anyOf(rooms).inWorld(within(1.0));
      vehicle->base = basePose(at.x, at.z, between(0.0, kTurn));
    }
    for (std::int32_t& door : state.doors) door = unitsFromRatio(std::clamp(between(-0.5, 1.5), 0.0, 1.0));
    const auto neutral = neutralPosture(Rig{});
    MasterReading reading;
    reading.si = neutral;
    scene.apply(state, SampleGate(neutral).admit(reading, 1, 0));
  }

  /// Narrow, at a joint between two of a room's walls or a wall and the ceiling or floor.
  EyeView atAJoint(const std::vector<Room>& rooms, int width, int height) {
    const Room& room = anyOf(rooms);
    const Coord3 eye = room.inWorld(within(0.95));
    glm::dvec3 joint = within(1.0).glm();
    const int along = std::uniform_int_distribution(0, 2)(engine_);
    for (const int axis : {(along + 1) % 3, (along + 2) % 3}) joint[axis] = std::copysign(1.0, joint[axis]);
    const Coord3 way = room.inWorld(Coord3(joint)) - eye;
    EyeView view = lookingAhead({}, width, height, std::pow(10.0, between(-4.0, -1.0)));
    view.t_world_eye =
        TransformMatrix::translation(eye) *
        rotation(YawPitchRoll{std::atan2(-way.x, -way.z), std::asin(way.y / norm(way)), between(0.0, kTurn)});
    return view;
  }

  /// In a room or a little outside; in one of three cases level, as heads are.
  EyeView anyView(const std::vector<Room>& rooms, int width, int height) {
    EyeView view = lookingAhead({}, width, height);
    const Coord3 axis = between(0.0, 3.0) < 1.0 ? Coord3{0.0, 1.0, 0.0} : direction();
    view.t_world_eye = TransformMatrix::translation(anyOf(rooms).inWorld(within(1.05))) *
                       TransformMatrix::rotation(axis, between(0.0, kTurn));
    const auto side = [&] { return std::tan(between(2.0, 70.0) * kTurn / 360.0); };
    view.view = {side(), side(), side(), side()};
    return view;
  }

 private:
  std::mt19937_64 engine_{11};
};

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr BakeSettings kQuick{.rays = 8, .tolerance = 1.0, .finest = 1.0};

/// An object that shows in one picture and not in the other.
std::string missed(Renderer& clipped, Renderer& whole, const EyeView& view) {
  const IdImage without = whole.drawIds({&view, 1});
  const IdImage with = clipped.drawIds({&view, 1});
  for (std::size_t p = 0; p < without.ids.size(); ++p)
    if (with.ids[p] != without.ids[p] && without.ids[p] != 0)
      return without.objects[without.ids[p] - 1]->path();
  return "light or shadow";
}

TEST_F(Rooms, HideNothingThatShowsInAPicture) {
  constexpr int kEyes = 2000;
  Scene scene(readScene("laboratory", COHERENCY_CONFIGS "/scenes"), {});
  const std::vector<Room> rooms = roomsOf(scene);
  ASSERT_EQ(rooms.size(), 4U);
  RendererSettings settings{.samples = 1, .shadow_resolution = 128, .bake = kQuick};
  Renderer clipped(scene, kWidth, kHeight, settings);
  settings.clip = false;
  Renderer whole(scene, kWidth, kHeight, settings);
  double left_out = 0.0;
  for (int i = 0; i < kEyes; ++i) {
    shuffle(scene, rooms);
    EyeView view = i % 2 == 0 ? anyView(rooms, kWidth, kHeight) : atAJoint(rooms, kWidth, kHeight);
    view.t_world_vehicle = vehicle(scene, Mode::Operator);
    view.t_world_other_vehicle = otherVehicle(scene, Mode::Operator);
    ASSERT_TRUE(sameDrawn(clipped, whole, {&view, 1}))
        << "eye " << i << " misses " << missed(clipped, whole, view);
    const auto drawn = [](const FrameCounts& counts) {
      return static_cast<double>(counts.moving + counts.fixed_plain + counts.fixed_shaded);
    };
    left_out += 1.0 - drawn(clipped.counts()) / drawn(whole.counts());
  }
  EXPECT_GT(left_out / kEyes, 0.5) << "or it is of no use";
}

/// How far it is from a point in the room to its box along a direction, m.
double toWall(const Room& room, const Coord3& from, const Coord3& direction) {
  const Coord3 start = room.inRoom(from);
  const Coord3 along = room.t_world_room.rigidInverse().vector(direction);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double wall = std::copysign(0.5 * room.enclosure.size.glm()[i], along.glm()[i]);
    if (along.glm()[i] != 0.0) least = std::min(least, (wall - start.glm()[i]) / along.glm()[i]);
  }
  return least;
}

/// Or as good as: rays are that exact.
bool leavesByAnOpening(const Room& room, const Coord3& from, const Coord3& direction) {
  constexpr double kRounding = 1e-4;  // m
  const Coord3 meets = room.inRoom(from + toWall(room, from, direction) * direction) + room.enclosure.centre;
  for (const std::vector<Coord3>& opening : room.enclosure.openings) {
    const Coord3 normal = normalized(cross(opening[1] - opening[0], opening[2] - opening[0]));
    bool inside = std::abs(dot(meets - opening[0], normal)) < kRounding;
    for (std::size_t c = 0; c < opening.size(); ++c) {
      const Coord3 edge = normalized(opening[(c + 1) % opening.size()] - opening[c]);
      inside = inside && dot(cross(edge, meets - opening[c]), normal) > -kRounding;
    }
    if (inside) return true;
  }
  return false;
}

/// The shell, and the floors that are put below it.
std::vector<const VRObject*> wallsOf(const Room& room) {
  std::vector<const VRObject*> walls{room.shell};
  for (const VRObject* beside : room.shell->parent()->members())
    if (beside->name() == "floor") walls.push_back(beside);
  return walls;
}

TEST_F(Rooms, LetNothingThroughButAtTheirOpenings) {
  constexpr int kRays = 200'000;
  constexpr double kInWalls = 0.012;  // m, as cull/Enclosures.cpp has it
  for (const char* name : {"laboratory", "corridor", "look"}) {
    const Scene scene(readScene(name, COHERENCY_CONFIGS "/scenes"), {});
    const std::vector<Room> rooms = roomsOf(scene);
    ASSERT_FALSE(rooms.empty()) << name;
    for (const Room& room : rooms) {
      const SceneRays rays(wallsOf(room));
      const Coord3 reach = 0.5 * room.enclosure.size + Coord3{kInWalls, kInWalls, kInWalls};
      for (int i = 0; i < kRays; ++i) {
        const Coord3 from = room.inWorld(within(0.9999));
        const Coord3 way = direction();
        if (leavesByAnOpening(room, from, way)) continue;
        const SceneRays::Met met = rays.first(from, way);
        ASSERT_NE(met.object, nullptr) << room.shell->path() << " lets ray " << i << " through";
        const Coord3 at = room.inRoom(from + met.distance * way);
        ASSERT_TRUE(std::abs(at.x) < reach.x && std::abs(at.y) < reach.y && std::abs(at.z) < reach.z)
            << room.shell->path() << ": from its middle at " << at.x << ", " << at.y << ", " << at.z << ", "
            << met.object->path();
      }
    }
  }
}

TEST_F(Rooms, IdsAreOfWhatRaysMeet) {
  constexpr int kEyes = 30;
  Scene scene(readScene("laboratory", COHERENCY_CONFIGS "/scenes"), {});
  const std::vector<Room> rooms = roomsOf(scene);
  Renderer renderer(scene, kWidth, kHeight, {.bake = kQuick});
  int differing = 0;
  for (int i = 0; i < kEyes; ++i) {
    shuffle(scene, rooms);
    const EyeView view = anyView(rooms, kWidth, kHeight);
    const IdImage image = renderer.drawIds({&view, 1});
    const SceneRays rays({&scene});
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double right =
            (x + 0.5) / kWidth * (view.view.tan_left + view.view.tan_right) - view.view.tan_left;
        const double up = view.view.tan_up - (y + 0.5) / kHeight * (view.view.tan_down + view.view.tan_up);
        const Coord3 ahead{right, up, -1.0};
        const SceneRays::Met met = rays.first(
            view.t_world_eye.origin(), view.t_world_eye.vector(normalized(ahead)), view.near_m * norm(ahead));
        const std::uint32_t id = image.ids[static_cast<std::size_t>(y * kWidth + x)];
        differing += (id == 0 ? nullptr : image.objects[id - 1]) != met.object ? 1 : 0;
      }
  }
  EXPECT_LT(differing, kEyes * kWidth * kHeight / 1000)
      << "but where edges are within rounding of a pixel's centre";
}

}  // namespace
}  // namespace coherency
