#include "render_client/Overlay.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/world/Hearing.h"
#include "common/world/Touch.h"

namespace coherency {
namespace {

constexpr std::int64_t kNoticeNs = 4'000'000'000;
constexpr std::int64_t kHintNs = 8'000'000'000;
constexpr std::int64_t kSilentNs = 500'000'000;
constexpr std::size_t kHeard = 3;  // the loudest
constexpr double kPalm = 0.03;     // m, radius of the ball that feels, under the palm

/// What is heard and felt where the operator now is (attributes for other senses).
std::string senses(const Replica& replica) {
  const Scene& scene = replica.scene();
  const Mode mode = replica.world().mode;
  const Rig& rig = replica.session().rig;
  const double scale = mode == Mode::Robot ? rig.robot_scale : 1.0;
  const TransformMatrix t_world_hand = scene.hand(mode).globalTransform();
  const Sphere palm{t_world_hand.point({rig.hand * scale, -kPalm * scale, 0.0}), kPalm * scale};
  auto heard = heardFrom(scene, scene.eye(Eye::Mono, mode).globalTransform());
  heard.resize(std::min(heard.size(), kHeard));
  return fmt::format("heard: {}\nthe hand touches: {}\n", describe(heard),
                     describe(touchedBy(palm, scene, {&scene.human(), scene.robot()})));
}

}  // namespace

void Overlay::refresh(const ClientStats& stats, const Replica& replica) {
  statistics_ = shown_ ? overlayText(stats) + "\n" + senses(replica) : std::string();
}

void Overlay::notify(std::string notice, ClientTime now) {
  notice_ = std::move(notice);
  noticed_ = now;
}

std::string Overlay::text(ClientTime now, std::int64_t silent_ns, const Replica& replica, bool keys) const {
  std::string text;
  if (!notice_.empty() && now - noticed_ < kNoticeNs) text = notice_ + "\n";
  if (silent_ns > kSilentNs)
    text += fmt::format("no signal from {} for {:.1f} s: holding the last pose\n", server_,
                        static_cast<double>(silent_ns) / 1e9);
  if (shown_) return text + statistics_;
  if (silent_ns <= kSilentNs && keys && now - started_ < kHintNs)
    text += replica.scene().robot() != nullptr
                ? "F1 statistics   F2 snapshot   F3 robot or operator   Esc quit"
                : "F1 statistics   F2 snapshot   Esc quit";
  return text;
}

}  // namespace coherency
