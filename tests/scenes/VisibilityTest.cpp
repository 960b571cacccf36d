// That the polygons of doors and windows, whose numbers are the paper's, are there to be seen: each of them
// from somewhere in the rooms.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/scene/Primitives.h"
#include "tests/scenes/Support.h"

namespace coherency {
namespace {

using namespace scenes;

/// A face in the world.
struct Seen {
  const VRObject* owner;
  std::size_t index;  ///< of the face in its object
  std::vector<Coord3> corners;
  Coord3 normal;
};

std::vector<Seen> facesOf(const VRObject& root, const TransformMatrix& t_world_root) {
  std::vector<Seen> all;
  forEachObject(root, t_world_root, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    if (object.faces() == nullptr) return;
    for (std::size_t f = 0; f < object.faces()->faces.size(); ++f) {
      std::vector<Coord3> corners;
      for (const std::uint32_t i : object.faces()->faces[f])
        corners.push_back(t_world_object.point(object.faces()->vertices[i]));
      Coord3 area;
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
      all.push_back({&object, f, corners, normalized(area)});
    }
  });
  return all;
}

/// Those that could be in the way.
std::vector<Seen> facesNear(const VRObject& root, const Coord3& point) {
  constexpr double kNear = 3.0;  // m
  std::vector<Seen> near;
  for (Seen& face : facesOf(root, {})) {
    double extent = 0.0;
    for (const Coord3& c : face.corners) extent = std::max(extent, norm(c - face.corners[0]));
    if (norm(face.corners[0] - point) < kNear + extent) near.push_back(std::move(face));
  }
  return near;
}

/// Whether the way from `eye` to `point` meets the front of a face before the point; backs are not drawn.
bool hides(const Seen& face, const Coord3& eye, const Coord3& point) {
  const Coord3 way = point - eye;
  const double towards = dot(way, face.normal);
  if (towards >= 0.0) return false;
  const double share = dot(face.corners[0] - eye, face.normal) / towards;
  if (share <= 0.0 || share >= 1.0 - 1e-6) return false;
  const Coord3 hit = eye + share * way;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Coord3& from = face.corners[i];
    if (dot(cross(face.corners[(i + 1) % face.corners.size()] - from, hit - from), face.normal) < 0.0)
      return false;
  }
  return true;
}

bool isSeen(const Seen& face, const std::vector<Coord3>& eyes, const std::vector<Seen>& all) {
  Coord3 middle;
  for (const Coord3& c : face.corners) middle += c / static_cast<double>(face.corners.size());
  std::vector<Coord3> points = {middle};
  for (const Coord3& c : face.corners) points.push_back(middle + 0.9 * (c - middle));
  for (const Coord3& eye : eyes)
    for (const Coord3& point : points) {
      if (dot(face.normal, eye - point) < 1e-3) continue;
      if (std::none_of(all.begin(), all.end(), [&](const Seen& other) { return hides(other, eye, point); }))
        return true;
    }
  return false;
}

/// Places to look from on both sides of a wall's opening, and in it, in the frame of what fills it.
std::vector<Coord3> eyesAround(const Extent& box) {
  constexpr double kInWall = -0.30;  // from here to the room side, one can be in the opening only
  std::vector<Coord3> eyes;
  for (const double z : {0.35, 1.0, -0.5, -1.2, -0.08, 0.04})
    for (const double y : {1.0, 0.05, 0.5, 1.6, 2.25})
      for (const double share : {0.5, 0.12, 0.88, -0.3, 1.3}) {
        const bool beside = share < 0.0 || share > 1.0 || y < box.low.y + 0.04 || y > box.high.y - 0.3;
        if (z > kInWall && z < 0.0 && beside) continue;
        eyes.push_back({box.low.x + share * (box.high.x - box.low.x), y, z});
      }
  return eyes;
}

/// Which of the faces of `thing` nobody sees however far the doors are open, as "object face".
std::vector<std::string> unseen(Scene& scene, const VRObject& thing) {
  std::vector<std::string> missing;
  std::vector<bool> found(thing.polygonCount(), false);
  WorldState state = scene.initialState();
  for (const double open : {0.0, 0.55, 1.0}) {
    for (std::int32_t& door : state.doors) door = static_cast<std::int32_t>(open * kDoorOpen);
    scene.apply(state, neutralSample(Rig{}));
    const TransformMatrix t_world_thing = thing.globalTransform();
    std::vector<Coord3> eyes = eyesAround(extentOf(thing, ""));
    for (Coord3& eye : eyes) eye = t_world_thing.point(eye);
    const std::vector<Seen> near = facesNear(scene, t_world_thing.point(extentOf(thing, "").middle()));
    const std::vector<Seen> own = facesOf(thing, t_world_thing);
    for (std::size_t i = 0; i < own.size(); ++i) {
      found[i] = found[i] || isSeen(own[i], eyes, near);
      if (open == 1.0 && !found[i])
        missing.push_back(own[i].owner->name() + " " + std::to_string(own[i].index));
    }
  }
  return missing;
}

TEST(Visibility, EveryPolygonOfADoorIsSeenFromSomewhere) {
  Scene scene(described("corridor"), Rig{});
  const VRObject* door = called(scene, "door").at(0);
  for (const std::string& face : unseen(scene, *door)) ADD_FAILURE() << door->path() << ": " << face;
}

TEST(Visibility, EveryPolygonOfAWindowIsSeenFromSomewhere) {
  Scene scene(described("corridor"), Rig{});
  const VRObject* window = called(scene, "window").at(0);
  for (const std::string& face : unseen(scene, *window)) ADD_FAILURE() << window->path() << ": " << face;
}

TEST(Visibility, WhatIsInsideAWallIsNotSeen) {
  Scene scene(described("corridor"), Rig{});
  VRObject* door = const_cast<VRObject*>(called(scene, "door").at(0));
  Box stone({0.04, 0.04, 0.04}, "stone");
  stone.setPosition(0.06, 1.0, -0.08);  // beside the opening
  door->addMember(&stone);
  EXPECT_EQ(unseen(scene, *door).size(), 6U);
}

}  // namespace
}  // namespace coherency
