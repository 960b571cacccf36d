#include "common/world/Scene.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <stdexcept>

#include "common/body/Grip.h"
#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"
#include "common/world/Catalogue.h"
#include "common/world/Scatter.h"

namespace coherency {

namespace {

DofMask dofsFrom(Dof first, Dof last) {
  DofMask all = 0;
  for (std::size_t i = index(first); i <= index(last); ++i) all |= mask(dofAt(i));
  return all;
}

VehicleModel vehicle(const std::vector<FootprintDisc>& footprint, const Rig& rig, double scale,
                     const BasePose& start) {
  VehicleModel model;
  model.footprint = footprint;
  model.rig = rig;
  model.scale = scale;
  model.start = start;
  return model;
}

void checkName(const std::string& name) {
  static const std::set<std::string> reserved = {"virtual human", "slave robot", "master system"};
  if (name.empty() || name.find('/') != std::string::npos || reserved.contains(name))
    throw std::invalid_argument("an object cannot be called '" + name +
                                "'; a name has one letter or more, no '/', and is none of: master system, "
                                "slave robot, virtual human");
}

/// How far a vehicle reaches ahead of its base where it is tallest: what does not go under a table; m.
double front(const std::vector<FootprintDisc>& footprint) {
  double tallest = 0.0;
  for (const FootprintDisc& disc : footprint) tallest = std::max(tallest, disc.high);
  double ahead = 0.0;
  for (const FootprintDisc& disc : footprint)
    if (disc.high == tallest) ahead = std::max(ahead, disc.radius - disc.z);
  return ahead;
}

BasePose movedAhead(BasePose base, double by_m) {
  const SineCosine heading = sineCosine(radiansFromUnits(base.heading_units));
  base.x_nm = movedBy(base.x_nm, -heading.sine * by_m);
  base.z_nm = movedBy(base.z_nm, -heading.cosine * by_m);
  return base;
}

/// Fingers do not go into what they hold.
MotionSample aroundHeld(const MotionSample& sample, const WorldState& state, Holder hand) {
  const bool holds = std::any_of(state.movables.begin(), state.movables.end(),
                                 [&](const Movable& m) { return m.holder == hand; });
  if (!holds) return sample;
  MotionSample shown = sample;
  std::int32_t& grip = shown.units[index(Dof::Grip)];
  grip = std::min(grip, unitsFromRatio(kHoldingGrip));
  return shown;
}

/// Each measure may be in its range, and all together nothing that a body can have.
const Rig& buildable(const Rig& rig) {
  validate(rig);
  try {
    const VirtualHuman human(rig);
    const SlaveRobot robot(robotRig(rig));
  } catch (const std::invalid_argument& e) {
    throw std::domain_error("rig '" + rig.name + "': no body has these measures together (" + e.what() +
                            "); take proportions nearer to those of configs/rigs/default.toml");
  }
  return rig;
}

}  // namespace

Scene::Scene(const SceneDescription& description, const Rig& rig)
    : VRObject(description.name),
      description_(description),
      rig_(buildable(rig)),
      human_(rig, description.operator_shown ? HumanShown::Whole : HumanShown::None) {
  addMember(&human_);
  Stage stage{rig_, human_};
  addObjects(stage);
  WorldModel model;
  model.driving = description.driving;
  // Eyes alone, that stay where they are, take up no floor.
  const bool takes_room = description.driving || description.operator_shown;
  model.master =
      vehicle(takes_room ? masterFootprint(rig) : std::vector<FootprintDisc>{}, rig, 1.0, description.start);
  if (description.robot) {
    robot_ = std::make_unique<SlaveRobot>(robotRig(rig));
    addMember(robot_.get());
    model.robot =
        vehicle(robotFootprint(robotRig(rig)), robotRig(rig), rig.robot_scale, description.robot->start);
  }
  gather(model);
  world_ = std::make_unique<World>(std::move(model));
  const WorldState start = initialState();
  apply(start, neutralSample(rig_));
}

Scene::~Scene() = default;

void Scene::addObjects(Stage& stage) {
  std::set<std::string> names;
  for (const ObjectPlacement& placement : description_.objects) {
    checkName(placement.name);
    if (!names.insert(placement.name).second)
      throw std::invalid_argument("two objects are called '" + placement.name +
                                  "'; give one of them another name: name = \"...\" in its [[object]]");
    objects_.push_back(makeObject(placement, stage));
    addMember(objects_.back().get());
  }
}

void Scene::gather(WorldModel& model) {
  std::vector<VRObject*> objects;
  for (const auto& object : objects_) objects.push_back(object.get());
  objects.push_back(&human_);
  if (robot_) objects.push_back(robot_.get());
  Gathered found = coherency::gather(objects);
  model.solids = std::move(found.solids);
  model.doors = std::move(found.doors);
  model.movables = std::move(found.movables);
  movables_ = std::move(found.carried);
  doors_ = std::move(found.leaves);
  lights_ = std::move(found.lights);
  targets_ = std::move(found.targets);
  if (!found.ambients.empty()) ambient_ = found.ambients.front();
  placeWork(model);
  checkPlaces(model, places(Mode::Operator), description_.robot ? places(Mode::Robot) : VehiclePlaces{});
  if (!description_.scatter) return;
  WorldState start = World(model).initialState();
  scatter(start, model, *description_.scatter, 1);  // there is room
}

VehiclePlaces Scene::places(Mode mode) const {
  const BasePose start = mode == Mode::Robot ? description_.robot->start : description_.start;
  if (!description_.driving) return {start, std::nullopt};
  return {start, workplace(mode)};
}

const ViewPoint& Scene::eye(Eye which, Mode mode) const {
  return mode == Mode::Robot && robot_ ? robot_->eye(which) : human_.eye(which);
}

const VRObject& Scene::hand(Mode mode) const {
  return mode == Mode::Robot && robot_ ? robot_->rightHand() : human_.rightHand();
}

/// A scene's workplaces are for bodies of the default rig's size. Others have their front as far from the
/// table, and stand back from what their knees do not go under.
void Scene::placeWork(const WorldModel& model) {
  constexpr double kStep = 0.01;  // m
  constexpr int kSteps = 150;
  const auto fitted = [&](const BasePose& workplace, const VehicleModel& vehicle,
                          const std::vector<FootprintDisc>& usual) {
    if (rig_ == Rig{}) return workplace;
    const BasePose nearest = movedAhead(workplace, front(usual) - front(vehicle.footprint));
    for (int step = 0; step <= kSteps; ++step)
      if (const BasePose base = movedAhead(nearest, -kStep * step); standsFree(base, vehicle, model))
        return base;
    return nearest;
  };
  const Rig usual;
  workplace_ = fitted(description_.workplace, model.master, masterFootprint(usual));
  if (model.robot)
    robot_workplace_ = fitted(description_.robot->workplace, *model.robot, robotFootprint(usual));
}

BasePose Scene::workplace(Mode mode) const {
  assert(mode == Mode::Operator || description_.robot);
  return mode == Mode::Operator ? workplace_ : robot_workplace_;
}

WorldState Scene::initialState(std::uint64_t seed) const {
  WorldState state = world_->initialState();
  if (seed == 0 || movables_.empty()) return state;
  if (!description_.scatter)
    throw std::invalid_argument(
        "scene '" + description_.name + "' has things to grasp, but not where to strew them for world seed " +
        std::to_string(seed) +
        "; give it scatter = [x from, x to, z from, z to], or take world seed 0, which leaves them in place");
  scatter(state, world_->model(), *description_.scatter, seed);
  return state;
}

DofMask Scene::dofs() const {
  if (description_.operator_shown || robot_) return kAllDofs;
  DofMask needed = dofsFrom(Dof::HeadX, Dof::HeadRoll);
  if (!movables_.empty() || !human_.rightHand().members().empty())
    needed |= dofsFrom(Dof::ShoulderFlexion, Dof::Grip);
  if (description_.driving) needed |= dofsFrom(Dof::StickX, Dof::PedalRight);
  return needed;
}

void Scene::apply(const WorldState& state, const MotionSample& sample) {
  assert(fits(state));
  human_.setTransform(coherency::transform(state.master.base));
  human_.setSample(aroundHeld(sample, state, Holder::OperatorHand));
  if (robot_) {
    robot_->setTransform(coherency::transform(state.robot.base));
    robot_->setSample(scaled(aroundHeld(sample, state, Holder::RobotHand), rig_.robot_scale));
  }
  for (std::size_t i = 0; i < doors_.size(); ++i)
    doors_[i].leaf->setPosition(doors_[i].closed + doors_[i].slide * ratioFromUnits(state.doors[i]));
  applyMovables(state);
}

void Scene::applyMovables(const WorldState& state) {
  for (std::size_t i = 0; i < movables_.size(); ++i) {
    const Movable& m = state.movables[i];
    TransformMatrix t_world_movable = coherency::transform(m);
    if (m.holder == Holder::OperatorHand)
      t_world_movable = human_.rightHand().globalTransform() * t_world_movable;
    else if (m.holder == Holder::RobotHand && robot_)
      t_world_movable = robot_->rightHand().globalTransform() * t_world_movable;
    movables_[i]->setGlobalTransform(t_world_movable);
  }
}

}  // namespace coherency
