#include "common/body/robot/RobotTrunk.h"

#include "common/body/Assemble.h"
#include "common/body/robot/RobotSize.h"
#include "common/math/FixedPoint.h"
#include "common/scene/Senses.h"

namespace coherency {

namespace {

using enum Loft::Along;

constexpr double kDriveWheel = 0.090;  // m, radii, of a robot of the operator's size
constexpr double kCastor = 0.042;
constexpr double kChassisTop = 0.235;

std::vector<Loft::Section> scaled(std::vector<Loft::Section> sections, double along, double deep,
                                  double wide) {
  for (auto& s : sections) s = {s.at * along, s.a * deep, s.b * wide, s.centre_a * deep, s.centre_b * wide};
  return sections;
}

}  // namespace

RobotTrunk::RobotTrunk(const Rig& rig) : VRObject("robot trunk") {
  const RobotSize size(rig);
  chest_length_ = 0.31 * size.trunk;
  least_bellows_ = 0.02 * size.trunk;
  buildBase(rig);
  buildWheels(size.trunk);
  buildWaist(rig);
  buildChest(rig);
  buildChestFittings(size.trunk, size.wide);
}

void RobotTrunk::buildBase(const Rig& rig) {
  const double k = RobotSize(rig).trunk;
  chassis_.setSections(
      Y, 0.45,
      scaled(
          {{0.050, 0.205, 0.160}, {0.090, 0.230, 0.178}, {0.195, 0.205, 0.160}, {kChassisTop, 0.140, 0.120}},
          k, k, k),
      Ends::Last);
  assemble(*this, chassis_, "robot chassis", robot_paint::hull());
  chassis_.attach(SoundSource{"servo motors hum", 44.0});
  chassis_.attach(Surface{"plastic", 6e4});
  bumper_.setSections(Y, 0.45, scaled({{0.078, 0.236, 0.178}, {0.104, 0.236, 0.178}}, k, k, k), Ends::Open);
  assemble(*this, bumper_, "robot bumper", robot_paint::joint());
}

void RobotTrunk::buildWheels(double k) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    drive_wheels_[i].setProfile(X, 12, {{-0.020 * k, kDriveWheel * k}, {0.020 * k, kDriveWheel * k}},
                                i == 0 ? Ends::Last : Ends::First);
    assemble(*this, drive_wheels_[i], "robot drive wheel", robot_paint::rubber(),
             {side * 0.200 * k, kDriveWheel * k, 0.0});
    hubs_[i].setShape(i == 0 ? firstRing(drive_wheels_[i], 12) : lastRing(drive_wheels_[i], 12));
    assemble(*this, hubs_[i], "robot hub", robot_paint::metal(), drive_wheels_[i].position());
    castors_[i].setProfile(X, 8, {{-0.018 * k, kCastor * k}, {0.018 * k, kCastor * k}}, Ends::Both);
    assemble(*this, castors_[i], "robot castor", robot_paint::rubber(), {0.0, kCastor * k, side * 0.190 * k});
  }
}

/// Column from the chassis to the hips, and the corrugated waist, of length 1 along y, that follows the
/// chest.
void RobotTrunk::buildWaist(const Rig& rig) {
  const double k = RobotSize(rig).trunk;
  const double hips = std::max(rig.seat_height, (kChassisTop + 0.10) * k);
  column_.setProfile(Y, 12, {{kChassisTop * k, 0.090 * k}, {hips - 0.065 * k, 0.062 * k}}, Ends::Open);
  assemble(*this, column_, "robot column", robot_paint::metal());
  waist_.setProfile(Y, 12,
                    {{hips - 0.070 * k, 0.092 * k},
                     {hips - 0.055 * k, 0.106 * k},
                     {hips - 0.010 * k, 0.106 * k},
                     {hips + 0.012 * k, 0.080 * k}},
                    Ends::Both);
  assemble(*this, waist_, "robot waist", robot_paint::hull());
  std::vector<Turned::Ring> folds;
  for (int i = 0; i <= 6; ++i) folds.push_back({i / 6.0, (i % 2 == 0 ? 0.062 : 0.074) * k});
  bellows_.setProfile(Y, 10, folds, Ends::Open);
  assemble(*this, bellows_, "robot bellows", robot_paint::rubber());
}

void RobotTrunk::buildChest(const Rig& rig) {
  const RobotSize size(rig);
  addMember(&thorax_);
  chest_.setSections(Y, 0.40,
                     scaled({{-0.315, 0.080, 0.086},
                             {-0.270, 0.096, 0.112},
                             {-0.130, 0.106, 0.138, -0.004},
                             {-0.080, 0.094, 0.124},
                             {-0.045, 0.062, 0.078}},
                            size.trunk, size.trunk, size.wide),
                     Ends::Both);
  assemble(thorax_, chest_, "robot chest", robot_paint::hull());
  chest_.attach(Surface{"plastic", 6e4});
}

void RobotTrunk::buildChestFittings(double k, double wide) {
  front_.setSections(
      Z, 0.35, scaled({{-0.120, 0.058, 0.060, 0.0, -0.185}, {-0.085, 0.070, 0.074, 0.0, -0.185}}, k, wide, k),
      Ends::First);
  assemble(thorax_, front_, "robot chest plate", robot_paint::accent());
  const std::array<std::uint32_t, 3> colours = {0x6FD08C, 0x6FD08C, 0xF2E6B0};
  for (std::size_t i = 0; i < 3; ++i) {
    lamps_[i].setSize(0.016 * k, 0.008 * k);
    lamps_[i].setOrientation(TransformMatrix::rotationY(kTurn / 2));
    assemble(thorax_, lamps_[i], "robot lamp", glow(colours[i]),
             {(0.024 * static_cast<double>(i) - 0.024) * wide, -0.150 * k, -0.1206 * k});
  }
  pack_.setSections(
      Z, 0.25, scaled({{0.080, 0.092, 0.066, 0.0, -0.186}, {0.150, 0.076, 0.052, 0.0, -0.186}}, k, wide, k),
      Ends::Last);
  assemble(thorax_, pack_, "robot power pack", robot_paint::joint());
  left_flange_.setProfile(
      X, 8, {{-0.170 * wide, 0.032 * k}, {-0.158 * wide, 0.044 * k}, {-0.088 * wide, 0.045 * k}},
      Ends::First);
  assemble(thorax_, left_flange_, "robot left flange", robot_paint::joint(), {0.0, -0.105 * k, 0.0});
}

void RobotTrunk::setPosture(const Posture& posture) {
  thorax_.setTransform(posture.t_body_thorax);
  const double spine = norm(posture.t_body_thorax.origin() - posture.hip);
  const double length = std::max(least_bellows_, spine - chest_length_);
  TransformMatrix waist = posture.t_body_thorax.linear() * TransformMatrix::scaling({1.0, length, 1.0});
  waist.setOrigin(posture.hip);
  bellows_.setTransform(waist);
}

}  // namespace coherency
