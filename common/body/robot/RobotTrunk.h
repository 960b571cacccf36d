#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// Mobile base with wheels, column and waist, which stay, and the chest on a bellows, which leans and reaches
/// as the operator's trunk does. Its motors hum, its hull is hard (common/scene/Senses.h). Body axes.
class RobotTrunk : public VRObject {
 public:
  explicit RobotTrunk(const Rig& rig);

  void setPosture(const Posture& posture);

 private:
  void buildBase(const Rig& rig);
  void buildWheels(double k);
  void buildWaist(const Rig& rig);
  void buildChest(const Rig& rig);
  void buildChestFittings(double k, double wide);

  double chest_length_;
  double least_bellows_;

  Milled chassis_;
  Milled bumper_;
  std::array<Turned, 2> drive_wheels_;
  std::array<Polygon, 2> hubs_;
  std::array<Turned, 2> castors_;
  Turned column_;
  Turned waist_;
  Turned bellows_;
  VRObject thorax_{"robot thorax"};
  Milled chest_;
  Milled front_;
  std::array<Rectangle, 3> lamps_;
  Milled pack_;
  Turned left_flange_;
};

}  // namespace coherency
