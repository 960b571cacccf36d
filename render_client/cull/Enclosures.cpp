#include "render_client/cull/Enclosures.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace coherency {
namespace {

constexpr double kPixels = 1.0;     ///< more is taken for seen through an opening than is
constexpr double kInWalls = 0.012;  ///< m: floors and ceilings go on a little under and over the walls

Coord3 axisOf(const TransformMatrix& t_world_object, int axis) {
  return t_world_object.vector({axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
}

double reach(const Coord3& direction, const Coord3& half_extent) {
  return dot(Coord3(glm::abs(direction.glm())), half_extent);
}

/// How far from the eye what is drawn may be cut off by the near plane, m.
double cutOff(const FieldOfView& view, double near_m) {
  const double aside = std::max(std::abs(view.tan_left), std::abs(view.tan_right));
  const double above = std::max(std::abs(view.tan_down), std::abs(view.tan_up));
  return near_m * std::sqrt(1.0 + aside * aside + above * above);
}

}  // namespace

Enclosures::Enclosures(const std::vector<PlacedEnclosure>& enclosures) {
  for (const auto& [enclosure, t_world_object] : enclosures) {
    Room room;
    room.middle = t_world_object.point(enclosure.centre);
    for (int i = 0; i < 3; ++i) {
      room.axis[i] = axisOf(t_world_object, i);
      room.half[i] = 0.5 * enclosure.size.glm()[i];
    }
    room.openings = enclosure.openings;
    for (std::vector<Coord3>& opening : room.openings)
      for (Coord3& corner : opening) corner = t_world_object.point(corner);
    rooms_.push_back(std::move(room));
  }
}

bool Enclosures::holds(const Room& room, const Coord3& point, double off_walls) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(dot(point - room.middle, room.axis[i])) > room.half[i] - off_walls) return false;
  return true;
}

const Enclosures::Room* Enclosures::around(const Coord3& place) const {
  const auto room =
      std::find_if(rooms_.begin(), rooms_.end(), [&](const Room& each) { return holds(each, place, 0.0); });
  return room == rooms_.end() ? nullptr : &*room;
}

void Enclosures::addView(const TransformMatrix& t_world_eye, const FieldOfView& view, double near_m,
                         double pixel) {
  if (view_count_ == views_.size()) views_.emplace_back();
  View& added = views_[view_count_++];
  added.eye = t_world_eye.origin();
  added.margin = kPixels * pixel;
  added.inward.clear();
  added.ends.clear();
  const auto around = std::find_if(rooms_.begin(), rooms_.end(), [&](const Room& room) {
    return holds(room, added.eye, 2.0 * cutOff(view, near_m));
  });
  added.room = around == rooms_.end() ? nullptr : &*around;
  if (added.room == nullptr) return;
  for (const std::vector<Coord3>& opening : added.room->openings)
    if (!addOpening(added, opening)) added.room = nullptr;
}

/// False where the eye is in line with an edge.
bool Enclosures::addOpening(View& view, const std::vector<Coord3>& opening) {
  Coord3 middle;
  for (const Coord3& corner : opening) middle += (corner - view.eye) / static_cast<double>(opening.size());
  for (std::size_t i = 0; i < opening.size(); ++i) {
    const Coord3 a = opening[i] - view.eye;
    const Coord3 b = opening[(i + 1) % opening.size()] - view.eye;
    const Coord3 normal = cross(b, a);
    const double length = norm(normal);
    if (!(length > 1e-6 * norm(a) * norm(b))) return false;
    view.inward.push_back((dot(normal, middle) < 0.0 ? -1.0 : 1.0) * normal / length);
  }
  view.ends.push_back(view.inward.size());
  return true;
}

bool Enclosures::reaches(const Room& room, const Coord3& middle, const Coord3& half_extent) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(dot(middle - room.middle, room.axis[i])) - reach(room.axis[i], half_extent) >
        room.half[i] + kInWalls)
      return false;
  return true;
}

bool Enclosures::hides(const View& view, const Coord3& middle, const Coord3& half_extent) {
  if (view.room == nullptr || reaches(*view.room, middle, half_extent)) return false;
  const Coord3 from_eye = middle - view.eye;
  const double margin = view.margin * (norm(from_eye) + norm(half_extent));
  std::size_t first = 0;
  for (const std::size_t end : view.ends) {
    bool beside = false;
    for (std::size_t i = first; i < end && !beside; ++i)
      beside = dot(from_eye, view.inward[i]) + reach(view.inward[i], half_extent) < -margin;
    if (!beside) return false;
    first = end;
  }
  return true;
}

bool Enclosures::hide(const Coord3& middle, const Coord3& half_extent) const {
  for (std::size_t i = 0; i < view_count_; ++i)
    if (!hides(views_[i], middle, half_extent)) return false;
  return view_count_ > 0;
}

}  // namespace coherency
