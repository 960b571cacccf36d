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

BasePose read(const wire::Base& in) {
  return {in.x_nm(), in.y_nm(), in.z_nm(), in.heading_units()};
}

void write(const BasePose& base, wire::Base& out) {
  out.set_x_nm(base.x_nm);
  out.set_y_nm(base.y_nm);
  out.set_z_nm(base.z_nm);
  out.set_heading_units(base.heading_units);
}

bool read(const wire::Scene& in, SceneDescription& scene) {
  if (in.objects_size() > static_cast<int>(kMaxSceneObjects)) return false;
  scene.name = in.name();
  scene.operator_shown = in.operator_shown();
  scene.driving = in.driving();
  scene.start = read(in.start());
  scene.workplace = read(in.workplace());
  if (in.has_robot_start()) scene.robot = {read(in.robot_start()), read(in.robot_workplace())};
  for (const wire::SceneObject& object : in.objects()) {
    if (object.count() > static_cast<std::uint32_t>(kMaxSceneParts)) return false;
    scene.objects.push_back({object.kind(), object.name(), read(object.place()), object.colour(),
                             static_cast<std::int32_t>(object.count())});
  }
  return true;
}

void write(const SceneDescription& scene, wire::Scene& out) {
  out.set_name(scene.name);
  out.set_operator_shown(scene.operator_shown);
  out.set_driving(scene.driving);
  write(scene.start, *out.mutable_start());
  write(scene.workplace, *out.mutable_workplace());
  if (scene.robot) {
    write(scene.robot->start, *out.mutable_robot_start());
    write(scene.robot->workplace, *out.mutable_robot_workplace());
  }
  for (const ObjectPlacement& object : scene.objects) {
    wire::SceneObject& placed = *out.add_objects();
    placed.set_kind(object.kind);
    placed.set_name(object.name);
    write(object.place, *placed.mutable_place());
    placed.set_colour(object.colour);
    placed.set_count(static_cast<std::uint32_t>(object.count));
  }
}

DecodedControl read(const wire::Welcome& in) {
  if (in.major() != kWireMajor) return Reject::Version;
  if (in.udp_port() > 65535 || in.period_ns() > static_cast<std::uint64_t>(kMaxPeriodNs))
    return Reject::Malformed;
  SessionConfig session;
  session.session_id = in.session_id();
  session.client_id = in.client_id();
  session.client_token = in.client_token();
  session.rig.name = in.rig_name();
  session.period_ns = static_cast<std::int64_t>(in.period_ns());
  session.udp_port = static_cast<std::uint16_t>(in.udp_port());
  if (!read(in.scene(), session.scene) || !read(in.rig(), session.rig)) return Reject::Malformed;
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

DecodedControl read(const wire::ModeRequest& in) {
  if (in.mode() > static_cast<std::uint32_t>(Mode::Robot)) return Reject::Malformed;
  return ModeRequest{static_cast<Mode>(in.mode())};
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
  write(welcome.scene, *out.mutable_scene());
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

std::vector<std::byte> encodeControl(const ModeRequest& request) {
  assert(isValid(request));
  wire::ControlMessage message;
  message.mutable_mode_request()->set_mode(static_cast<std::uint32_t>(request.mode));
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
    case wire::ControlMessage::kModeRequest:
      return read(message.mode_request());
    case wire::ControlMessage::BODY_NOT_SET:
      break;
  }
  return Reject::Malformed;
}

}  // namespace coherency
