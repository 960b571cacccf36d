#include "common/wire/Validity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <arpa/inet.h>

#include "common/wire/SealedDatagram.h"

namespace coherency {
namespace {

bool isTime(std::int64_t ns) {
  return ns >= 0 && ns <= kMaxTimeNs;
}
bool isPlace(const BasePose& at) {
  const auto within = [](std::int64_t nm) { return nm >= -kWorldLimitNm && nm <= kWorldLimitNm; };
  return within(at.x_nm) && within(at.y_nm) && within(at.z_nm);
}

/// A DOF's range in its integer unit. Rounding may step over the border by half a unit, hence one more.
struct UnitRange {
  std::int64_t min;
  std::uint64_t width;
  bool wraps;  ///< whole turns drop out of an angle, so that its range may reach beyond half a turn

  bool contains(std::int32_t units) const {
    const auto above = static_cast<std::uint64_t>(units - min);
    return (wraps ? above & 0xffffffffU : above) <= width;
  }
};

UnitRange unitRange(const DofInfo& dof) {
  const double unit = resolution(dof.kind);
  const auto min = static_cast<std::int64_t>(std::floor(dof.min / unit)) - 1;
  const auto max = static_cast<std::int64_t>(std::ceil(dof.max / unit)) + 1;
  return {min, static_cast<std::uint64_t>(max - min), dof.kind == DofKind::Angle};
}

const std::array<UnitRange, kDofCount>& unitRanges() {
  static const auto ranges = [] {
    std::array<UnitRange, kDofCount> table{};
    std::transform(dofTable().begin(), dofTable().end(), table.begin(), unitRange);
    return table;
  }();
  return ranges;
}

/// Nothing or "#rrggbb"; which digits, is for who mixes it to say.
bool isColour(std::string_view colour) {
  return isPlainText(colour) && colour.size() <= 7;
}

bool isEye(std::string_view eye) {
  return eye == "left" || eye == "right" || eye == "both" || eye == "mono";
}

/// 224.0.0.0/4
bool isMulticastAddress(const std::string& address) {
  in_addr bytes{};
  return isPlainText(address) && ::inet_pton(AF_INET, address.c_str(), &bytes) == 1 &&
         IN_MULTICAST(ntohl(bytes.s_addr));
}

bool isRig(const Rig& rig) {
  if (!isPlainText(rig.name)) return false;
  try {
    validate(rig);
  } catch (const std::domain_error&) {
    return false;
  }
  return true;
}

}  // namespace

bool isValid(const MotionSample& sample) {
  if (sample.sequence == 0 || (sample.valid & ~kAllDofs) != 0 || !isTime(sample.server_time_ns)) return false;
  const auto& ranges = unitRanges();
  for (std::size_t i = 0; i < kDofCount; ++i) {
    if (sample.isValid(dofAt(i)) && !ranges[i].contains(sample.units[i])) return false;
  }
  return true;
}

bool isValid(const FrameState& frame) {
  return isValid(frame.sample) && isValid(frame.world);
}

bool isValid(const MotionPacket& packet) {
  if (packet.keyframe == 0 || packet.previous.size() > kMaxPrevious || packet.frames.size() > kMaxFrames)
    return false;
  if (!isValid(packet.sample) || !isValid(packet.world)) return false;
  std::uint64_t later = packet.sample.sequence;
  for (const MotionSample& sample : packet.previous) {
    if (sample.sequence >= later || !isValid(sample)) return false;
    later = sample.sequence;
  }
  for (std::size_t i = 0; i < packet.frames.size(); ++i) {
    const FrameState& frame = packet.frames[i];
    if (!isValid(frame) || (i > 0 && frame.number >= packet.frames[i - 1].number)) return false;
  }
  return true;
}

bool isValid(const ClockProbe& probe) {
  return isTime(probe.t0_client_ns) && probe.way <= MotionWay::Tcp;
}

bool isValid(const ClockReply& reply) {
  return isTime(reply.t0_client_ns) && isTime(reply.t1_server_ns) && isTime(reply.t2_server_ns) &&
         reply.t1_server_ns <= reply.t2_server_ns;
}

bool isValid(const Hello& hello) {
  return hello.major == kWireMajor;
}

bool isValid(const Join& join) {
  return isEye(join.eye) && isPlainText(join.software);
}

bool isValid(const SceneDescription& scene) {
  const bool places = isPlace(scene.start) && isPlace(scene.workplace) &&
                      (!scene.robot || (isPlace(scene.robot->start) && isPlace(scene.robot->workplace)));
  std::int64_t parts = 0;
  for (const ObjectPlacement& object : scene.objects) {
    if (!isPlainText(object.kind) || object.kind.size() > kMaxKind || !isPlainText(object.name) ||
        !isColour(object.colour) || !isPlace(object.place) || object.count < 0)
      return false;
    parts += object.count;
  }
  return isSceneName(scene.name) && places && scene.objects.size() <= kMaxSceneObjects &&
         parts <= kMaxSceneParts;
}

bool isValid(const SampleForm& form) {
  if ((form.dofs & ~kAllDofs) != 0) return false;
  for (std::size_t i = 0; i < kDofCount; ++i)
    if (!unitRanges()[i].contains(form.still[i])) return false;
  return true;
}

bool isValid(const SessionConfig& session) {
  return session.session_id != 0 && session.client_id != 0 && session.udp_port != 0 &&
         session.period_ns >= kMinPeriodNs && session.period_ns <= kMaxPeriodNs &&
         session.frame_ns >= kMinFrameNs && session.frame_ns <= kMaxPeriodNs && isValid(session.scene) &&
         isRig(session.rig) && isValid(session.form) &&
         (!session.multicast ||
          (isMulticastAddress(session.multicast->address) && session.multicast->port != 0));
}

bool isValid(const Keyframe& keyframe) {
  return keyframe.number != 0 && isValid(keyframe.world);
}

bool isValid(const Tunnelled& tunnelled) {
  return !tunnelled.body.empty() && tunnelled.body.size() <= kMaxDatagramBody;
}

bool isValid(const ClientReport& report) {
  return report.frames.size() <= kMaxReportFrames &&
         std::all_of(report.frames.begin(), report.frames.end(), [](const FrameReport& frame) {
           return frame.fate <= Fate::Mismatch && isTime(frame.presented_server_ns) &&
                  isTime(frame.arrived_server_ns) && isTime(frame.draw_ns);
         });
}

bool isValid(const Goodbye& goodbye) {
  return isPlainText(goodbye.reason) && goodbye.cause <= GoodbyeCause::Key;
}

bool isValid(const ModeRequest& request) {
  return request.mode <= Mode::Robot;
}

bool isValid(const Announcement& announcement) {
  return isPlainText(announcement.host) && isSceneName(announcement.scene) && announcement.port != 0;
}

bool hashHolds(const FrameState& frame) {
  return frame.hash == stateHash(frame.world, frame.sample);
}

bool hashHolds(const MotionPacket& packet) {
  return packet.hash == stateHash(packet.world, packet.sample);
}

}  // namespace coherency
