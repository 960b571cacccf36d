#include "render_client/receive/LinkState.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::size_t kProbesRemembered = 32;
constexpr std::uint64_t kMostLater = 1'000'000;  // samples after a frame's own: whatever the server says

std::string seconds(std::int64_t ns) {
  std::string text = std::to_string(ns / 1'000'000'000) + "." + std::to_string(ns / 100'000'000 % 10);
  return text + " s";
}

}  // namespace

void LinkState::welcomed(const SessionConfig& session, const ConnectionKeys& keys) {
  const std::lock_guard lock(mutex_);
  if (!session_ || session_->session_id != session.session_id) {
    // Another server, another clock: nothing of the old one holds any longer.
    newest_.reset();
    frames_.clear();
    keyframes_.clear();
    clocks_ = ClockSync();
    reports_.clear();
    codec_.emplace(session.form);
    motion_opener_.emplace(session.motion_key, kMotionChannel);
  }
  reply_opener_.emplace(keys.server_datagrams, session.client_id);
  probe_sealer_.emplace(keys.client_datagrams, session.client_id);
  tracker_.restart();
  asked_.clear();
  session_ = session;
  refusal_.reset();
  stats_.connected = true;
  ++stats_.connections;
  changed_.notify_all();
}

void LinkState::refused(const Goodbye& goodbye) {
  const std::lock_guard lock(mutex_);
  last_failure_ = goodbye.reason;
  if (goodbye.cause == GoodbyeCause::Version || goodbye.cause == GoodbyeCause::Key) refusal_ = goodbye.reason;
  changed_.notify_all();
}

void LinkState::refuseVersion() {
  refused({"it speaks another major version than " + std::to_string(kWireMajor) +
               ": install the same release on both",
           GoodbyeCause::Version});
}

void LinkState::disconnected(const std::string& why) {
  const std::lock_guard lock(mutex_);
  last_failure_ = why;
  stats_.connected = false;
}

void LinkState::take(const Keyframe& keyframe) {
  const std::lock_guard lock(mutex_);
  ++stats_.keyframes;
  if (const auto field = keyframes_.add(keyframe)) stats_.differing_field = *field;
}

ClockProbe LinkState::probe(MotionWay way) {
  const ClientTime now{clock_.nowNs()};
  asked_.push_back(now.ns);
  if (asked_.size() > kProbesRemembered) asked_.pop_front();
  return {now.ns, keyframes_.newest(), way};
}

void LinkState::encodeProbe(MotionWay way, std::vector<std::byte>& datagram) {
  const std::lock_guard lock(mutex_);
  probe_sealer_->begin(datagram);
  codec_->encode(probe(way), datagram);
  probe_sealer_->seal(datagram);
}

Tunnelled LinkState::tunnelledProbe() {
  const std::lock_guard lock(mutex_);
  Tunnelled tunnelled;
  codec_->encode(probe(MotionWay::Tcp), tunnelled.body);
  return tunnelled;
}

LinkState::Heard LinkState::datagram(std::span<std::byte> bytes, ClientTime arrived) {
  const std::lock_guard lock(mutex_);
  const auto header = readHeader(bytes);
  if (const auto* const reject = std::get_if<Reject>(&header)) return count(*reject);
  if (!session_) return count(Reject::Forged);
  const bool motion = std::get<DatagramHeader>(header).channel == kMotionChannel;
  return take((motion ? motion_opener_ : reply_opener_)->open(bytes), arrived);
}

LinkState::Heard LinkState::tunnelled(const Tunnelled& tunnelled, ClientTime arrived) {
  const std::lock_guard lock(mutex_);
  return take(std::span<const std::byte>(tunnelled.body), arrived);
}

LinkState::Heard LinkState::take(std::variant<Reject, std::span<const std::byte>> opened,
                                 ClientTime arrived) {
  if (const auto* const reject = std::get_if<Reject>(&opened)) return count(*reject);
  DecodedDatagram decoded = codec_->decode(std::get<std::span<const std::byte>>(opened), keyframes_);
  return std::visit([&](auto& body) { return on(body, arrived); }, decoded);
}

LinkState::Heard LinkState::count(Reject reject) {
  if (reject == Reject::NoKeyframe) {  // the server's, and early: the keyframe is on its way
    ++stats_.without_keyframe;
    return Heard::Motion;
  }
  if (reject == Reject::Replayed) {
    ++stats_.replayed;
    return Heard::Again;
  }
  ++stats_.rejected;
  if (reject == Reject::Forged) ++stats_.forged;
  return Heard::Nothing;
}

LinkState::Heard LinkState::on(MotionPacket& packet, ClientTime arrived) {
  tracker_.add(packet.sample.sequence, packet.previous);
  const ClientTime decoded{clock_.nowNs()};
  bool news = false;
  for (const FrameState& frame : packet.frames) {
    const auto later = std::min(packet.sample.sequence - frame.sample.sequence, kMostLater);
    const ServerTime sampled{packet.sample.server_time_ns -
                             static_cast<std::int64_t>(later) * session_->period_ns};
    news = frames_.add({session_->session_id, frame, arrived, sampled}) || news;
  }
  if (!newest_ || packet.sample.sequence > newest_->packet.sample.sequence) {
    newest_ = {std::move(packet), arrived, decoded};
    news = true;
  }
  if (news) changed_.notify_all();
  return Heard::Motion;
}

LinkState::Heard LinkState::on(const ClockReply& reply, ClientTime arrived) {
  const auto asked = std::find(asked_.begin(), asked_.end(), reply.t0_client_ns);
  if (asked == asked_.end()) return count(Reject::Replayed);  // never asked, or answered before
  asked_.erase(asked);
  clocks_.add({{reply.t0_client_ns}, {reply.t1_server_ns}, {reply.t2_server_ns}, arrived});
  return Heard::Reply;
}

void LinkState::setWay(MotionWay way) {
  const std::lock_guard lock(mutex_);
  stats_.way = way;
}

ClientReport LinkState::takeReport() {
  const std::lock_guard lock(mutex_);
  ClientReport report{{reports_.begin(), reports_.end()}, tracker_.counts().received, tracker_.counts().lost};
  reports_.clear();
  return report;
}

bool LinkState::takeKeyframeWish() {
  const std::lock_guard lock(mutex_);
  return std::exchange(keyframe_wished_, false);
}

void LinkState::requestKeyframe() {
  const std::lock_guard lock(mutex_);
  keyframe_wished_ = true;
}

SessionConfig LinkState::waitForSession(std::int64_t timeout_ns) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::nanoseconds(timeout_ns), [this] { return session_ || refusal_; });
  if (session_) return *session_;
  if (refusal_) throw std::runtime_error("the server at " + where() + " refused: " + *refusal_);
  throw std::runtime_error("no session with " + where() + " within " + seconds(timeout_ns) + " (" +
                           last_failure_ +
                           "): start motion_server there, or give the address and port it listens on");
}

std::optional<SessionConfig> LinkState::session() const {
  const std::lock_guard lock(mutex_);
  return session_;
}

std::uint64_t LinkState::sessionId() const {
  const std::lock_guard lock(mutex_);
  return session_ ? session_->session_id : 0;
}

std::optional<ReceivedPacket> LinkState::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

bool LinkState::waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::nanoseconds(timeout_ns),
                           [&] { return newest_ && newest_->packet.world.tick >= tick; });
}

std::optional<ReceivedFrame> LinkState::nextFrame(std::uint64_t after, std::uint64_t stride,
                                                  ServerTime earliest, std::int64_t draw_ns) const {
  const std::lock_guard lock(mutex_);
  return frames_.next(after, stride, earliest, draw_ns);
}

std::vector<ReceivedFrame> LinkState::framesBetween(std::uint64_t after, std::uint64_t before,
                                                    std::uint64_t stride) const {
  const std::lock_guard lock(mutex_);
  return frames_.between(after, before, stride);
}

std::uint64_t LinkState::newestFrame() const {
  const std::lock_guard lock(mutex_);
  return frames_.newest();
}

bool LinkState::waitForFrame(std::uint64_t number, std::int64_t timeout_ns) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::nanoseconds(timeout_ns),
                           [&] { return frames_.newest() >= number; });
}

void LinkState::keepFirstFrom(const std::vector<std::uint64_t>& numbers) {
  const std::lock_guard lock(mutex_);
  frames_.keepFirstFrom(numbers);
}

std::optional<ReceivedFrame> LinkState::firstFrom(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  return frames_.firstFrom(number);
}

void LinkState::reportFrame(const FrameReport& frame) {
  const std::lock_guard lock(mutex_);
  reports_.push_back(frame);
  if (reports_.size() > kMaxReportFrames) reports_.pop_front();
}

std::optional<ServerTime> LinkState::toServer(ClientTime t) const {
  const std::lock_guard lock(mutex_);
  if (!clocks_.known()) return std::nullopt;
  return clocks_.toServer(t);
}

std::optional<ClientTime> LinkState::toClient(ServerTime t) const {
  const std::lock_guard lock(mutex_);
  if (!clocks_.known()) return std::nullopt;
  return clocks_.toClient(t);
}

LinkStats LinkState::stats() const {
  const std::lock_guard lock(mutex_);
  const SequenceTracker::Counts& counts = tracker_.counts();
  LinkStats stats = stats_;
  stats.received = counts.received;
  stats.lost = counts.lost;
  stats.recovered = counts.recovered;
  stats.reordered = counts.reordered;
  stats.clock_known = clocks_.known();
  if (!clocks_.known()) return stats;
  const ClientTime now{clock_.nowNs()};
  stats.clock_offset_ns = clocks_.offsetNs(now);
  stats.clock_bound_ns = clocks_.boundNs(now);
  stats.clock_skew_ppm = clocks_.skewPpm();
  return stats;
}

std::string LinkState::where() const {
  const bool v6 = config_.host.find(':') != std::string::npos;
  return (v6 ? "[" + config_.host + "]:" : config_.host + ":") + std::to_string(config_.port);
}

}  // namespace coherency
