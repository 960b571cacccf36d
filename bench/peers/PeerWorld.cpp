#include "bench/peers/PeerWorld.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "common/body/Palette.h"
#include "common/body/Posture.h"
#include "common/config/HmdProfile.h"
#include "common/config/SceneFile.h"
#include "common/motion/SampleGate.h"
#include "common/objects/Grid.h"
#include "common/scene/Primitives.h"
#include "render_client/draw/EyeViews.h"

namespace coherency {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kEyeHeight = 1.7;  // m, above boxes

int columns(std::size_t count) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
}

/// The number in a name such as grid:10000; nothing where it begins with something else.
std::optional<int> countAfter(std::string_view kind, const std::string& name) {
  if (!name.starts_with(kind)) return std::nullopt;
  int count = 0;
  const char* end = name.data() + name.size();
  if (std::from_chars(name.data() + kind.size(), end, count).ptr != end || count < 1)
    throw std::invalid_argument(name + ": how many? A whole number of 1 or more, as in " + std::string(kind) +
                                "10000");
  return count;
}

}  // namespace

TransformMatrix movingPose(std::size_t number, std::size_t count, int frame) {
  const int wide = columns(count);
  const auto i = static_cast<int>(number);
  const double phase = 0.7 * i + 0.05 * frame;
  TransformMatrix pose =
      TransformMatrix::rotationY(phase) * TransformMatrix::rotationX(0.3 * std::sin(0.5 * phase));
  pose.setOrigin(
      {i % wide - 0.5 * (wide - 1), 0.6 + 0.2 * std::sin(phase), -2.0 - static_cast<double>(i / wide)});
  return pose;
}

void PeerWorldOptions::addTo(CLI::App& app) {
  app.add_option("scene", name, "A scene's name, or moving:N")->required();
  app.add_option("--scenes", folder, "Folder of the scenes that are called by name")->capture_default_str();
  app.add_option("--in-view", in_view, "About how many boxes of a grid are; 0: those along the path")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--rays", bake.rays, "For the light at a vertex; 0: no shadows, nothing is cut")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

PeerWorld::PeerWorld(const PeerWorldOptions& options) {
  if (const std::optional<int> moving = countAfter("moving:", options.name))
    makeBoxes(*moving);
  else
    makeScene(options);
}

PeerWorld::~PeerWorld() = default;

void PeerWorld::makeBoxes(int count) {
  constexpr std::array<std::uint32_t, 7> kColours = {0xC9743A, 0x3F72C4, 0x4FA35B, 0xD3B46A,
                                                     0x6B4C78, 0x4E8A8B, 0xB83A2E};
  root_ = std::make_unique<VRObject>("moving");
  for (int i = 0; i < count; ++i) {
    auto box = std::make_unique<Box>(
        Coord3{0.25 + 0.05 * (i * 5 % 7), 0.2 + 0.05 * (i * 7 % 11), 0.25 + 0.06 * (i * 3 % 5)},
        "box " + std::to_string(i + 1));
    box->setMaterial(paint(kColours[static_cast<std::size_t>(i * 4 % 7)], 0.1));
    box->attach(Moving{});
    root_->addMember(box.get());
    boxes_.push_back(std::move(box));
  }
  illumination_.ambient = {{0.3, 0.32, 0.36}, {0.15, 0.15, 0.14}};
  for (const auto& [x, z] : {std::pair{-40.0, 20.0}, {40.0, 10.0}, {-50.0, -110.0}, {30.0, -120.0}})
    illumination_.lamps.push_back({{x, 40.0, z}, {1.0, 0.97, 0.92}, 1500.0, 1000.0});
  t_world_start_ = TransformMatrix::translation({0.0, kEyeHeight, 0.0});
  way_ = 10.0;
  move(poses(0));
}

void PeerWorld::makeScene(const PeerWorldOptions& options) {
  const std::optional<int> boxes = countAfter("grid:", options.name);
  SceneDescription described = readScene(boxes ? "grid:1" : options.name, options.folder);
  if (boxes) described.objects.front().count = *boxes;  // more than a session may have
  auto scene = std::make_unique<Scene>(described, Rig{});
  const auto neutral = neutralPosture(scene->human().rig());
  WorldState state = scene->initialState();
  state.master.base = scene->description().workplace;
  scene->apply(state, SampleGate(neutral).admit({.si = neutral}, 1, 0));
  illumination_ = {scene->lights(), scene->ambient()};
  t_world_start_ = scene->eye(Eye::Left, Mode::Operator).globalTransform();
  if (boxes) t_world_start_.setOrigin({0.0, kEyeHeight, 0.0});
  way_ = boxes ? 10.0 : 0.0;
  rests_ = boxes && options.in_view > 0;
  if (rests_) {
    const FieldOfView view = HmdProfile{}.left.view;
    const double before =
        Grid::kSpacing * std::sqrt(2.0 * options.in_view / (view.tan_left + view.tan_right));
    const double last = -Grid::kFirst - Grid::kSpacing * (columns(static_cast<std::size_t>(*boxes)) - 1);
    t_world_start_.setOrigin({0.0, kEyeHeight, last + before});
  }
  root_ = std::move(scene);
}

std::vector<TransformMatrix> PeerWorld::poses(int frame) const {
  std::vector<TransformMatrix> all;
  for (std::size_t i = 0; i < boxes_.size(); ++i) all.push_back(movingPose(i, boxes_.size(), frame));
  return all;
}

void PeerWorld::move(const std::vector<TransformMatrix>& poses) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i]->setTransform(poses[i]);
}

EyeView PeerWorld::view(int frame) const {
  const double turn = rests_ ? 0.0 : kTurn * (frame % kPathFrames) / kPathFrames;
  const HmdProfile hmd;
  EyeView view;
  view.t_world_eye =
      t_world_start_ *
      TransformMatrix::translation({0.1 * std::sin(turn), 0.0, -way_ * 0.5 * (1.0 - std::cos(turn))}) *
      TransformMatrix::rotationY(std::sin(turn)) *
      TransformMatrix::rotationX(-0.25 + 0.2 * std::cos(2.0 * turn));
  view.view = fitToPicture(hmd.left.view, hmd.panel, kPeerWidth, kPeerHeight);
  view.near_m = hmd.near_m;
  view.width = kPeerWidth;
  view.height = kPeerHeight;
  return view;
}

}  // namespace coherency
