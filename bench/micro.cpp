// Costs of the steps of a sample's and a frame's way, one by one.
#include <vector>

#include <benchmark/benchmark.h>

#include "common/body/Posture.h"
#include "common/config/SceneFile.h"
#include "common/motion/SampleGate.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "common/world/Scene.h"

namespace {

using namespace coherency;

MotionSample measuredSample() {
  SampleGate gate(neutralPosture(Rig{}));
  MasterReading reading;
  reading.si = neutralPosture(Rig{});
  return gate.admit(reading, 1, 1);
}

void gate(benchmark::State& state) {
  SampleGate gate(neutralPosture(Rig{}));
  MasterReading reading;
  reading.si = neutralPosture(Rig{});
  std::uint64_t sequence = 0;
  for (auto _ : state) benchmark::DoNotOptimize(gate.admit(reading, ++sequence, 1));
}
BENCHMARK(gate);

SceneDescription laboratory() {
  return readScene("laboratory", COHERENCY_CONFIGS "/scenes");
}

void stepWorld(benchmark::State& state) {
  const Scene scene(laboratory(), Rig{});
  WorldState world = scene.initialState();
  const MotionSample sample = measuredSample();
  for (auto _ : state) scene.world().step(world, sample, 1'000'000);
  benchmark::DoNotOptimize(world);
}
BENCHMARK(stepWorld);

void hash(benchmark::State& state) {
  const WorldState world = Scene(laboratory(), Rig{}).initialState();
  const MotionSample sample = measuredSample();
  for (auto _ : state) benchmark::DoNotOptimize(stateHash(world, sample));
}
BENCHMARK(hash);

void bodyPosture(benchmark::State& state) {
  const Rig rig;
  const ArmKinematics arm(rig);
  const MotionSample sample = measuredSample();
  for (auto _ : state) benchmark::DoNotOptimize(posture(rig, arm, sample));
}
BENCHMARK(bodyPosture);

void applyToScene(benchmark::State& state) {
  Scene scene(laboratory(), Rig{});
  const WorldState world = scene.initialState();
  const MotionSample sample = measuredSample();
  for (auto _ : state) scene.apply(world, sample);
}
BENCHMARK(applyToScene);

void inverseKinematics(benchmark::State& state) {
  const ArmKinematics arm{Rig{}};
  const ArmJoints seed = armJoints(measuredSample());
  const Coord3 palm = arm.pose(seed).palm + Coord3{0.1, 0.1, -0.1};
  for (auto _ : state) benchmark::DoNotOptimize(arm.solve(palm, nullptr, seed));
}
BENCHMARK(inverseKinematics);

void seal(benchmark::State& state) {
  DatagramSealer sealer(randomKey(), 1);
  std::vector<std::byte> datagram;
  for (auto _ : state) {
    sealer.begin(datagram);
    datagram.resize(kSealedHeader + static_cast<std::size_t>(state.range(0)));
    sealer.seal(datagram);
    benchmark::DoNotOptimize(datagram.data());
  }
}
BENCHMARK(seal)->Arg(300)->Arg(1000);

/// A datagram opens once: they are sealed beforehand, untimed.
void open(benchmark::State& state) {
  const Key key = randomKey();
  DatagramSealer sealer(key, 1);
  DatagramOpener opener(key, 1);
  std::vector<std::vector<std::byte>> datagrams(1024);
  std::size_t next = datagrams.size();
  for (auto _ : state) {
    if (next == datagrams.size()) {
      state.PauseTiming();
      for (auto& datagram : datagrams) {
        sealer.begin(datagram);
        datagram.resize(kSealedHeader + static_cast<std::size_t>(state.range(0)));
        sealer.seal(datagram);
      }
      next = 0;
      state.ResumeTiming();
    }
    if (std::holds_alternative<Reject>(opener.open(datagrams[next++]))) state.SkipWithError("refused");
  }
}
BENCHMARK(open)->Arg(300)->Arg(1000);

}  // namespace

BENCHMARK_MAIN();
