#include "render_client/compile/LightBaker.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render_client/compile/Directions.h"
#include "render_client/compile/Parallel.h"

namespace coherency {
namespace {

constexpr float kLift = 0.005F;      ///< m; what is pasted on a surface, such as a sheet of paper, is thinner
constexpr float kInset = 0.02F;      ///< m, from a border
constexpr float kLampRadius = 0.4F;  ///< m, of a room's: as wide panels soften shadows
constexpr float kOfReach = 0.05F;    ///< of a lamp's reach, where that is less
constexpr float kLampSkin = 0.02F;   ///< m, about a lamp, in which nothing is in its way
constexpr float kPlaceRadius = 0.25F;  ///< m
constexpr std::size_t kPlaceRays = 32;
constexpr float kAmbientReach = 1.2F;  ///< m; what is further away keeps no ambient light away
constexpr float kGap = 0.06F;  ///< m; what has something as near as this to nearly all sides is not seen
constexpr float kOverhead =
    1.5F;  ///< m; below something fixed as near as this nothing that moves casts a shadow
constexpr float kDim = 0.004F;           ///< a lamp that would bring less is not looked for
constexpr std::size_t kLampLook = 3;     ///< rays that find out whether a place is in a lamp's half shadow
constexpr std::size_t kAmbientLook = 8;  ///< rays that find out whether anything is near

glm::vec3 vec3(const Coord3& v) {
  return glm::vec3(v.glm());
}

RayScene rayScene(const std::vector<Occluder>& occluders) {
  std::vector<RayTriangle> triangles;
  triangles.reserve(occluders.size());
  for (const Occluder& o : occluders) triangles.push_back(o.corners);
  return RayScene(triangles);
}

glm::vec3 lifted(const SurfacePoint& point) {
  const float length = glm::length(point.inside);
  const glm::vec3 inset =
      length > 0.0F ? point.inside * (std::min(kInset, 0.2F * length) / length) : point.inside;
  return point.position + inset + kLift * point.normal;
}

}  // namespace

LightBaker::LightBaker(const std::vector<Occluder>& occluders, const Illumination& illumination, int rays)
    : rays_(rayScene(occluders)),
      ray_count_(std::max<std::size_t>(static_cast<std::size_t>(std::max(rays, 0)), kAmbientLook)),
      sky_(vec3(illumination.ambient.sky)),
      ground_(vec3(illumination.ambient.ground)),
      directions_(cosineDirections(ray_count_)) {
  for (const glm::vec2& p : discPoints(kPlaceRays))
    around_.emplace_back(kPlaceRadius * p.x, 0.0F, kPlaceRadius * p.y);
  for (const Light& light : illumination.lamps) addLamp(light);
  throwBack(occluders);
}

void LightBaker::addLamp(const Light& light) {
  Lamp lamp{vec3(light.position), vec3(light.colour * light.intensity), static_cast<float>(light.reach), {}};
  for (const glm::vec2& p : discPoints(std::max({ray_count_ / 2, kLampLook, kPlaceRays}))) {
    const float radius = std::min(kLampRadius, kOfReach * lamp.reach);
    const glm::vec3 at = lamp.position + radius * glm::vec3(p.x, 0.0F, p.y);
    lamp.disc.push_back(rays_.blocked(lamp.position, at) ? lamp.position : at);
  }
  lamps_.push_back(std::move(lamp));
}

/// One ray a lamp will do: what is thrown back is averaged over many triangles. Of the ambient half is taken
/// to reach them.
void LightBaker::throwBack(const std::vector<Occluder>& occluders) {
  radiosity_.resize(occluders.size());
  parallelFor(occluders.size(), [&](std::size_t i) {
    const RayTriangle& t = occluders[i].corners;
    const glm::vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
    const float length = glm::length(across);
    if (!(length > 0.0F)) return;
    const SurfacePoint middle{(t[0] + t[1] + t[2]) / 3.0F, across / length};
    const glm::vec3 ambient = glm::mix(ground_, sky_, 0.5F + 0.5F * middle.normal.y);
    radiosity_[i] = occluders[i].colour * (direct(lifted(middle), middle.normal, 1).light + 0.5F * ambient);
  });
}

float LightBaker::visible(const Lamp& lamp, const glm::vec3& from, std::size_t rays) const {
  std::size_t free = 0;
  std::size_t sent = 0;
  std::int32_t blocker = RayScene::kNoBlocker;
  for (; sent < rays; ++sent) {
    if (sent == kLampLook && (free == 0 || free == sent)) break;
    const glm::vec3 to = lamp.disc[sent] - from;
    const float distance = glm::length(to);
    if (distance <= kLampSkin || !rays_.blocked(from, from + to * (1.0F - kLampSkin / distance), blocker))
      ++free;
  }
  return static_cast<float>(free) / static_cast<float>(sent);
}

LightBaker::Direct LightBaker::direct(const glm::vec3& from, const glm::vec3& normal,
                                      std::size_t rays) const {
  Direct sum;
  for (const Lamp& lamp : lamps_) {
    const glm::vec3 to = lamp.position - from;
    const float square = glm::dot(to, to);
    const float facing = glm::dot(to, normal);
    if (facing <= 0.0F || square >= lamp.reach * lamp.reach) continue;
    const glm::vec3 open = lamp.colour * (falloff(square, lamp.reach) * facing / std::sqrt(square));
    if (brightness(open) < kDim) continue;
    const glm::vec3 light = open * visible(lamp, from, rays);
    sum.light += light;
    if (to.y > 0.0F) sum.overhead += brightness(light) * (to.y / std::sqrt(square));
  }
  return sum;
}

/// Of ambient and bounce alone; false where the place is buried.
bool LightBaker::gather(const glm::vec3& from, const glm::vec3& normal, glm::vec3& irradiance) const {
  const glm::mat3 frame = frameAbout(normal);
  glm::vec3 sum(0.0F);
  std::size_t sent = 0;
  std::size_t met = 0;
  std::size_t hidden = 0;
  std::size_t behind = 0;
  for (; sent < directions_.size(); ++sent) {
    if (sent == kAmbientLook && met == 0) break;
    const glm::vec3 direction = frame * directions_[sent];
    RayHit hit;
    if (!rays_.nearest(from, direction, kAmbientReach, hit)) {
      sum += ambientFrom(direction);
      continue;
    }
    ++met;
    if (hit.distance < kGap) ++hidden;
    if (hit.from_behind) {
      ++behind;
      continue;
    }
    const float away = hit.distance / kAmbientReach;
    sum += glm::mix(radiosity_[hit.triangle], ambientFrom(direction), away * away);
  }
  irradiance = sum / static_cast<float>(sent);
  return 2 * behind <= sent && 8 * hidden <= 7 * sent;
}

SurfaceLight LightBaker::light(const SurfacePoint& point) const {
  const glm::vec3 from = lifted(point);
  SurfaceLight result;
  result.buried = !gather(from, point.normal, result.light);
  if (result.buried) return result;
  const float of_ambient = kAmbientShade * brightness(result.light);
  const Direct lamps = direct(from, point.normal, std::max(ray_count_ / 2, kLampLook));
  result.light += lamps.light;
  const float overhead = lamps.overhead + of_ambient;
  const glm::vec3 above = kOverhead * glm::vec3(-kShadowLean.x, 1.0F, -kShadowLean.y);
  if (point.normal.y > 0.0F && overhead > 0.0F && !rays_.blocked(from, from + above))
    result.shade = point.normal.y * overhead / std::max(brightness(result.light), overhead);
  return result;
}

float LightBaker::inSight(std::size_t lamp, const glm::vec3& place) const {
  if (rays_.empty()) return 1.0F;
  std::size_t free = 0;
  std::int32_t blocker = RayScene::kNoBlocker;
  const std::vector<glm::vec3>& disc = lamps_[lamp].disc;
  for (std::size_t i = 0; i < kPlaceRays; ++i) {
    const glm::vec3 from =
        place + around_[i * 5 % kPlaceRays];  // paired with other points of the lamp's disc
    const glm::vec3 to = disc[i] - from;
    if (!rays_.blocked(from, from + to * (1.0F - kLampSkin / std::max(glm::length(to), kLampSkin)), blocker))
      ++free;
  }
  return static_cast<float>(free) / static_cast<float>(kPlaceRays);
}

}  // namespace coherency
