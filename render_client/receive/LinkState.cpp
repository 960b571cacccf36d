#include "render_client/receive/LinkState.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::size_t kProbesRemembered = 32;

std::string seconds(std::int64_t ns) {
  std::string text = std::to_string(ns / 1'000'000'000) + "." + std::to_string(ns / 100'000'000 % 10);
  return text + " s";
}

}  // namespace

void LinkState::welcomed(const SessionConfig& session) {
  const std::lock_guard lock(mutex_);
  if (!session_ || session_->session_id != session.session_id) {
    // Another server, another clock: nothing of the old one holds any longer.
    newest_.reset();
    recent_.fill(std::nullopt);
    for (auto& [tick, packet] : kept_) packet.reset();
    offset_ = ClockSync();
    frames_.clear();
  }
  tracker_.restart();
  asked_.clear();
  session_ = session;
  refusal_.reset();
  connected_ = true;
  ++connections_;
  changed_.notify_all();
}

void LinkState::refused(const Goodbye& goodbye) {
  const std::lock_guard lock(mutex_);
  last_failure_ = goodbye.reason;
  if (goodbye.cause == GoodbyeCause::Version) refusal_ = goodbye.reason;
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
  connected_ = false;
}

ClockProbe LinkState::probe() {
  const std::lock_guard lock(mutex_);
  const ClientTime now{clock_.nowNs()};
  asked_.push_back(now.ns);
  if (asked_.size() > kProbesRemembered) asked_.pop_front();
  return {session_->session_id, session_->client_id, session_->client_token, now.ns};
}

bool LinkState::datagram(std::span<const std::byte> bytes, ClientTime arrived) {
  DecodedDatagram decoded = codec_.decode(bytes);
  std::unique_lock lock(mutex_);
  const std::uint64_t newest_before = newestSequence();
  const bool ours = std::visit([&](auto& body) { return on(body, arrived); }, decoded);
  if (!ours) ++rejected_;
  const bool newer = newestSequence() != newest_before;
  lock.unlock();  // so that whoever waits finds it open
  if (newer) changed_.notify_all();
  return ours;
}

bool LinkState::on(MotionPacket& packet, ClientTime arrived) {
  if (!session_ || packet.session_id != session_->session_id) return false;
  tracker_.add(packet.sample.sequence, packet.previous);
  const ClientTime decoded{clock_.nowNs()};
  remember(packet, arrived, decoded);
  if (packet.sample.sequence > newestSequence()) newest_ = {std::move(packet), arrived, decoded};
  return true;
}

void LinkState::remember(const MotionPacket& packet, ClientTime arrived, ClientTime decoded) {
  const ReceivedPacket received{
      {packet.session_id, packet.sample, packet.world, packet.hash, {}}, arrived, decoded};
  for (auto& [from, first] : kept_)
    if (packet.world.tick >= from && (!first || packet.world.tick < first->packet.world.tick))
      first = received;
  auto& recent = recent_[packet.world.tick % kRecentPackets];
  if (recent && recent->packet.world.tick >= packet.world.tick) return;  // late by a whole round
  recent = received;
}

bool LinkState::on(const ClockReply& reply, ClientTime arrived) {
  if (!session_ || reply.session_id != session_->session_id) return false;
  const auto asked = std::find(asked_.begin(), asked_.end(), reply.t0_client_ns);
  if (asked == asked_.end()) return false;  // never asked, or answered before
  asked_.erase(asked);
  return offset_.add({{reply.t0_client_ns}, {reply.t1_server_ns}, {reply.t2_server_ns}, arrived});
}

ClientReport LinkState::takeReport() {
  const std::lock_guard lock(mutex_);
  ClientReport report{{frames_.begin(), frames_.end()}, tracker_.counts().received, tracker_.counts().lost};
  frames_.clear();
  return report;
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

std::optional<ReceivedPacket> LinkState::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::optional<ReceivedPacket> LinkState::atTick(std::uint64_t tick) const {
  const std::lock_guard lock(mutex_);
  const auto& recent = recent_[tick % kRecentPackets];
  return recent && recent->packet.world.tick == tick ? recent : std::nullopt;
}

void LinkState::keepFirstFrom(const std::vector<std::uint64_t>& ticks) {
  const std::lock_guard lock(mutex_);
  std::map<std::uint64_t, std::optional<ReceivedPacket>> kept;
  for (const std::uint64_t tick : ticks) {
    const auto before = kept_.find(tick);
    kept[tick] = before == kept_.end() ? std::nullopt : before->second;
  }
  kept_ = std::move(kept);
}

std::optional<ReceivedPacket> LinkState::firstFrom(std::uint64_t tick) const {
  const std::lock_guard lock(mutex_);
  const auto kept = kept_.find(tick);
  return kept == kept_.end() ? std::nullopt : kept->second;
}

bool LinkState::waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::nanoseconds(timeout_ns),
                           [&] { return newest_ && newest_->packet.world.tick >= tick; });
}

void LinkState::reportFrame(const FrameReport& frame) {
  const std::lock_guard lock(mutex_);
  frames_.push_back(frame);
  if (frames_.size() > kMaxReportFrames) frames_.pop_front();
}

std::optional<ServerTime> LinkState::toServer(ClientTime t) const {
  const std::lock_guard lock(mutex_);
  if (!offset_.known()) return std::nullopt;
  return offset_.toServer(t);
}

LinkStats LinkState::stats() const {
  const std::lock_guard lock(mutex_);
  const SequenceTracker::Counts& counts = tracker_.counts();
  LinkStats stats{.received = counts.received,
                  .lost = counts.lost,
                  .recovered = counts.recovered,
                  .rejected = rejected_,
                  .reordered = counts.reordered,
                  .connections = connections_,
                  .connected = connected_,
                  .clock_known = offset_.known()};
  if (offset_.known()) {
    const ClientTime now{clock_.nowNs()};
    stats.clock_offset_ns = offset_.offsetNs(now);
    stats.clock_bound_ns = offset_.boundNs(now);
    stats.clock_skew_ppm = offset_.skewPpm();
  }
  return stats;
}

std::string LinkState::where() const {
  const bool v6 = config_.host.find(':') != std::string::npos;
  return (v6 ? "[" + config_.host + "]:" : config_.host + ":") + std::to_string(config_.port);
}

}  // namespace coherency
