#pragma once

#include <cstdint>
#include <vector>

#include "common/math/Frustum.h"
#include "render_client/compile/CompiledScene.h"

namespace coherency {

/// Leaves out what walls hide: from inside a room, what is neither in it nor seen through one of its openings
/// (Airey, Rohlf & Brooks, "Towards image realism with interactive update rates in complex virtual building
/// environments", 1990; one step of it). As with ViewPyramid, what is said to be hidden shows in no pixel.
class Enclosures {
 public:
  struct Room {
    Coord3 middle;
    Coord3 axis[3];  ///< unit length
    double half[3];  ///< m
    std::vector<std::vector<Coord3>> openings;
  };

  explicit Enclosures(const std::vector<PlacedEnclosure>& enclosures);

  void begin() { view_count_ = 0; }
  /// `pixel`: of the view's picture, as a tangent.
  void addView(const TransformMatrix& t_world_eye, const FieldOfView& view, double near_m, double pixel);
  /// Whether nothing in a box, world's axes, m, is seen in any of the views. Never where there are none.
  bool hide(const Coord3& middle, const Coord3& half_extent) const;
  /// The room that a place is in; null where it is in none.
  const Room* around(const Coord3& place) const;
  /// Whether any of a box may be in a room, or in its walls.
  static bool reaches(const Room& room, const Coord3& middle, const Coord3& half_extent);

 private:
  /// What an eye in a room sees of the outside: half spaces through the eye, in groups of one opening each.
  struct View {
    const Room* room = nullptr;  ///< none: the eye is in none, or too near to a wall; nothing is hidden
    Coord3 eye;
    double margin = 0.0;  ///< of a distance
    std::vector<Coord3> inward;
    std::vector<std::size_t> ends;
  };

  static bool holds(const Room& room, const Coord3& point, double off_walls);
  static bool hides(const View& view, const Coord3& middle, const Coord3& half_extent);
  static bool addOpening(View& view, const std::vector<Coord3>& opening);

  std::vector<Room> rooms_;
  std::vector<View> views_;  ///< the first of them are the frame's
  std::size_t view_count_ = 0;
};

}  // namespace coherency
