#include "common/config/LensTable.h"

#include <algorithm>

#include <fmt/format.h>

namespace coherency {
namespace {

constexpr const char* kColours[] = {"red", "green", "blue"};

void needAll(TomlTable& lens) {
  for (const char* key : {"centre", "unit_px", "tangent", "radius", "red", "green", "blue"})
    if (!lens.has(key))
      throw lens.error(key, "is missing; a lens has centre, unit_px, tangent, radius, red, green and blue");
}

/// Whole hundredths, as one who has to write it wants it.
double largestRadius(const LensCurve& curve, double radius) {
  double largest = 0.0;
  for (double r = 0.01; r < radius && curve.risesUpTo(r); r += 0.01) largest = r;
  return largest;
}

LensCurve readCurve(TomlTable& lens, const char* colour, bool reciprocal, double radius) {
  LensCurve curve;
  const auto numbers = lens.numbers(colour, curve.c.size(), -1000.0, 1000.0);
  std::copy(numbers.begin(), numbers.end(), curve.c.begin());
  curve.reciprocal = reciprocal;
  if (curve.risesUpTo(radius)) return curve;
  throw lens.error(colour, fmt::format("the curve does not rise from the lens centre to radius {}, so that a "
                                       "point would be seen twice; it does up to {:.2f}",
                                       radius, largestRadius(curve, radius)));
}

}  // namespace

Lens readLens(TomlTable& eye, const PanelSize& panel) {
  TomlTable table = eye.table("lens");
  needAll(table);
  Lens lens;
  const auto centre = table.numbers("centre", 2, -100'000.0, 100'000.0);
  lens.centre_x = centre[0];
  lens.centre_y = centre[1];
  if (!(lens.centre_x > 0.0 && lens.centre_x < panel.width && lens.centre_y > 0.0 &&
        lens.centre_y < panel.height))
    throw table.error("centre", fmt::format("{} {} is not on the panel; must be within {} x {} pixels",
                                            lens.centre_x, lens.centre_y, panel.width, panel.height));
  lens.unit_px = table.number("unit_px", 0.0, 1.0, 100'000.0);
  lens.tangent = table.number("tangent", 0.0, 0.01, 100.0);
  lens.radius = table.number("radius", 0.0, 0.01, 100.0);
  const bool reciprocal = table.oneOf("form", "polynomial", {"polynomial", "reciprocal"}) == "reciprocal";
  for (std::size_t i = 0; i < lens.curves.size(); ++i)
    lens.curves[i] = readCurve(table, kColours[i], reciprocal, lens.radius);
  table.finish();
  return lens;
}

}  // namespace coherency
