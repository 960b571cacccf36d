#include "render_client/draw/DistortionMesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace coherency {
namespace {

constexpr int kMost = 1024;

/// Pixels of the picture of a tangent of 1, the larger of across and upright.
double pixelsPerTangent(const EyeDisplay& display, const PanelSize& picture) {
  const FieldOfView& view = display.view;
  return std::max(picture.width / (view.tan_left + view.tan_right),
                  picture.height / (view.tan_down + view.tan_up));
}

/// How far, in tangents, a straight line from one ring to another is off any colour's curve.
double offBetween(const Lens& lens, double from, double to) {
  constexpr int kParts = 8;
  double worst = 0.0;
  for (const LensCurve& curve : lens.curves)
    for (int i = 1; i < kParts; ++i) {
      const double s = static_cast<double>(i) / kParts;
      const double straight = (1.0 - s) * curve.tangent(from) + s * curve.tangent(to);
      worst = std::max(worst, std::abs(straight - curve.tangent((1.0 - s) * from + s * to)));
    }
  return lens.tangent * worst;
}

/// And how far a ring's chord is off it: a chord's middle is nearer to the centre, and the curve is not as
/// much lower there.
double offChord(const Lens& lens, double r, int spokes) {
  const double shorter = std::cos(std::numbers::pi / spokes);
  double worst = 0.0;
  for (const LensCurve& curve : lens.curves)
    worst = std::max(worst, std::abs(shorter * curve.tangent(r) - curve.tangent(shorter * r)));
  return lens.tangent * worst;
}

[[noreturn]] void refuse(const char* what) {
  throw std::runtime_error(
      "the lens bends the picture so much that the mesh against it would need more than " +
      std::to_string(kMost) + " " + what + "; give the lens a smaller radius in the HMD profile");
}

/// From the centre outwards, each as far from the one before as the curves allow.
std::vector<double> rings(const Lens& lens, double error) {
  std::vector<double> radii{0.0};
  while (radii.back() < lens.radius) {
    if (radii.size() > kMost) refuse("rings");
    double near = radii.back();
    double far = lens.radius;
    for (int i = 0; i < 30 && offBetween(lens, radii.back(), far) > error; ++i) {
      const double middle = 0.5 * (near + far);
      (offBetween(lens, radii.back(), middle) > error ? far : near) = middle;
    }
    radii.push_back(far);
  }
  return radii;
}

int spokesFor(const Lens& lens, const std::vector<double>& radii, double error) {
  int spokes = 32;
  for (const double r : radii)
    while (offChord(lens, r, spokes) > error)
      if (++spokes > kMost) refuse("spokes");
  return spokes;
}

DistortionVertex vertex(const EyeDisplay& display, const PanelSize& panel, double r, double angle) {
  const Lens& lens = *display.lens;
  const FieldOfView& view = display.view;
  const double right = std::cos(angle);
  const double up = std::sin(angle);
  DistortionVertex vertex;
  vertex.panel = {static_cast<float>((lens.centre_x + r * lens.unit_px * right) / panel.width),
                  static_cast<float>(1.0 - (lens.centre_y - r * lens.unit_px * up) / panel.height)};
  for (std::size_t colour = 0; colour < vertex.picture.size(); ++colour) {
    const double seen = lens.tangent * lens.curves[colour].tangent(r);
    vertex.picture[colour] = {
        static_cast<float>((seen * right + view.tan_left) / (view.tan_left + view.tan_right)),
        static_cast<float>((seen * up + view.tan_down) / (view.tan_down + view.tan_up))};
  }
  return vertex;
}

}  // namespace

DistortionMesh distortionMesh(const EyeDisplay& display, const PanelSize& panel, const PanelSize& picture,
                              double error_px) {
  assert(display.lens);
  // Along rings, across them, and a little left for both together.
  const double error = 0.4 * error_px / pixelsPerTangent(display, picture);
  const std::vector<double> radii = rings(*display.lens, error);
  DistortionMesh mesh;
  mesh.rings = static_cast<int>(radii.size()) - 1;
  mesh.spokes = spokesFor(*display.lens, radii, error);
  for (const double r : radii)
    for (int i = 0; i < mesh.spokes; ++i)
      mesh.vertices.push_back(vertex(display, panel, r, 2.0 * std::numbers::pi * i / mesh.spokes));
  const auto spokes = static_cast<std::uint32_t>(mesh.spokes);
  for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(mesh.rings); ++ring)
    for (std::uint32_t i = 0; i < spokes; ++i) {
      const std::uint32_t inner = ring * spokes + i;
      const std::uint32_t inner_next = ring * spokes + (i + 1) % spokes;
      mesh.indices.insert(mesh.indices.end(), {inner, inner + spokes, inner_next + spokes});
      if (ring > 0) mesh.indices.insert(mesh.indices.end(), {inner, inner_next + spokes, inner_next});
    }
  return mesh;
}

}  // namespace coherency
