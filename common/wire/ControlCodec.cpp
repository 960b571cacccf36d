#include "common/wire/ControlCodec.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "coherency.pb.h"

#include "common/wire/ControlFraming.h"
#include "common/wire/Validity.h"
#include "common/wire/WireState.h"

namespace coherency {
namespace {

template <class T>
DecodedControl ifValid(T&& value) {
  if (!isValid(value)) return Reject::Malformed;
  return ControlMessage(std::forward<T>(value));
}

bool readKey(const std::string& in, Key& key) {
  if (in.size() != key.size()) return false;
  std::transform(in.begin(), in.end(), key.begin(), [](char c) { return static_cast<std::byte>(c); });
  return true;
}

std::string bytesOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

DecodedControl read(const wire::Hello& in) {
  Hello hello;
  hello.major = in.major();
  hello.minor = in.minor();
  if (hello.major != kWireMajor) return hello;
  hello.keyed = in.keyed();
  if (!readKey(in.public_key(), hello.public_key)) return Reject::Malformed;
  return ifValid(hello);
}

DecodedControl read(const wire::Join& in) {
  return ifValid(Join{in.eye(), in.software()});
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
  if (in.udp_port() > 65535 || in.multicast_port() > 65535 ||
      in.period_ns() > static_cast<std::uint64_t>(kMaxPeriodNs) ||
      in.frame_ns() > static_cast<std::uint64_t>(kMaxPeriodNs) ||
      in.still_size() != static_cast<int>(kDofCount))
    return Reject::Malformed;
  SessionConfig session;
  session.session_id = in.session_id();
  session.client_id = in.client_id();
  session.rig.name = in.rig_name();
  session.period_ns = static_cast<std::int64_t>(in.period_ns());
  session.frame_ns = static_cast<std::int64_t>(in.frame_ns());
  session.udp_port = static_cast<std::uint16_t>(in.udp_port());
  session.form.dofs = in.dofs();
  session.form.compact = in.compact();
  std::copy(in.still().begin(), in.still().end(), session.form.still.begin());
  if (!in.multicast_address().empty())
    session.multicast = {in.multicast_address(), static_cast<std::uint16_t>(in.multicast_port())};
  if (!readKey(in.motion_key(), session.motion_key) || !read(in.scene(), session.scene) ||
      !read(in.rig(), session.rig))
    return Reject::Malformed;
  return ifValid(std::move(session));
}

/// A state of so many movables and doors with everything zero: what a keyframe differs from.
WorldState blank(std::size_t movables, std::size_t doors) {
  WorldState state;
  state.movables.resize(movables);
  state.doors.resize(doors);
  for (Movable& movable : state.movables) movable = {.attitude = {}, .resting = false};
  return state;
}

DecodedControl read(const wire::Keyframe& in) {
  if (in.movables() > kMaxMovables || in.doors() > kMaxDoors) return Reject::Malformed;
  Keyframe keyframe{in.number(), {}};
  if (!in.has_world() || !readDifference(blank(in.movables(), in.doors()), in.world(), keyframe.world))
    return Reject::Malformed;
  return ifValid(std::move(keyframe));
}

bool read(const wire::FrameReport& in, FrameReport& frame) {
  const auto limit = static_cast<std::uint64_t>(kMaxTimeNs);
  if (in.draw_ns() > limit || in.fate() < 0 || in.fate() > wire::MISMATCH) return false;
  frame = {in.number(),
           static_cast<Fate>(in.fate()),
           in.tick(),
           in.hash(),
           in.presented_server_ns(),
           in.arrived_server_ns(),
           static_cast<std::int64_t>(in.draw_ns())};
  return true;
}

DecodedControl read(const wire::Report& in) {
  if (in.frames_size() > static_cast<int>(kMaxReportFrames)) return Reject::Malformed;
  ClientReport report;
  report.packets_received = in.packets_received();
  report.packets_lost = in.packets_lost();
  report.frames.resize(static_cast<std::size_t>(in.frames_size()));
  for (std::size_t i = 0; i < report.frames.size(); ++i)
    if (!read(in.frames(static_cast<int>(i)), report.frames[i])) return Reject::Malformed;
  return ifValid(std::move(report));
}

DecodedControl read(const wire::Goodbye& in) {
  // Causes of a newer minor version are no longer known one by one: they end the connection all the same.
  const bool known = in.cause() >= 0 && in.cause() <= wire::KEY;
  return ifValid(Goodbye{in.reason(), known ? static_cast<GoodbyeCause>(in.cause()) : GoodbyeCause::Leaving});
}

DecodedControl read(const wire::ModeRequest& in) {
  if (in.mode() > static_cast<std::uint32_t>(Mode::Robot)) return Reject::Malformed;
  return ModeRequest{static_cast<Mode>(in.mode())};
}

DecodedControl readTunnelled(const std::string& in) {
  const auto bytes = std::as_bytes(std::span(in));
  return ifValid(Tunnelled{{bytes.begin(), bytes.end()}});
}

void write(const Hello& hello, wire::ControlMessage& message) {
  wire::Hello& out = *message.mutable_hello();
  out.set_major(hello.major);
  out.set_minor(hello.minor);
  out.set_public_key(bytesOf(hello.public_key));
  out.set_keyed(hello.keyed);
}

void write(const Join& join, wire::ControlMessage& message) {
  message.mutable_join()->set_eye(join.eye);
  message.mutable_join()->set_software(join.software);
}

void write(const SessionConfig& welcome, wire::ControlMessage& message) {
  wire::Welcome& out = *message.mutable_welcome();
  out.set_session_id(welcome.session_id);
  out.set_client_id(welcome.client_id);
  write(welcome.scene, *out.mutable_scene());
  out.set_rig_name(welcome.rig.name);
  for (const RigField& field : rigFields()) {
    wire::Measure& measure = *out.add_rig();
    measure.set_name(std::string(field.name));
    measure.set_value(welcome.rig.*(field.value));
  }
  out.set_period_ns(static_cast<std::uint64_t>(welcome.period_ns));
  out.set_frame_ns(static_cast<std::uint64_t>(welcome.frame_ns));
  out.set_udp_port(welcome.udp_port);
  out.set_motion_key(bytesOf(welcome.motion_key));
  out.set_dofs(welcome.form.dofs);
  out.set_compact(welcome.form.compact);
  out.mutable_still()->Assign(welcome.form.still.begin(), welcome.form.still.end());
  if (!welcome.multicast) return;
  out.set_multicast_address(welcome.multicast->address);
  out.set_multicast_port(welcome.multicast->port);
}

void write(const Keyframe& keyframe, wire::ControlMessage& message) {
  wire::Keyframe& out = *message.mutable_keyframe();
  const std::size_t movables = keyframe.world.movables.size();
  const std::size_t doors = keyframe.world.doors.size();
  out.set_number(keyframe.number);
  out.set_movables(static_cast<std::uint32_t>(movables));
  out.set_doors(static_cast<std::uint32_t>(doors));
  writeDifference(blank(movables, doors), keyframe.world, *out.mutable_world());
}

void write(const KeyframeRequest&, wire::ControlMessage& message) {
  message.mutable_keyframe_request();
}

void write(const ClientReport& report, wire::ControlMessage& message) {
  wire::Report& out = *message.mutable_report();
  out.set_packets_received(report.packets_received);
  out.set_packets_lost(report.packets_lost);
  for (const FrameReport& frame : report.frames) {
    wire::FrameReport& told = *out.add_frames();
    told.set_number(frame.number);
    told.set_fate(static_cast<wire::Fate>(frame.fate));
    told.set_tick(frame.tick);
    told.set_hash(frame.hash);
    told.set_presented_server_ns(frame.presented_server_ns);
    told.set_arrived_server_ns(frame.arrived_server_ns);
    told.set_draw_ns(static_cast<std::uint64_t>(frame.draw_ns));
  }
}

void write(const ModeRequest& request, wire::ControlMessage& message) {
  message.mutable_mode_request()->set_mode(static_cast<std::uint32_t>(request.mode));
}

void write(const Tunnelled& tunnelled, wire::ControlMessage& message) {
  message.set_datagram(bytesOf(tunnelled.body));
}

void write(const Goodbye& goodbye, wire::ControlMessage& message) {
  message.mutable_goodbye()->set_reason(goodbye.reason);
  message.mutable_goodbye()->set_cause(static_cast<wire::GoodbyeCause>(goodbye.cause));
}

}  // namespace

void encodeControl(const ControlMessage& message, std::vector<std::byte>& out) {
  wire::ControlMessage coded;
  std::visit(
      [&](const auto& body) {
        assert(isValid(body));
        write(body, coded);
      },
      message);
  const std::size_t size = coded.ByteSizeLong();
  const std::size_t start = out.size();
  out.resize(start + size);
  coded.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + start));
}

DecodedControl decodeControl(std::span<const std::byte> bytes) {
  if (bytes.size() > kMaxControlMessage) return Reject::Oversized;
  wire::ControlMessage message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return Reject::Malformed;
  switch (message.body_case()) {
    case wire::ControlMessage::kHello:
      return read(message.hello());
    case wire::ControlMessage::kJoin:
      return read(message.join());
    case wire::ControlMessage::kWelcome:
      return read(message.welcome());
    case wire::ControlMessage::kKeyframe:
      return read(message.keyframe());
    case wire::ControlMessage::kKeyframeRequest:
      return KeyframeRequest{};
    case wire::ControlMessage::kReport:
      return read(message.report());
    case wire::ControlMessage::kModeRequest:
      return read(message.mode_request());
    case wire::ControlMessage::kDatagram:
      return readTunnelled(message.datagram());
    case wire::ControlMessage::kGoodbye:
      return read(message.goodbye());
    case wire::ControlMessage::BODY_NOT_SET:
      break;
  }
  return Reject::Malformed;
}

}  // namespace coherency
