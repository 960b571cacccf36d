// What is nearer hides what is farther, by however little: two faces a millimetre apart at a hundred metres,
// with the near plane at a centimetre, all over the picture, whatever is drawn first.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/math/FixedPoint.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr double kDegree = kTurn / 360.0;
constexpr Coord3 kLevel{1.0, 0.0, 0.0};
constexpr Coord3 kUpright{0.0, 1.0, 0.0};
constexpr Coord3 kOblique{1.0, 1.0, 0.0};

EyeView narrowView() {
  EyeView view = lookingAhead({}, kWidth, kHeight, 0.12);  // a plane tilted by 80 degrees still fills it
  view.near_m = 0.01;
  return view;
}

/// Two parallel faces that fill the picture, the red one nearer.
struct Pair {
  double distance = 100.0;  ///< m, along the optical axis
  double gap = 0.001;       ///< m, along their normal
  double tilt = 0.0;        ///< radians
  Coord3 axis = kLevel;     ///< of the tilt
};

/// What may decide which is drawn first: whether it moves, how far its farthest corner is, when it was added.
struct Order {
  bool red_moves = false;
  bool blue_moves = false;
  bool red_larger = false;
  bool red_added_first = false;
};

void addPair(TestScene& scene, const Pair& pair, const Order& order) {
  const TransformMatrix turned = TransformMatrix::rotation(pair.axis, pair.tilt);
  const auto add = [&](bool red) {
    const double size = (red == order.red_larger ? 24.0 : 20.0) * pair.distance;
    const Coord3 at = Coord3{0.0, 0.0, -pair.distance} - turned.vector({0.0, 0.0, red ? 0.0 : pair.gap});
    Rectangle& face = scene.add<Rectangle>(at, red ? kRed : kBlue, size, size);
    face.setOrientation(turned);
    if (red ? order.red_moves : order.blue_moves) face.attach(Moving{});
  };
  add(order.red_added_first);
  add(!order.red_added_first);
}

/// Pixels in which red is not all one sees.
int wrong(const Pair& pair, const Order& order, int samples) {
  TestScene scene;
  addPair(scene, pair, order);
  const Image image = picture(scene, narrowView(), {.samples = samples});
  int count = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      count += value(image, x, y, Red) == 0 || value(image, x, y, Blue) > 0 ? 1 : 0;
  return count;
}

class Depth : public DrawingTest {};

TEST_F(Depth, TellsFacesAMillimetreApartAtAHundredMetres) {
  for (const int samples : {1, 4})
    for (const double tilt : {0.0, 45.0 * kDegree, 80.0 * kDegree})
      for (const Coord3& axis : {kLevel, kUpright, kOblique})
        for (int bits = 0; bits < 16; ++bits) {
          const Order order{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
          ASSERT_EQ(wrong({.tilt = tilt, .axis = axis}, order, samples), 0)
              << samples << " samples, tilted by " << tilt << ", order " << bits;
        }
}

/// Turned by a little to either side about an upright line 100 m ahead, they change places there.
TEST_F(Depth, FacesThatCrossHideEachOtherOnEitherSide) {
  constexpr double kTurned = 0.001;
  const EyeView view = narrowView();
  const double pixels = 0.5 * kWidth / view.view.tan_right;  // of a tangent of 1
  const double a_millimetre_apart = pixels * 0.0005 / kTurned / 100.0;
  for (const bool red_larger : {true, false})
    for (const bool red_moves : {true, false}) {
      TestScene scene;
      const auto add = [&](const Material& material, double size, double turned) -> Rectangle& {
        Rectangle& face = scene.add<Rectangle>({0.0, 0.0, -100.0}, material, size, size);
        face.setOrientation(TransformMatrix::rotationY(turned));
        return face;
      };
      Rectangle& red = add(kRed, red_larger ? 60.0 : 50.0, kTurned);
      add(kBlue, red_larger ? 50.0 : 60.0, -kTurned);
      if (red_moves) red.attach(Moving{});
      const Image image = picture(scene, view);
      double mixed = 0.0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const double aside = x + 0.5 - 0.5 * kWidth;
          const Channel nearer = aside < 0.0 ? Red : Blue;
          const Channel farther = aside < 0.0 ? Blue : Red;
          if (value(image, x, y, nearer) == 0 || value(image, x, y, farther) > 0)
            mixed = std::max(mixed, std::abs(aside));
        }
      EXPECT_LT(mixed, a_millimetre_apart);
    }
}

/// With the red one drawn last: where both are as near, what was drawn first stays.
bool toldApart(const Pair& pair, int samples) {
  for (const bool red_moves : {true, false})
    for (const bool blue_moves : {true, false})
      if (wrong(pair, {.red_moves = red_moves, .blue_moves = blue_moves, .red_larger = true}, samples) > 0)
        return false;
  return true;
}

/// Prints what was measured for docs/measurements.md: the last of a series before a pixel is wrong.
TEST_F(Depth, HasRoomToSpare) {
  constexpr double kStep = 1.2;
  for (const int samples : {1, 4})
    for (const double tilt : {0.0, 80.0 * kDegree}) {
      Pair far{.tilt = tilt};
      while (far.distance < 1e6 && toldApart(far, samples)) far.distance *= kStep;
      Pair close{.tilt = tilt};
      while (close.gap > 1e-9 && toldApart(close, samples)) close.gap /= kStep;
      EXPECT_GT(far.distance, 200.0);
      EXPECT_LT(close.gap, 0.0005);
      std::printf("%d samples, tilted by %2.0f degrees: 1 mm to %.0f m; at 100 m %.4f mm\n", samples,
                  tilt / kDegree, far.distance / kStep, 1e3 * close.gap * kStep);
    }
}

}  // namespace
}  // namespace coherency
