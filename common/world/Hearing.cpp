#include "common/world/Hearing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "common/math/FixedPoint.h"
#include "common/scene/Senses.h"

namespace coherency {

namespace {

constexpr double kNearest = 0.1;  // m

const char* direction(double bearing_rad) {
  constexpr std::array<const char*, 8> kWords = {
      "ahead",  "ahead to the left",   "to the left",  "behind to the left",
      "behind", "behind to the right", "to the right", "ahead to the right"};
  const double eighths = bearing_rad / (kTurn / 8.0);
  return kWords[static_cast<std::size_t>(std::llround(eighths) + 8) % 8];
}

}  // namespace

std::vector<Heard> heardFrom(const VRObject& root, const TransformMatrix& t_world_ear, double threshold_db) {
  const TransformMatrix t_ear_world = t_world_ear.rigidInverse();
  std::vector<Heard> heard;
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    const auto* source = object.attribute<SoundSource>();
    if (source == nullptr) return;
    const Coord3 at = t_ear_world.point(t_world_object.origin());
    const double distance = norm(at);
    const double level = source->level_db - 20.0 * std::log10(std::max(distance, kNearest));
    if (level >= threshold_db) heard.push_back({source->what, level, distance, std::atan2(-at.x, -at.z)});
  });
  std::stable_sort(heard.begin(), heard.end(),
                   [](const Heard& a, const Heard& b) { return a.level_db > b.level_db; });
  return heard;
}

std::string describe(const std::vector<Heard>& heard) {
  if (heard.empty()) return "nothing";
  std::string text;
  for (const Heard& h : heard) {
    std::array<char, 64> where{};
    std::snprintf(where.data(), where.size(), " %.1f m %s (%.0f dB)", h.distance_m, direction(h.bearing_rad),
                  h.level_db);
    text += (text.empty() ? "" : ", ") + h.what + where.data();
  }
  return text;
}

}  // namespace coherency
