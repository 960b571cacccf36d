#include "motion_server/broadcast/SessionHost.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::size_t kPastRemembered = 256;
constexpr std::size_t kRefusalsKept = 8;    // likewise
constexpr std::size_t kReportsKept = 4096;  // for who takes them; the oldest go

std::string versionText(std::uint32_t major, std::uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

ClientStatus withCounts(ClientStatus status, const SendCounts& counts) {
  status.packets_sent = counts.sent;
  status.packets_not_sent = counts.not_sent;
  return status;
}

std::uint64_t nonZeroNumber(const SessionHost::Random& random) {
  std::uint64_t number = 0;
  while (number == 0) {
    const Key bytes = random();
    std::memcpy(&number, bytes.data(), sizeof number);
  }
  return number;
}

}  // namespace

struct SessionHost::Client {
  Client(std::uint32_t number, const Key& key, const Key& secret, ServerTime connected)
      : id(number),
        channel(ControlChannel::Side::Server, key, secret),
        budget(kMessagesPerSecond, kMessagesAtOnce, connected),
        heard(connected) {}
  std::uint32_t id;
  Stage stage = Stage::Stranger;
  bool was_welcomed = false;
  ClientStatus status;
  ControlChannel channel;
  std::optional<DatagramOpener> opener;
  std::optional<DatagramSealer> sealer;
  MessageBudget budget;
  ServerTime heard;  ///< or connected, or said goodbye to
  bool probed = false;
  std::int64_t probed_at = 0;  ///< by its clock, the newest probe
  MotionWay way = MotionWay::Udp;
  UdpAddress udp;
  std::uint32_t keyframe = 0;  ///< the newest it says it has
  std::shared_ptr<SendCounts> counts = std::make_shared<SendCounts>();
};

SessionHost::SessionHost(const BroadcastConfig& config, const SessionConfig& session, Random random)
    : config_(config), session_(session), random_(std::move(random)) {
  session_.session_id = nonZeroNumber(random_);
  session_.motion_key = random_();
}

SessionHost::~SessionHost() = default;

std::uint32_t SessionHost::open(const std::string& address, ServerTime now) {
  const std::uint32_t id = next_id_++;
  auto client = std::make_unique<Client>(id, config_.key, random_(), now);
  client->status.id = id;
  client->status.address = address;
  clients_.emplace(id, std::move(client));
  return id;
}

std::optional<std::uint32_t> SessionHost::surplus() const {
  if (clients_.size() - welcomed() <= kStrangers) return std::nullopt;
  const auto oldest = std::find_if(clients_.begin(), clients_.end(),
                                   [](const auto& c) { return c.second->stage != Stage::Welcomed; });
  return oldest->first;
}

SessionHost::Reaction SessionHost::receive(std::uint32_t connection, std::span<const std::byte> bytes,
                                           ServerTime now) {
  const auto found = clients_.find(connection);
  if (found == clients_.end()) return {{}, true};  // closed already
  Client& client = *found->second;
  Reaction all;
  if (client.stage == Stage::Leaving) return all;
  client.channel.feed(bytes);
  const auto add = [&](const Reaction& reaction) {
    client.heard = now;
    all.send.insert(all.send.end(), reaction.send.begin(), reaction.send.end());
    all.goodbye = reaction.goodbye;
    all.wants_keyframes = all.wants_keyframes || reaction.wants_keyframes;
    if (reaction.mode) all.mode = reaction.mode;
  };
  while (const auto message = client.channel.next()) {
    if (client.budget.take(now))
      add(react(client, *message, now));
    else
      add(sendAway(client, GoodbyeCause::Protocol,
                   "more than " + std::to_string(kMessagesPerSecond) + " control messages a second"));
    if (all.goodbye) return all;
  }
  if (client.channel.oversized()) add(reject(client, Reject::Oversized));
  return all;
}

SessionHost::Reaction SessionHost::react(Client& client, const DecodedControl& decoded, ServerTime now) {
  if (const auto* refused = std::get_if<Reject>(&decoded)) return reject(client, *refused);
  return std::visit([&](const auto& message) { return on(client, message, now); },
                    std::get<ControlMessage>(decoded));
}

SessionHost::Reaction SessionHost::say(Client& client, const ControlMessage& message) {
  Reaction reaction;
  client.channel.write(message, reaction.send);
  return reaction;
}

std::vector<std::byte> SessionHost::tell(std::uint32_t connection, const ControlMessage& message) {
  const auto found = clients_.find(connection);
  if (found == clients_.end() || found->second->stage != Stage::Welcomed) return {};
  return say(*found->second, message).send;
}

SessionHost::Reaction SessionHost::on(Client& client, const Hello& hello, ServerTime) {
  if (client.stage != Stage::Stranger) return sendAway(client, GoodbyeCause::Protocol, "a second hello");
  if (hello.major != kWireMajor) {
    ++rejected_.version;
    return sendAway(client, GoodbyeCause::Version,
                    "this server speaks version " + versionText(kWireMajor, kWireMinor) + ", this client " +
                        versionText(hello.major, hello.minor) + ": install the same release on both");
  }
  const bool keyed = config_.key != kNoKey;
  if (hello.keyed != keyed) {
    ++rejected_.foreign;
    return sendAway(client, GoodbyeCause::Key,
                    keyed ? "this server has a key: copy its key file to this machine and give --key FILE"
                          : "this server has no key: leave --key out, or start it with the key");
  }
  Reaction reaction = say(client, client.channel.hello());
  if (!client.channel.agree(hello)) return sendAway(client, GoodbyeCause::Protocol, "that is no public key");
  client.stage = Stage::Greeted;
  return reaction;
}

SessionHost::Reaction SessionHost::on(Client& client, const Join& join, ServerTime) {
  if (client.stage != Stage::Greeted) return sendAway(client, GoodbyeCause::Protocol, "a join out of place");
  if (welcomed() >= static_cast<std::size_t>(config_.max_clients)) {
    return sendAway(client, GoodbyeCause::Full,
                    "this server has its " + std::to_string(config_.max_clients) +
                        " clients already: stop one or raise max_clients");
  }
  client.stage = Stage::Welcomed;
  client.was_welcomed = true;
  ++served_;
  client.status.eye = join.eye;
  client.opener.emplace(client.channel.keys().client_datagrams, client.id);
  client.sealer.emplace(client.channel.keys().server_datagrams, client.id);
  SessionConfig welcome = session_;
  welcome.client_id = client.id;
  Reaction reaction = say(client, welcome);
  reaction.wants_keyframes = true;
  return reaction;
}

SessionHost::Reaction SessionHost::on(Client& client, const ClientReport& report, ServerTime) {
  if (client.stage != Stage::Welcomed)
    return sendAway(client, GoodbyeCause::Protocol, "a report before joining");
  for (const FrameReport& frame : report.frames) stereo_.add(client.status.eye, frame);
  reports_.insert(reports_.end(), report.frames.begin(), report.frames.end());
  if (reports_.size() > kReportsKept)
    reports_.erase(reports_.begin(), reports_.end() - static_cast<std::ptrdiff_t>(kReportsKept));
  client.status.last_report = {{}, report.packets_received, report.packets_lost};
  return {};
}

SessionHost::Reaction SessionHost::on(Client& client, const Goodbye&, ServerTime) {
  sendAway(client, GoodbyeCause::Leaving, "");  // nobody is there to be told
  return {{}, true};
}

SessionHost::Reaction SessionHost::on(Client& client, const ModeRequest& request, ServerTime) {
  if (client.stage != Stage::Welcomed)
    return sendAway(client, GoodbyeCause::Protocol, "a request before joining");
  Reaction reaction;
  reaction.mode = request.mode;
  return reaction;
}

SessionHost::Reaction SessionHost::on(Client& client, const KeyframeRequest&, ServerTime) {
  if (client.stage != Stage::Welcomed)
    return sendAway(client, GoodbyeCause::Protocol, "a request before joining");
  Reaction reaction;
  reaction.wants_keyframes = true;
  return reaction;
}

/// Only probes come this way. The answer's time is this one: nothing waits between.
SessionHost::Reaction SessionHost::on(Client& client, const Tunnelled& tunnelled, ServerTime now) {
  const DecodedDatagram decoded = codec_.decode(tunnelled.body, no_keyframes_);
  const auto* const probe = std::get_if<ClockProbe>(&decoded);
  if (client.stage != Stage::Welcomed || probe == nullptr) return reject(client, Reject::Malformed);
  heard(client, *probe, MotionWay::Tcp, {});
  Tunnelled answer;
  codec_.encode(ClockReply{probe->t0_client_ns, now.ns, now.ns}, answer.body);
  return say(client, answer);
}

SessionHost::Reaction SessionHost::on(Client& client, const SessionConfig&, ServerTime) {
  return reject(client, Reject::Malformed);
}
SessionHost::Reaction SessionHost::on(Client& client, const Keyframe&, ServerTime) {
  return reject(client, Reject::Malformed);
}

SessionHost::Reaction SessionHost::reject(Client& client, Reject reject) {
  count(reject);
  if (reject == Reject::Forged && !client.channel.proven())
    return sendAway(client, GoodbyeCause::Key,
                    "this server has another key than this client: copy the server's key file here");
  return sendAway(client, GoodbyeCause::Protocol,
                  reject == Reject::Oversized
                      ? "a control message beyond " + std::to_string(kMaxControlMessage) + " bytes"
                      : "not a control message that a client sends");
}

SessionHost::Reaction SessionHost::sendAway(Client& client, GoodbyeCause cause, const std::string& reason) {
  if (cause == GoodbyeCause::Version || cause == GoodbyeCause::Key || cause == GoodbyeCause::Full) {
    refusals_.push_back("client at " + client.status.address + " refused: " + reason);
    if (refusals_.size() > kRefusalsKept) refusals_.pop_front();
  }
  client.stage = Stage::Leaving;
  if (client.probed) ++targets_version_;
  Reaction reaction = say(client, Goodbye{reason, cause});
  reaction.goodbye = true;
  return reaction;
}

void SessionHost::close(std::uint32_t connection) {
  const auto found = clients_.find(connection);
  if (found == clients_.end()) return;
  const Client& client = *found->second;
  if (client.was_welcomed) {
    past_.push_back(withCounts(client.status, *client.counts));
    past_.back().connected = false;
    if (past_.size() > kPastRemembered) past_.pop_front();
    stereo_.left(client.status.eye);
  }
  if (client.probed) ++targets_version_;
  clients_.erase(found);
}

std::vector<std::uint32_t> SessionHost::expired(ServerTime now) const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, client] : clients_) {
    const std::int64_t patience = client->stage == Stage::Leaving ? kLingerNs : config_.silence_ns;
    if (now - client->heard >= patience) ids.push_back(id);
  }
  return ids;
}

std::optional<SessionHost::Answer> SessionHost::datagram(std::span<std::byte> bytes, const UdpAddress& from,
                                                         ServerTime arrived) {
  const auto refuse = [this](Reject reject) {
    count(reject);
    return std::nullopt;
  };
  const auto header = readHeader(bytes);
  if (const auto* const refused = std::get_if<Reject>(&header)) return refuse(*refused);
  const auto found = clients_.find(std::get<DatagramHeader>(header).channel);
  if (found == clients_.end() || found->second->stage != Stage::Welcomed) {
    ++rejected_.foreign;
    return std::nullopt;
  }
  Client& client = *found->second;
  const auto body = client.opener->open(bytes);
  if (const auto* const refused = std::get_if<Reject>(&body)) return refuse(*refused);
  const DecodedDatagram decoded = codec_.decode(std::get<std::span<const std::byte>>(body), no_keyframes_);
  const auto* const probe = std::get_if<ClockProbe>(&decoded);
  if (probe == nullptr) return refuse(Reject::Malformed);  // motion and replies never come this way
  client.heard = arrived;
  heard(client, *probe, probe->way, from);
  return Answer{client.id, {probe->t0_client_ns, arrived.ns, arrived.ns}};
}

/// An older probe that comes late says nothing any more: who holds one back and sends it from elsewhere would
/// have the motion.
void SessionHost::heard(Client& client, const ClockProbe& probe, MotionWay way, const UdpAddress& from) {
  if (client.probed && probe.t0_client_ns < client.probed_at) return;
  client.probed_at = probe.t0_client_ns;
  client.keyframe = probe.keyframe;
  if (client.probed && client.way == way && client.udp == from) return;
  client.probed = true;
  client.way = way;
  client.udp = from;
  client.status.way = kMotionWayNames[static_cast<std::size_t>(way)];
  ++targets_version_;
}

void SessionHost::encode(const Answer& answer, std::vector<std::byte>& out) {
  Client& client = *clients_.at(answer.client);
  client.sealer->begin(out);
  codec_.encode(answer.reply, out);
  client.sealer->seal(out);
}

std::vector<MotionTarget> SessionHost::targets() const {
  std::vector<MotionTarget> targets;
  for (const auto& [id, client] : clients_)
    if (client->stage == Stage::Welcomed && client->probed)
      targets.push_back({client->way, client->udp, client->counts});
  return targets;
}

std::vector<std::uint32_t> SessionHost::tunnels() const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, client] : clients_)
    if (client->stage == Stage::Welcomed && client->probed && client->way == MotionWay::Tcp)
      ids.push_back(id);
  return ids;
}

void SessionHost::countTunnelled(std::uint32_t client, bool sent) {
  if (const auto found = clients_.find(client); found != clients_.end())
    ++(sent ? found->second->counts->sent : found->second->counts->not_sent);
}

std::vector<std::uint32_t> SessionHost::welcomedClients() const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, client] : clients_)
    if (client->stage == Stage::Welcomed) ids.push_back(id);
  return ids;
}

std::uint32_t SessionHost::keyframeOfAll() const {
  std::uint32_t number = ~std::uint32_t{0};
  for (const auto& [id, client] : clients_)
    if (client->stage == Stage::Welcomed && client->probed) number = std::min(number, client->keyframe);
  return number;
}

std::vector<std::string> SessionHost::takeRefusals() {
  std::vector<std::string> taken(refusals_.begin(), refusals_.end());
  refusals_.clear();
  return taken;
}

std::vector<ClientStatus> SessionHost::clients() const {
  std::vector<ClientStatus> all(past_.begin(), past_.end());
  for (const auto& [id, client] : clients_) {
    if (!client->was_welcomed) continue;
    all.push_back(withCounts(client->status, *client->counts));
    all.back().connected = client->stage == Stage::Welcomed;
  }
  return all;
}

void SessionHost::count(Reject reject) {
  switch (reject) {
    case Reject::Malformed:
    case Reject::NoKeyframe:
      ++rejected_.malformed;
      break;
    case Reject::Oversized:
      ++rejected_.oversized;
      break;
    case Reject::Version:
      ++rejected_.version;
      break;
    case Reject::Forged:
      ++rejected_.forged;
      break;
    case Reject::Replayed:
      ++rejected_.replayed;
      break;
  }
}

}  // namespace coherency
