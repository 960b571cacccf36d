// A hundred thousand steps of one world, and the hash of where they led: built with several compilers,
// optimisations and instruction sets, it must print the same. Input: random (a seeded generator), or the
// samples of a file with 19 integers a line, in the units of the wire.
//
// usage: steps random | steps FILE

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

#include "common/math/FixedPoint.h"
#include "common/world/Snapshot.h"
#include "common/world/World.h"

namespace {

using namespace coherency;

constexpr int kSteps = 100'000;
constexpr double kEdge = 0.055;

SolidBox box(double x, double z, double width, double depth, double low, double high, double heading) {
  SolidBox b;
  b.centre = basePose(x, z, 0.0);
  b.centre.y_nm = nanometresFromMetres(low);
  b.half_x = width / 2;
  b.half_z = depth / 2;
  b.height = high - low;
  const TransformMatrix turn = TransformMatrix::rotationY(heading);
  b.cosine = turn(0, 0);
  b.sine = turn(0, 2);
  return b;
}

/// A room with a table, a turned pillar, a door and both vehicles.
WorldModel model() {
  WorldModel m;
  m.master.footprint = {{0.0, 0.0, 0.4, 0.0, 1.2}, {0.0, -0.6, 0.33, 0.0, 0.6}};
  m.master.start = basePose(0.3, 1.2, 0.2);
  m.robot = m.master;
  m.robot->footprint = {{0.0, 0.0, 0.3, 0.0, 1.2}};
  m.robot->start = basePose(-1.2, -1.4, 2.0);
  m.robot->rig.robot_scale = 1.3;
  m.robot->rig = robotRig(m.robot->rig);
  m.robot->scale = 1.3;
  m.solids = {box(0.0, -0.8, 1.4, 0.7, 0.66, 0.72, 0.1), box(1.4, 0.6, 0.4, 0.3, 0.0, 2.0, 0.7),
              box(-3.1, 0.0, 0.2, 6.4, 0.0, 2.5, 0.0),   box(3.1, 0.0, 0.2, 6.4, 0.0, 2.5, 0.0),
              box(0.0, -3.1, 6.4, 0.2, 0.0, 2.5, 0.0),   box(-1.9, 3.1, 2.6, 0.2, 0.0, 2.5, 0.0),
              box(1.9, 3.1, 2.6, 0.2, 0.0, 2.5, 0.0)};
  m.doors = {{box(0.0, 3.1, 1.2, 0.05, 0.0, 2.1, 0.0), 1.3}};
  for (int i = 0; i < 5; ++i) {
    MovableModel block;
    block.edge = kEdge;
    block.start = basePose(-0.2 + 0.1 * i, -0.7, 0.3 * i);
    block.start.y_nm = nanometresFromMetres(0.72 + kEdge / 2);
    m.movables.push_back(block);
  }
  return m;
}

/// Chance without the standard library's distributions, which differ from one to the next.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  double share() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

class RandomInput {
 public:
  MotionSample next(Chance& chance) {
    if (left_-- > 0) return sample_;
    left_ = static_cast<int>(chance.below(300));
    for (std::size_t i = 0; i < kDofCount; ++i) {
      const DofInfo& dof = dofTable()[i];
      const bool length = dof.kind == DofKind::Length;
      const double low = length ? sample_.si(dofAt(i)) - 0.01 : dof.min;
      const double high = length ? low + 0.02 : dof.max;
      sample_.units[i] = unitsFromSi(dof.kind, low + (high - low) * chance.share());
    }
    sample_.valid = kAllDofs;
    return sample_;
  }

 private:
  MotionSample sample_ = neutralSample(Rig{});
  int left_ = 0;
};

/// Recorded people neither grip nor drive: that is added, the rest is theirs.
class RecordedInput {
 public:
  explicit RecordedInput(const std::string& file) {
    std::ifstream in(file);
    MotionSample sample;
    sample.valid = kAllDofs;
    while (in >> sample.units[0]) {
      for (std::size_t i = 1; i < kDofCount; ++i) in >> sample.units[i];
      samples_.push_back(sample);
    }
    if (samples_.empty()) throw std::runtime_error(file + ": no samples");
  }
  MotionSample next(Chance& chance) {
    MotionSample sample = samples_[at_++ % samples_.size()];
    const MotionSample added = added_.next(chance);
    for (std::size_t i = index(Dof::Grip); i < kDofCount; ++i) sample.units[i] = added.units[i];
    return sample;
  }

 private:
  std::vector<MotionSample> samples_;
  RandomInput added_;
  std::size_t at_ = 0;
};

/// Often a block is put where a hand is about to close, sometimes one is thrown somewhere: all that can
/// happen does.
void disturb(const World& world, WorldState& state, const MotionSample& sample, Chance& chance) {
  const bool closes = state.closed_hands != 3 && sample.si(Dof::Grip) >= kClosesAt;
  if (!closes && chance.share() > 0.002) return;
  Movable& m = state.movables[chance.below(state.movables.size())];
  if (m.holder != Holder::Nobody) return;
  const Holder which = chance.share() < 0.5 ? Holder::OperatorHand : Holder::RobotHand;
  const BasePose& base = which == Holder::RobotHand ? state.robot.base : state.master.base;
  const TransformMatrix t_world_hand = transform(base) * world.hand(which).baseFromHand(sample);
  Coord3 at{-0.3 + 0.6 * chance.share(), 0.73 + 0.4 * chance.share(), -1.0 + 0.5 * chance.share()};
  if (closes) at = t_world_hand.point(world.hand(which).graspPoint());
  m = Movable{};
  m.x_nm = nanometresFromMetres(at.x);
  m.y_nm = nanometresFromMetres(at.y);
  m.z_nm = nanometresFromMetres(at.z);
  setAttitude(m, quaternion(t_world_hand.linear()));
  m.resting = false;
}

template <class Input>
void run(Input input) {
  const World world(model());
  WorldState state = world.initialState();
  Chance chance(20'261'125);
  std::uint64_t all = 0;
  int taken = 0;
  for (int i = 0; i < kSteps; ++i) {
    MotionSample sample = input.next(chance);
    sample.sequence = static_cast<std::uint64_t>(i) + 1;
    if (i % 5000 == 2500) state.mode = state.mode == Mode::Operator ? Mode::Robot : Mode::Operator;
    disturb(world, state, sample, chance);
    if (i == kSteps / 2) state = restore(snapshot(state), world);  // which must change nothing
    const auto held = [&] {
      int count = 0;
      for (const Movable& m : state.movables) count += m.holder != Holder::Nobody;
      return count;
    };
    const int before = held();
    world.step(state, sample, 1'000'000);
    taken += held() > before;
    all = all * 31 + stateHash(state, sample);  // every step counts, not the last alone
  }
  std::printf("%016llx after %d steps, %d times something was taken\n", static_cast<unsigned long long>(all),
              kSteps, taken);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: steps random | steps FILE\n";
    return 2;
  }
  const std::string input = argv[1];
  try {
    if (input == "random")
      run(RandomInput{});
    else
      run(RecordedInput{input});
  } catch (const std::exception& e) {
    std::cerr << "steps: " << e.what() << '\n';
    return 1;
  }
}
