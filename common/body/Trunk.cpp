#include "common/body/Trunk.h"

#include <algorithm>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

// A person as wide and as tall as the default rig; others are scaled from here.
constexpr double kUnitShoulder = 0.19;
constexpr double kUnitTrunk = 0.52;

std::vector<Loft::Section> scaled(std::vector<Loft::Section> sections, double along, double across) {
  for (auto& s : sections)
    s = {s.at * along, s.a * across, s.b * across, s.centre_a * across, s.centre_b * across};
  return sections;
}

}  // namespace

Trunk::Trunk(const Rig& rig) : VRObject("trunk") {
  addMember(&thorax_);
  buildChest(rig);
  buildPelvis(rig);
}

void Trunk::buildChest(const Rig& rig) {
  const double tall = rig.trunk_length / kUnitTrunk;
  const double wide = rig.shoulder_half_width / kUnitShoulder;
  chest_.setSections(scaled({{-0.500, 0.106, 0.146, -0.004},
                             {-0.410, 0.109, 0.145, -0.010},
                             {-0.320, 0.104, 0.141, -0.008},
                             {-0.230, 0.108, 0.152, -0.008},
                             {-0.150, 0.112, 0.166, -0.008},
                             {-0.090, 0.104, 0.172, -0.002},
                             {-0.048, 0.090, 0.174, 0.002},
                             {-0.022, 0.076, 0.162, 0.005},
                             {-0.002, 0.062, 0.122, 0.008},
                             {0.016, 0.045, 0.074, 0.010}},
                            tall, wide),
                     {Loft::Along::Y, 20, 2.35, 0.03 * tall, 0.012 * tall});
  assemble(thorax_, chest_, "chest", paint(palette::kShirt));
  collar_.setSections(
      scaled({{-0.022, 0.062, 0.078}, {0.004, 0.059, 0.066}, {0.026, 0.055, 0.057}}, tall, wide),
      {Loft::Along::Y, 16, 2.0, 0.0, 0.0});
  assemble(thorax_, collar_, "collar", paint(palette::kShirtTrim));
  neck_base_.setSections(scaled({{-0.01, 0.050, 0.052}, {0.030, 0.049, 0.050}}, tall, wide),
                         {Loft::Along::Y, 14, 2.0, 0.0, 0.020 * tall});
  assemble(thorax_, neck_base_, "neck base", paint(palette::kSkin));
}

void Trunk::buildPelvis(const Rig& rig) {
  const double wide = rig.shoulder_half_width / kUnitShoulder;
  pelvis_.setSections(
      scaled({{-0.055, 0.105, 0.150, 0.000}, {0.000, 0.116, 0.160, 0.000}, {0.060, 0.109, 0.151, -0.004}},
             1.0, wide),
      {Loft::Along::Y, 20, 2.4, 0.025, 0.012});
  assemble(*this, pelvis_, "pelvis", paint(palette::kTrousers));
  belt_.setSections(scaled({{0.035, 0.1145, 0.1565, -0.004}, {0.068, 0.1125, 0.1525, -0.005}}, 1.0, wide),
                    {Loft::Along::Y, 20, 2.4, 0.0, 0.0});
  assemble(*this, belt_, "belt", paint(palette::kBelt, 0.2));
}

void Trunk::setPosture(const Posture& posture) {
  // A trunk without length could not be turned back into its own frame.
  const double stretch = std::max(0.05, posture.trunk_stretch);
  thorax_.setTransform(posture.t_body_thorax * TransformMatrix::scaling({1.0, stretch, 1.0}));
  pelvis_.setPosition(posture.hip);
  belt_.setPosition(posture.hip);
}

}  // namespace coherency
