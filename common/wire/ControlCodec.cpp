#include "common/wire/ControlCodec.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "coherency.pb.h"

#include "common/wire/ControlFraming.h"
#include "common/wire/Validity.h"

namespace coherency {
namespace {

std::vector<std::byte> frame(const wire::ControlMessage& message) {
  const std::size_t size = message.ByteSizeLong();
  std::vector<std::byte> out(kControlPrefix + size);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + kControlPrefix));
  finishControlFrame(out, 0);
  return out;
}

template <class T>
DecodedControl ifValid(T&& value) {
  if (!isValid(value)) return Reject::Malformed;
  return std::forward<T>(value);
}

DecodedControl read(const wire::Hello& in) {
  Hello hello;
  hello.major = in.major();
  hello.minor = in.minor();
  if (hello.major != kWireMajor) return hello;
  hello.eye = in.eye();
  hello.software = in.software();
  return ifValid(std::move(hello));
}

/// Every measure once; names of a newer minor version are passed over.
bool read(const google::protobuf::RepeatedPtrField<wire::Measure>& in, Rig& rig) {
  std::set<std::string_view> seen;
  for (const wire::Measure& measure : in) {
    const auto& fields = rigFields();
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const RigField& f) { return f.name == measure.name(); });
    if (field == fields.end()) continue;
    if (!seen.insert(field->name).second) return false;
    rig.*(field->value) = measure.value();
  }
  return seen.size() == rigFields().size();
}

DecodedControl read(const wire::Welcome& in) {
  if (in.major() != kWireMajor) return Reject::Version;
  if (in.udp_port() > 65535 || in.period_ns() > static_cast<std::uint64_t>(kMaxPeriodNs))
    return Reject::Malformed;
  SessionConfig session;
  session.session_id = in.session_id();
  session.client_id = in.client_id();
  session.client_token = in.client_token();
  session.scene = in.scene();
  session.rig.name = in.rig_name();
  session.period_ns = static_cast<std::int64_t>(in.period_ns());
  session.udp_port = static_cast<std::uint16_t>(in.udp_port());
  if (!read(in.rig(), session.rig)) return Reject::Malformed;
  return ifValid(std::move(session));
}

DecodedControl read(const wire::Report& in) {
  if (in.frames_size() > static_cast<int>(kMaxReportFrames)) return Reject::Malformed;
  ClientReport report;
  report.packets_received = in.packets_received();
  report.packets_lost = in.packets_lost();
  report.frames.reserve(static_cast<std::size_t>(in.frames_size()));
  for (const wire::Frame& frame : in.frames()) {
    report.frames.push_back({frame.sequence(), frame.hash(), frame.presented_server_ns()});
  }
  return ifValid(std::move(report));
}

DecodedControl read(const wire::Goodbye& in) {
  // Causes of a newer minor version are no longer known one by one: they end the connection all the same.
  const bool known = in.cause() >= 0 && in.cause() <= wire::PROTOCOL;
  return ifValid(Goodbye{in.reason(), known ? static_cast<GoodbyeCause>(in.cause()) : GoodbyeCause::Leaving});
}

}  // namespace

std::vector<std::byte> encodeControl(const Hello& hello) {
  assert(isValid(hello));
  wire::ControlMessage message;
  wire::Hello& out = *message.mutable_hello();
  out.set_major(hello.major);
  out.set_minor(hello.minor);
  out.set_eye(hello.eye);
  out.set_software(hello.software);
  return frame(message);
}

std::vector<std::byte> encodeControl(const SessionConfig& welcome) {
  assert(isValid(welcome));
  wire::ControlMessage message;
  wire::Welcome& out = *message.mutable_welcome();
  out.set_major(kWireMajor);
  out.set_minor(kWireMinor);
  out.set_session_id(welcome.session_id);
  out.set_client_id(welcome.client_id);
  out.set_client_token(welcome.client_token);
  out.set_scene(welcome.scene);
  out.set_rig_name(welcome.rig.name);
  for (const RigField& field : rigFields()) {
    wire::Measure& measure = *out.add_rig();
    measure.set_name(std::string(field.name));
    measure.set_value(welcome.rig.*(field.value));
  }
  out.set_period_ns(static_cast<std::uint64_t>(welcome.period_ns));
  out.set_udp_port(welcome.udp_port);
  return frame(message);
}

std::vector<std::byte> encodeControl(const ClientReport& report) {
  assert(isValid(report));
  wire::ControlMessage message;
  wire::Report& out = *message.mutable_report();
  out.set_packets_received(report.packets_received);
  out.set_packets_lost(report.packets_lost);
  for (const FrameReport& frame_report : report.frames) {
    wire::Frame& frame_out = *out.add_frames();
    frame_out.set_sequence(frame_report.sequence);
    frame_out.set_hash(frame_report.hash);
    frame_out.set_presented_server_ns(frame_report.presented_server_ns);
  }
  return frame(message);
}

std::vector<std::byte> encodeControl(const Goodbye& goodbye) {
  assert(isValid(goodbye));
  wire::ControlMessage message;
  message.mutable_goodbye()->set_reason(goodbye.reason);
  message.mutable_goodbye()->set_cause(static_cast<wire::GoodbyeCause>(goodbye.cause));
  return frame(message);
}

DecodedControl decodeControl(std::span<const std::byte> bytes) {
  if (bytes.size() > kMaxControlMessage) return Reject::Oversized;
  wire::ControlMessage message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return Reject::Malformed;
  switch (message.body_case()) {
    case wire::ControlMessage::kHello:
      return read(message.hello());
    case wire::ControlMessage::kWelcome:
      return read(message.welcome());
    case wire::ControlMessage::kReport:
      return read(message.report());
    case wire::ControlMessage::kGoodbye:
      return read(message.goodbye());
    case wire::ControlMessage::BODY_NOT_SET:
      break;
  }
  return Reject::Malformed;
}

}  // namespace coherency
