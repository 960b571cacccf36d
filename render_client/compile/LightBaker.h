#pragma once

#include "render_client/compile/Illumination.h"
#include "render_client/compile/RayScene.h"

namespace coherency {

/// A place on a surface. Its light is taken 5 mm off it, and off a border a little towards the inside, where
/// it is certain on which side of the neighbouring surfaces it is.
struct SurfacePoint {
  glm::vec3 position;      ///< m, from the baker's origin
  glm::vec3 normal;        ///< unit length
  glm::vec3 inside{0.0F};  ///< on a border: towards the middle of the triangle; else next to nothing
};

struct SurfaceLight {
  glm::vec3 light{0.0F};  ///< irradiance; a white surface under 1 shows full brightness
  float shade = 0.0F;     ///< 0..1, share of it that something close above the place would keep away
  bool buried =
      false;  ///< in the inside of something or in a narrow gap: nobody sees it, and its light means nothing
};

/// What a ray may meet.
struct Occluder {
  RayTriangle corners;  ///< m, from the baker's origin
  glm::vec3 colour;     ///< linear RGB
};

/// Light that reaches places among things that never move: of all lamps, softened as from discs of 0.2 m
/// radius, with shadows; of the ambient, as far as nothing near keeps it away; and of one bounce: near
/// surfaces bring, in the ambient's place, what they throw back of their own light. Deterministic: the same
/// rays everywhere. Const: any number of threads may ask at once.
class LightBaker {
 public:
  /// `rays` a place, at least 8: as many to all sides where something is near, and half as many to a lamp
  /// where its shadow's edge is. Lamps' positions are from the same origin as the occluders'.
  LightBaker(const std::vector<Occluder>& occluders, const Illumination& illumination, int rays);

  SurfaceLight light(const SurfacePoint& point) const;

  /// How much of a lamp is in sight from about a place, 0..1: the mean over 0.25 m around it, so that it
  /// changes by small steps as one passes behind something.
  float inSight(std::size_t lamp, const glm::vec3& place) const;

 private:
  struct Lamp {
    glm::vec3 position;
    glm::vec3 colour;  ///< times intensity
    float reach;
    std::vector<glm::vec3> disc;  ///< points on it, those in sight of its middle
  };
  struct Direct {
    glm::vec3 light{0.0F};
    float overhead = 0.0F;  ///< brightness of what comes down steeply
  };

  void addLamp(const Light& light);
  void throwBack(const std::vector<Occluder>& occluders);
  Direct direct(const glm::vec3& from, const glm::vec3& normal, std::size_t rays) const;
  float visible(const Lamp& lamp, const glm::vec3& from, std::size_t rays) const;
  bool gather(const glm::vec3& from, const glm::vec3& normal, glm::vec3& irradiance) const;
  glm::vec3 ambientFrom(const glm::vec3& direction) const { return direction.y > 0.0F ? sky_ : ground_; }

  RayScene rays_;
  std::size_t ray_count_;
  glm::vec3 sky_;
  glm::vec3 ground_;
  std::vector<Lamp> lamps_;
  std::vector<glm::vec3> directions_;
  std::vector<glm::vec3> around_;     ///< points about a place, from it
  std::vector<glm::vec3> radiosity_;  ///< by occluder: the light it throws back
};

}  // namespace coherency
