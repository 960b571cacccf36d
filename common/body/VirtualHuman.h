#pragma once

#include <cstdint>
#include <memory>

#include "common/body/PosedBody.h"

namespace coherency {

class MasterSystem;

/// What a scene requires of the operator's copy: all of it, or its eyes and frames alone, nothing drawn.
enum class HumanShown : std::uint8_t { Whole, None };

/// The operator's copy in the virtual world, sitting on the master (paper, sections I and II): head, trunk,
/// right arm with a gripping hand, left hand on the joystick, feet on the pedals, legs; and the master system
/// itself. Every DOF shows. Head and display are there for others to see; how they keep out of the own eyes'
/// view stands in HeadShape.h.
class VirtualHuman : public PosedBody {
 public:
  /// Throws std::domain_error where the rig is not valid.
  explicit VirtualHuman(const Rig& rig, HumanShown shown = HumanShown::Whole);
  ~VirtualHuman() override;

  /// Rebuilds every part from the sample (never from the last posture).
  void setSample(const MotionSample& sample);

  /// What the operator sits on; null where nothing is drawn.
  const MasterSystem* master() const;

 private:
  struct Shapes;
  std::unique_ptr<Shapes> shapes_;
};

}  // namespace coherency
