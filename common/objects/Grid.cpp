#include "common/objects/Grid.h"

#include <array>
#include <cmath>
#include <string>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/scene/Light.h"

namespace coherency {

Grid::Grid(int count) : VRObject("grid") {
  constexpr std::array<std::uint32_t, 7> kColours = {0xC9743A, 0x3F72C4, 0x4FA35B, 0xD3B46A,
                                                     0x6B4C78, 0x4E8A8B, 0xB83A2E};
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  boxes_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    // Short cycles without a common divisor: neighbours differ.
    const double width = 0.25 + 0.05 * (i * 5 % 7);
    const double height = 0.20 + 0.11 * (i * 7 % 11);
    const double depth = 0.25 + 0.06 * (i * 3 % 5);
    boxes_.push_back(std::make_unique<Box>());
    const double x = (i % columns - 0.5 * (columns - 1)) * kSpacing;
    const int behind = i / columns;
    assembleBox(*this, *boxes_.back(), "box " + std::to_string(i + 1),
                paint(kColours[static_cast<std::size_t>(i * 4 % 7)], 0.1), {width, height, depth},
                {x, height / 2, -kFirst - kSpacing * behind});
  }
  attach(Ambient{{0.62, 0.64, 0.68}, {0.30, 0.29, 0.27}});
  // A sun, so that the boxes' sides differ.
  constexpr double kSun = 2000.0;
  attach(Light{Coord3{-0.48, 0.80, 0.36} * kSun, {1.0, 0.97, 0.92}, 0.45 * kSun * kSun, 10.0 * kSun});
}

}  // namespace coherency
