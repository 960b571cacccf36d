#include "motion_server/broadcast/SessionHost.h"

#include <algorithm>
#include <cassert>

#include "common/wire/ControlCodec.h"
#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::size_t kPastRemembered = 256;

std::string versionText(std::uint32_t major, std::uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

ClientStatus withCounts(ClientStatus status, const SendCounts& counts) {
  status.packets_sent = counts.sent;
  status.packets_not_sent = counts.not_sent;
  return status;
}

}  // namespace

SessionHost::SessionHost(const BroadcastConfig& config, const SessionConfig& session, Random random)
    : config_(config), session_(session), random_(std::move(random)) {
  session_.session_id = nonZeroRandom();
}

std::uint32_t SessionHost::open(const std::string& address, ServerTime now) {
  const std::uint32_t id = next_id_++;
  Client client(now);
  client.status.id = id;
  client.status.address = address;
  clients_.emplace(id, std::move(client));
  return id;
}

std::optional<std::uint32_t> SessionHost::surplus() const {
  if (clients_.size() - welcomed() <= kStrangers) return std::nullopt;
  const auto oldest = std::find_if(clients_.begin(), clients_.end(),
                                   [](const auto& c) { return c.second.stage != Stage::Welcomed; });
  return oldest->first;
}

SessionHost::Reaction SessionHost::receive(std::uint32_t connection, std::span<const std::byte> bytes,
                                           ServerTime now) {
  const auto found = clients_.find(connection);
  if (found == clients_.end()) return {{}, true};  // closed already
  Client& client = found->second;
  Reaction all;
  if (client.stage == Stage::Leaving) return all;
  client.framing.feed(bytes);
  const auto add = [&](const Reaction& reaction) {
    client.heard = now;
    all.send.insert(all.send.end(), reaction.send.begin(), reaction.send.end());
    all.goodbye = reaction.goodbye;
    if (reaction.mode) all.mode = reaction.mode;
  };
  while (const auto message = client.framing.next()) {
    if (client.budget.take(now))
      add(std::visit([&](const auto& decoded) { return on(client, decoded); }, decodeControl(*message)));
    else
      add(sendAway(client, GoodbyeCause::Protocol,
                   "more than " + std::to_string(kMessagesPerSecond) + " control messages a second"));
    if (all.goodbye) return all;
  }
  if (client.framing.oversized()) add(on(client, Reject::Oversized));
  return all;
}

SessionHost::Reaction SessionHost::on(Client& client, const Hello& hello) {
  if (client.stage != Stage::Stranger) return sendAway(client, GoodbyeCause::Protocol, "a second hello");
  if (hello.major != kWireMajor) {
    ++rejected_.version;
    return sendAway(client, GoodbyeCause::Version,
                    "this server speaks version " + versionText(kWireMajor, kWireMinor) + ", this client " +
                        versionText(hello.major, hello.minor) + ": install the same release on both");
  }
  if (welcomed() >= static_cast<std::size_t>(config_.max_clients)) {
    return sendAway(client, GoodbyeCause::Full,
                    "this server has its " + std::to_string(config_.max_clients) +
                        " clients already: stop one or raise max_clients");
  }
  client.stage = Stage::Welcomed;
  client.was_welcomed = true;
  ++served_;
  client.token = nonZeroRandom();
  client.status.eye = hello.eye;
  SessionConfig welcome = session_;
  welcome.client_id = client.status.id;
  welcome.client_token = client.token;
  return {encodeControl(welcome), false};
}

SessionHost::Reaction SessionHost::on(Client& client, const ClientReport& report) {
  if (client.stage != Stage::Welcomed)
    return sendAway(client, GoodbyeCause::Protocol, "a report before hello");
  for (const FrameReport& frame : report.frames) stereo_.add(client.status.eye, frame);
  client.status.last_report = {{}, report.packets_received, report.packets_lost};
  return {};
}

SessionHost::Reaction SessionHost::on(Client& client, const Goodbye&) {
  sendAway(client, GoodbyeCause::Leaving, "");  // nobody is there to be told
  return {{}, true};
}

SessionHost::Reaction SessionHost::on(Client& client, const ModeRequest& request) {
  if (client.stage != Stage::Welcomed)
    return sendAway(client, GoodbyeCause::Protocol, "a request before hello");
  return {{}, false, request.mode};
}

SessionHost::Reaction SessionHost::on(Client& client, const SessionConfig&) {
  return on(client, Reject::Malformed);
}

SessionHost::Reaction SessionHost::on(Client& client, Reject reject) {
  count(reject);
  return sendAway(client, GoodbyeCause::Protocol,
                  reject == Reject::Oversized
                      ? "a control message beyond " + std::to_string(kMaxControlMessage) + " bytes"
                      : "not a control message that a client sends");
}

SessionHost::Reaction SessionHost::sendAway(Client& client, GoodbyeCause cause, const std::string& reason) {
  client.stage = Stage::Leaving;
  if (client.udp.size != 0) ++targets_version_;
  return {encodeControl(Goodbye{reason, cause}), true};
}

void SessionHost::close(std::uint32_t connection) {
  const auto found = clients_.find(connection);
  if (found == clients_.end()) return;
  const Client& client = found->second;
  if (client.was_welcomed) {
    past_.push_back(withCounts(client.status, *client.counts));
    past_.back().connected = false;
    if (past_.size() > kPastRemembered) past_.pop_front();
  }
  if (client.udp.size != 0) ++targets_version_;
  clients_.erase(found);
}

std::vector<std::uint32_t> SessionHost::expired(ServerTime now) const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, client] : clients_) {
    const std::int64_t patience = client.stage == Stage::Leaving ? kLingerNs : config_.silence_ns;
    if (now - client.heard >= patience) ids.push_back(id);
  }
  return ids;
}

std::optional<ClockReply> SessionHost::datagram(std::span<const std::byte> bytes, const UdpAddress& from,
                                                ServerTime arrived) {
  const DecodedDatagram decoded = codec_.decode(bytes);
  if (const auto* reject = std::get_if<Reject>(&decoded)) {
    count(*reject);
    return std::nullopt;
  }
  const auto* probe = std::get_if<ClockProbe>(&decoded);
  if (probe == nullptr) {  // motion and replies never come this way
    ++rejected_.malformed;
    return std::nullopt;
  }
  const auto found = clients_.find(probe->client_id);
  if (probe->session_id != session_.session_id || found == clients_.end() ||
      found->second.stage != Stage::Welcomed || found->second.token != probe->client_token) {
    ++rejected_.foreign;
    return std::nullopt;
  }
  Client& client = found->second;
  client.heard = arrived;
  if (client.udp != from) {
    client.udp = from;
    ++targets_version_;
  }
  return ClockReply{session_.session_id, probe->t0_client_ns, arrived.ns, arrived.ns};
}

std::vector<MotionTarget> SessionHost::targets() const {
  std::vector<MotionTarget> targets;
  for (const auto& [id, client] : clients_) {
    if (client.stage == Stage::Welcomed && client.udp.size != 0)
      targets.push_back({client.udp, client.counts});
  }
  return targets;
}

std::vector<ClientStatus> SessionHost::clients() const {
  std::vector<ClientStatus> all(past_.begin(), past_.end());
  for (const auto& [id, client] : clients_) {
    if (!client.was_welcomed) continue;
    all.push_back(withCounts(client.status, *client.counts));
    all.back().connected = client.stage == Stage::Welcomed;
  }
  return all;
}

std::size_t SessionHost::welcomed() const {
  return static_cast<std::size_t>(std::count_if(
      clients_.begin(), clients_.end(), [](const auto& c) { return c.second.stage == Stage::Welcomed; }));
}

std::uint64_t SessionHost::nonZeroRandom() {
  std::uint64_t number = 0;
  while (number == 0) number = random_();
  return number;
}

void SessionHost::count(Reject reject) {
  switch (reject) {
    case Reject::Malformed:
      ++rejected_.malformed;
      break;
    case Reject::Oversized:
      ++rejected_.oversized;
      break;
    case Reject::Version:
      ++rejected_.version;
      break;
    case Reject::Forged:
    case Reject::Replayed:
      assert(false && "nothing here opens a sealed datagram");
      break;
  }
}

}  // namespace coherency
