// Being far from the world's origin moves no vertex in the picture: against arithmetic in long double that
// starts from integer nanometres.

#include <algorithm>
#include <cstdio>
#include <memory>

#include <glm/matrix.hpp>

#include "common/math/FixedPoint.h"
#include "common/math/Rotation.h"
#include "tests/render/CloseUp.h"

namespace coherency {
namespace {

/// A place as replicas have it.
struct Place {
  std::int64_t x_nm = 0;
  std::int64_t y_nm = 0;
  std::int64_t z_nm = 0;
};
Place operator+(const Place& a, const Place& b) {
  return {a.x_nm + b.x_nm, a.y_nm + b.y_nm, a.z_nm + b.z_nm};
}
Place operator*(std::int64_t s, const Place& a) {
  return {s * a.x_nm, s * a.y_nm, s * a.z_nm};
}
Place place(const Coord3& at) {
  return {nanometresFromMetres(at.x), nanometresFromMetres(at.y), nanometresFromMetres(at.z)};
}
Coord3 metres(const Place& at) {
  return {metresFromNanometres(at.x_nm), metresFromNanometres(at.y_nm), metresFromNanometres(at.z_nm)};
}
/// Subtracted as integers: nothing is lost.
Vector3 metresApart(const Place& from, const Place& to) {
  return 1e-9L * Vector3(to.x_nm - from.x_nm, to.y_nm - from.y_nm, to.z_nm - from.z_nm);
}

/// Frames from one that stands in the world, whose own transform only turns and scales, down to a block of
/// 1 m.
using Chain = std::vector<TransformMatrix>;

Chain blockAlone() {
  return {rotation(YawPitchRoll{0.5, 0.6, 0.3}) * TransformMatrix::scaling({0.11, 0.09, 0.13})};
}
/// At the end of an arm of nine joints.
Chain blockInHand() {
  Chain chain{TransformMatrix::rotationY(0.7)};
  for (int joint = 1; joint < 9; ++joint)
    chain.push_back(TransformMatrix::translation({0.11, 0.02 * joint, -0.03}) *
                    TransformMatrix::rotation({1.0, 0.3 * joint, -0.5}, 0.2 + 0.1 * joint));
  chain.push_back(TransformMatrix::translation({0.1, 0.0, 0.0}) * blockAlone().front());
  return chain;
}
Matrix4 product(const Chain& chain) {
  Matrix4 product(1.0L);
  for (const TransformMatrix& link : chain) product = product * Matrix4(link.glm());
  return product;
}

/// The chain as the renderer has it, among other things; the block alone has green in it.
class Standing {
 public:
  Standing(const Chain& chain, const Place& at, bool moving) {
    scene_.add<Box>({0.0, 5.0, 30.0}, kRed, Coord3{1.0, 1.0, 1.0});  // where the world begins
    scene_.add<Box>(metres(at) + Coord3{4.0, 1.0, 3.0}, kRed, Coord3{1.0, 1.0, 1.0});
    scene_.add<Box>(metres(at) + Coord3{0.0, -4.0, 0.0}, kRed, Coord3{200.0, 0.1, 200.0});
    VRObject* above = &scene_;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      links_.push_back(std::make_unique<VRObject>());
      above->addMember(links_.back().get());
      above = links_.back().get();
      above->setTransform(chain[i]);
    }
    block_.setMaterial(kGreen);
    block_.setTransform(chain.back());
    above->addMember(&block_);
    moveTo(at);
    if (moving) root().attach(Moving{});
  }
  void moveTo(const Place& at) { root().setPosition(metres(at)); }
  const TestScene& scene() const { return scene_; }

 private:
  VRObject& root() { return links_.empty() ? block_ : *links_.front(); }

  TestScene scene_;
  std::vector<std::unique_ptr<VRObject>> links_;
  Box block_;
};

struct Observer {
  Place at;
  TransformMatrix attitude;
};

/// Half a metre from the block and `aside`; sees three of its faces, a little off the optical axis.
Observer observer(const Chain& chain, const Place& root, const Coord3& aside) {
  const TransformMatrix t_root_block(glm::dmat4(product(chain)));
  const Coord3 to_eye = normalized(t_root_block.vector({10.0, 9.0, 8.0}));
  return {root + place(t_root_block.origin() + 0.5 * to_eye + aside),
          rotationBetween({0.15, -0.1, -1.0}, -to_eye)};
}

/// The block's vertices as that eye sees them.
std::vector<Vector2> seen(const Chain& chain, const Place& root, const Observer& eye) {
  const Matrix3 r_eye_world = glm::transpose(Matrix3(Matrix4(eye.attitude.glm())));
  const Matrix4 t_root_block = product(chain);
  const Box block;
  std::vector<Vector2> seen;
  for (const Coord3& vertex : block.faces()->vertices) {
    const Vector3 p_root(t_root_block * glm::vec<4, Real>(Vector3(vertex.glm()), 1.0L));
    const Vector3 p_eye = r_eye_world * (p_root + metresApart(eye.at, root));
    seen.push_back(Vector2(p_eye) / -p_eye.z);
  }
  return seen;
}

EyeView viewOf(const Observer& eye) {
  EyeView view = lookingAhead(metres(eye.at), 640, 480);
  view.t_world_eye = TransformMatrix::translation(metres(eye.at)) * eye.attitude;
  return view;
}

class Precision : public DrawingTest {
 protected:
  /// Of all corners that show, from eyes some uneven micrometres apart.
  static Real worst(const Chain& chain, const Place& root, bool moving) {
    Standing standing(chain, moving ? Place{} : root, moving);
    Renderer renderer(standing.scene(), standing.scene().illumination(), kCloseUpSide, kCloseUpSide,
                      {.samples = 1});
    standing.moveTo(root);
    Real worst = 0.0L;
    for (const double step : {0.0, 1.234567e-6, 3.1e-3, 9.87654321e-3}) {
      const Observer eye = observer(chain, root, step * Coord3{1.0, -0.3, 0.7});
      const std::vector<Corner> corners = outline(seen(chain, root, eye));
      EXPECT_EQ(corners.size(), 6U);
      for (const Corner& corner : corners) {
        const EyeView view = closeUp(viewOf(eye), corner.at);
        worst = std::max(worst, error(picture(renderer, {&view, 1}), corner));
      }
    }
    return worst;
  }

  /// Prints what was measured for docs/measurements.md.
  static void expectExact(const Chain& chain, bool moving) {
    constexpr std::int64_t kMetre = 1'000'000'000;
    constexpr std::int64_t kWhereNanometresEnd = 9'200'000'000;
    constexpr Place kUneven{123'456'789, -987'654'321, 500'000'001};
    constexpr std::int64_t kDistances[] = {
        0,       1,         10,         100,         1'000,         10'000,
        100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000, kWhereNanometresEnd};
    for (const std::int64_t distance : kDistances) {
      Real most = 0.0L;
      for (const Place& direction : {Place{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, -1, 1}})
        most = std::max(most, worst(chain, kUneven + distance * kMetre * direction, moving));
      EXPECT_LT(most, 0.01L) << distance << " m away";
      std::printf("%10lld m away: off by %.5Lf px at most\n", static_cast<long long>(distance), most);
    }
  }
};

TEST_F(Precision, FixedBlockIsWhereArithmeticPutsIt) {
  expectExact(blockAlone(), false);
}

TEST_F(Precision, MovingBlockIsWhereArithmeticPutsIt) {
  expectExact(blockAlone(), true);
}

TEST_F(Precision, BlockAtTheEndOfAFixedArmIsWhereArithmeticPutsIt) {
  expectExact(blockInHand(), false);
}

TEST_F(Precision, BlockAtTheEndOfAMovingArmIsWhereArithmeticPutsIt) {
  expectExact(blockInHand(), true);
}

/// Everything there is to a picture, lamp and shadows too, about `middle`.
struct Village {
  explicit Village(const Coord3& middle) {
    scene.setAmbient({0.3, 0.3, 0.35}, {0.1, 0.1, 0.1});
    scene.addLight({middle + Coord3{0.3, 2.4, -0.5}, {1.0, 0.95, 0.9}, 4.0});
    scene.add<Box>(middle + Coord3{0.0, -1.0, -2.0}, matt(0.7, 0.7, 0.7), Coord3{5.0, 0.1, 5.0});
    for (int i = 0; i < 5; ++i) {
      Box& box = scene.add<Box>(middle + Coord3{0.5 * i - 1.0, -0.6 + 0.1 * i, -1.0 - 0.4 * i},
                                matt(0.9 - 0.15 * i, 0.4, 0.2 * i), Coord3{0.3, 0.4, 0.2});
      box.setOrientation(YawPitchRoll{0.3 * i, 0.2 * i, 0.1 * i});
      if (i % 2 == 0) box.attach(Moving{});
    }
    scene.add<Ellipsoid>(middle + Coord3{0.4, 0.3, -1.2}, Material{{0.2, 0.5, 0.8}, 0.6, 0.0},
                         Coord3{0.2, 0.2, 0.2}, 24);
    view = lookingAhead(middle, 320, 240);
    view.t_world_eye = TransformMatrix::translation(middle) * rotation(YawPitchRoll{0.05, -0.15, 0.02});
  }
  TestScene scene;
  EyeView view;
};

TEST_F(Precision, PictureIsTheSameAThousandKilometresFromTheOrigin) {
  for (const Coord3& near : {Coord3{}, Coord3{0.123456789, 0.5, -0.777777777}}) {
    const Village here(near);
    const Image expected = picture(here.scene, here.view);
    for (const Coord3& far : {Coord3{1e6, 0.0, 0.0}, Coord3{-6e5, 4e5, 7e5}, Coord3{0.0, 0.0, -1e6}}) {
      const Village there(near + far);
      EXPECT_EQ(shareDiffering(picture(there.scene, there.view), expected, 0), 0.0);
    }
  }
  Village aside({});
  const Image expected = picture(aside.scene, aside.view);
  aside.view.t_world_eye.setOrigin({0.0001, 0.0, 0.0});
  EXPECT_GT(shareDiffering(picture(aside.scene, aside.view), expected, 0), 0.0)
      << "a tenth of a millimetre shows";
}

}  // namespace
}  // namespace coherency
