#include "common/body/Footprint.h"

#include <algorithm>

#include "common/body/master/MasterLayout.h"

namespace coherency {

std::vector<FootprintDisc> masterFootprint(const Rig& rig) {
  const MasterLayout layout(rig);
  const double half = layout.deck_half_width + 0.02;
  const double ahead = layout.deck_ahead;
  const double knees = rig.seat_height + 0.12;
  const double sitting = rig.seat_height + rig.trunk_length + rig.neck_length;
  const double feet = half + 0.02;
  const Coord3& stick = layout.joystick;
  return {{0.0, 0.0, std::max(0.40, half + 0.06), 0.0, sitting},
          {stick.x + 0.02, stick.z + 0.10, 0.15, 0.0, sitting},
          {0.0, -0.5 * ahead, feet, 0.0, knees},
          {0.0, -ahead + feet - 0.06, feet, 0.0, knees}};
}

std::vector<FootprintDisc> robotFootprint(const Rig& robot_rig) {
  const double tall = robot_rig.seat_height + robot_rig.trunk_length + robot_rig.neck_length;
  return {{0.0, 0.0, std::max(0.15, 1.6 * robot_rig.shoulder_half_width), 0.0, tall}};
}

}  // namespace coherency
