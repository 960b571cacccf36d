// A frame in steady state allocates nothing and leaves OpenGL without complaint, from the packet on: the
// laboratory, somebody at work and driving about in it, both eyes, text over the picture.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <epoxy/gl.h>

#include "common/body/Posture.h"
#include "common/config/SceneFile.h"
#include "common/math/FixedPoint.h"
#include "common/motion/SampleGate.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/replica/Replica.h"
#include "tests/render/AllocationCount.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kFrames = 1000;
constexpr int kWidth = 64;
constexpr int kHeight = 48;

/// Counts, while it lives, what OpenGL has to say against what it is asked for (KHR_debug), and keeps the
/// first of it.
class Complaints {
 public:
  Complaints() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(hear, this);
  }
  ~Complaints() {
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  std::size_t count() const { return count_; }
  const char* first() const { return first_.data(); }

 private:
  static void GLAPIENTRY hear(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                              GLsizei length, const GLchar* message, const void* self) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR &&
        type != GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR)
      return;
    auto& complaints = *static_cast<Complaints*>(const_cast<void*>(self));
    if (complaints.count_++ == 0)
      std::snprintf(complaints.first_.data(), complaints.first_.size(), "%.*s", length, message);
  }
  std::size_t count_ = 0;
  std::array<char, 256> first_{};
};

/// What a frame is drawn from.
struct Moment {
  FrameState frame;
  std::string text;
};

/// Somebody who looks about, moves the arm, opens and closes the hand, and drives to and fro.
MasterReading reading(const Rig& rig, int frame) {
  MasterReading reading;
  reading.si = neutralPosture(rig);
  const auto swing = [&](Dof dof, double amplitude, double frames) {
    reading.si[index(dof)] += amplitude * std::sin(kTurn * frame / frames);
  };
  swing(Dof::HeadX, 0.05, 90.0);
  swing(Dof::HeadYaw, 0.9, 140.0);
  swing(Dof::HeadPitch, 0.4, 110.0);
  swing(Dof::ShoulderFlexion, 0.3, 80.0);
  swing(Dof::ElbowFlexion, 0.3, 70.0);
  swing(Dof::WristFlexion, 0.2, 60.0);
  swing(Dof::StickY, 0.9, 200.0);
  swing(Dof::StickTwist, 0.9, 330.0);
  reading.si[index(Dof::Grip)] = frame / 50 % 2;
  return reading;
}

/// A hundred frames as the operator, a hundred as the robot, and so on.
std::vector<Moment> moments(const Scene& scene) {
  const Rig& rig = scene.human().rig();
  SampleGate gate(neutralPosture(rig));
  WorldState state = scene.initialState();
  std::vector<Moment> moments;
  for (int frame = 0; frame < kFrames; ++frame) {
    state.mode = frame / 100 % 2 == 0 ? Mode::Operator : Mode::Robot;
    const MotionSample sample = gate.admit(reading(rig, frame), moments.size() + 1, 0);
    for (int tick = 0; tick < 16; ++tick) scene.world().step(state, sample, 1'000'000);
    std::string text = "frame " + std::to_string(frame) + "\n";
    for (int word = 0; word < frame * 7 % 60; ++word) text += "word ";
    moments.push_back({{moments.size() + 1, sample, state, stateHash(state, sample)}, text});
  }
  return moments;
}

class SteadyFrame : public DrawingTest {};

TEST_F(SteadyFrame, AllocationsAreCountedByWhoAsksForThem) {
  std::array<std::size_t, 5> ours{};
  std::size_t drivers = 0;
  {
    const AllocationCount allocations;
    ours[0] = allocations.ours();
    const std::string longer_than_fits_within(100, '.');
    ours[1] = allocations.ours();
    const std::unique_ptr<void, decltype(&std::free)> bytes(std::calloc(10, 10), std::free);
    ours[2] = allocations.ours();
    struct alignas(64) Line {};
    const auto aligned = std::make_unique<Line>();
    ours[3] = allocations.ours();
    drivers = allocations.others();
    glDeleteShader(glCreateShader(GL_VERTEX_SHADER));
    drivers = allocations.others() - drivers;
    ours[4] = allocations.ours();
  }
  EXPECT_EQ(ours, (std::array<std::size_t, 5>{0, 1, 2, 3, 3}));
  EXPECT_GT(drivers, 0U);
}

TEST_F(SteadyFrame, ComplaintsOfOpenGlAreHeard) {
  const Complaints complaints;
  EXPECT_EQ(complaints.count(), 0U);
  glEnable(GL_NONE);
  EXPECT_EQ(complaints.count(), 1U);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(SteadyFrame, AllocatesNothingAndLeavesNoErrorInOpenGl) {
  SessionConfig session;
  session.scene = readScene("laboratory", COHERENCY_CONFIGS "/scenes");
  Replica replica(session);
  Renderer renderer(replica.scene(), 2 * kWidth, kHeight);
  const HmdProfile hmd;
  const std::vector<Moment> all = moments(replica.scene());
  std::vector<EyeView> views;
  const Complaints complaints;
  const auto draw = [&](const Moment& moment) {
    const bool applied = replica.apply(moment.frame);
    eyeViews(replica.scene(), replica.world().mode, hmd, EyeChoice::Both, kWidth, kHeight, views);
    renderer.draw(views);
    renderer.drawText(views, moment.text);
    display().present();
    return applied;
  };
  // Until it is steady, and the driver has compiled what either mode needs.
  for (std::size_t frame = 0; frame < 300; ++frame) draw(all[frame]);
  const AllocationCount allocations;
  for (std::size_t frame = 0; frame < all.size(); ++frame) {
    ASSERT_TRUE(draw(all[frame]));
    ASSERT_EQ(allocations.ours(), 0U) << "in frame " << frame << ", by\n" << allocations.first();
    ASSERT_EQ(complaints.count(), 0U) << "in frame " << frame << ": " << complaints.first();
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  std::printf("the driver's own allocations: %.0f a frame\n",
              static_cast<double>(allocations.others()) / kFrames);
}

}  // namespace
}  // namespace coherency
