#include "common/objects/Targets.h"

#include <string>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/scene/Light.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr int kSides = 12;
constexpr double kStep = 0.06;  // height between neighbours over distance: none covers another

void assembleBall(VRObject& owner, Ellipsoid& ball, std::string name, std::uint32_t colour, double radius,
                  const Coord3& at) {
  ball.setSize({radius, radius, radius}, kSides);
  assemble(owner, ball, std::move(name), glow(colour), at);
}

}  // namespace

Targets::Targets(const Rig& rig, VirtualHuman& human) : VRObject("targets") {
  constexpr std::array<std::uint32_t, 3> kColours = {0xFF0000, 0xFFFF00, 0x00FFFF};
  constexpr std::array<const char*, 3> kNames = {"red at 0.5 m", "yellow at 1 m", "cyan at 5 m"};
  const Coord3 eyes = neutralHead(rig) + Coord3{0.0, rig.eye_up, -rig.eye_forward};
  for (std::size_t i = 0; i < ahead_.size(); ++i) {
    const double distance = kDistances[i];
    const double up = kStep * (static_cast<double>(i) - 1.0) * distance;
    assembleBall(*this, ahead_[i], kNames[i], kColours[i], kAngularRadius * distance,
                 eyes + Coord3{0.0, up, -distance});
  }
  VRObject& hand = human.rightHand();
  assembleBall(hand, wrist_, "magenta at the wrist", 0xFF00FF, kHandRadius, {});
  assembleBall(hand, palm_, "green at the palm", 0x00FF00, kHandRadius, {rig.hand, 0.0, 0.0});
  attach(Ambient{{}, {}});
  // Low and to the right, where the hand's balls are well seen and cover none of the others.
  attach(Reachable{eyes + Coord3{0.18, -0.22, -0.40}});
}

}  // namespace coherency
