#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/body/master/MasterLayout.h"

namespace coherency {

/// The master's head mechanism: from a mast behind the seat a parallel linkage of two members carries a wrist
/// of three axes at the back of the head, and that the head-mounted display. It follows the head's position
/// and attitude. The linkage keeps behind the head, and the eyes lie inside the display's convex shell: the
/// operator's own eyes see nothing of it (HeadShape.h). Body axes.
class HeadLink : public VRObject {
 public:
  HeadLink(const Rig& rig, const MasterLayout& layout);

  void setPosture(const Posture& posture);

 private:
  void buildMast(const MasterLayout& layout);
  void buildLinkage();
  void buildHeadset(const Rig& rig);

  Coord3 root_;   ///< of the linkage
  Coord3 wrist_;  ///< in the head frame
  double member_ = 0.0;

  Milled mast_;
  Milled seat_bracket_;
  VRObject lower_{"head link lower member"};
  VRObject upper_{"head link upper member"};
  VRObject pan_{"head link wrist"};
  VRObject headset_{"headset"};
  Turned root_drum_;
  std::array<Milled, 2> lower_bars_;
  Turned elbow_drum_;
  std::array<Milled, 2> upper_bars_;
  Milled yoke_;
  Milled stem_;
  Milled plate_;
  std::array<Milled, 2> bands_;
  Milled visor_;
};

}  // namespace coherency
