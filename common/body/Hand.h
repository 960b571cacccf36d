#pragma once

#include <array>

#include "common/body/Loft.h"

namespace coherency {

/// A hand that closes: palm, thumb of two segments and four fingers of three. Its frame is the wrist's
/// (ArmKinematics.h): x along the hand, -y leaves the palm, the right thumb points to -z, the left one to +z.
class Hand : public VRObject {
 public:
  enum class Side { Left, Right };

  /// `wrist_to_palm`: Rig::hand, m; everything scales with it.
  Hand(Side side, double wrist_to_palm, std::string name);

  /// See Grip.h.
  void setGrip(double grip);
  /// Of the middle finger at its root, rad.
  static double knuckleBend(double grip);

 private:
  void buildPalm();
  void buildFingers();
  void buildThumb();

  double side_;   // +1 right, -1 left: the thumb is at -side_ on z
  double scale_;  // of the sizes in Hand.cpp, which are a hand's with 0.09 m from wrist to palm
  Loft palm_;
  Loft heel_;  // of the thumb
  std::array<std::array<Loft, 3>, 4> fingers_;
  std::array<Loft, 2> thumb_;
};

}  // namespace coherency
