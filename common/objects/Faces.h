#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/body/Assemble.h"
#include "common/scene/Polyhedron.h"

namespace coherency {

/// An upright rectangle in a plane parallel to xy: an opening, a pane, a board. Metres.
struct Outline {
  double left, right, bottom, top;

  static Outline centred(double width, double height) {
    return {-width / 2, width / 2, -height / 2, height / 2};
  }
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  Coord3 middle(double z) const { return {0.5 * (left + right), 0.5 * (bottom + top), z}; }
  bool standsOnFloor() const { return bottom == 0.0; }
  /// Smaller by so much on each side; one that stands on the floor goes on doing so.
  Outline inset(double by) const {
    return {left + by, right - by, standsOnFloor() ? bottom : bottom + by, top - by};
  }
};

/// Sides of a cuboid that are not drawn, as nobody sees them: they are against a wall, the floor or another
/// part. Left is -x, bottom -y, back -z.
enum Unseen : unsigned { kNoLeft = 1, kNoRight = 2, kNoBottom = 4, kNoTop = 8, kNoBack = 16, kNoFront = 32 };

/// Axis-parallel; metres.
struct Cuboid {
  Coord3 size;
  Coord3 centre;
  unsigned hidden = 0;  ///< of Unseen
};

/// `first` and others like it, each `step` from the one before: slats, fins, keys.
std::vector<Cuboid> row(const Cuboid& first, const Coord3& step, int count);

/// Plane faces, gathered to become the shape of one polyhedron. Each has vertices of its own.
class Faces {
 public:
  /// A convex face, counter-clockwise as seen from outside.
  void add(const std::vector<Coord3>& corners);
  void add(const Cuboid& cuboid);
  /// All of `others`, moved by `t_this_others`, which must not mirror.
  void add(const Faces& others, const TransformMatrix& t_this_others);

  /// A rectangle seen from +z, with rectangular holes that do not touch one another. No edge ends in the
  /// middle of another, so that no light shines through joints.
  void addSheet(const Outline& outline, double z, const std::vector<Outline>& holes = {});
  /// The band between two outlines, which may lie in different planes, seen from where `outer` surrounds
  /// `inner`: a flat frame, a bevel, or, where both are the same outline, the inside (z_inner the lower) or
  /// the outside of a tube. Four faces; three where the outlines stand on the floor.
  void addFrame(const Outline& outer, double z_outer, const Outline& inner, double z_inner);
  /// A rectangle about `middle`, turned to the left, seen from +z.
  void addStroke(const Coord3& middle, double width, double height, double turn = 0.0);
  /// A regular polygon about `middle`, seen from +z.
  void addDisc(const Coord3& middle, double radius, int sides);
  /// Everything so far once more, as a mirror in the plane `z` shows it.
  void mirror(double z);

  void shape(Polyhedron& polyhedron) const { polyhedron.setShape(vertices_, faces_); }

 private:
  std::vector<Coord3> vertices_;
  std::vector<std::vector<std::uint32_t>> faces_;
};

/// Boards around `inner` that stand out from z = 0 by `proud`: the frame of a picture on a wall.
Faces pictureFrame(const Outline& inner, double board, double proud);

/// Shapes, names and paints `part`, a data member of `owner`'s class, and makes it a member of `owner`.
void assembleFaces(VRObject& owner, Polyhedron& part, std::string name, const Material& material,
                   const Faces& faces, const Coord3& at = {});
/// A rectangle in the plane `z`.
void assembleSheet(VRObject& owner, Rectangle& part, std::string name, const Material& material,
                   const Outline& outline, double z);
/// Several boxes of one material as one object.
void assembleBoxes(VRObject& owner, Polyhedron& part, std::string name, const Material& material,
                   const std::vector<Cuboid>& boxes);

}  // namespace coherency
