#include "tests/relay/Impairment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace coherency {
namespace {

constexpr std::int64_t kShortestPeriodNs = 1'000'000;
constexpr std::int64_t kLongestNs = 3'600'000'000'000;
constexpr std::size_t kChancesOfOne = 6;

/// Uniform in [0, 1). The standard's own distributions differ between libraries.
double between01(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1.0p-53;
}

std::mt19937_64 engineOf(const ImpairmentStream& stream, std::uint32_t purpose) {
  std::seed_seq sequence{static_cast<std::uint32_t>(stream.seed),
                         static_cast<std::uint32_t>(stream.seed >> 32), stream.flow, stream.direction,
                         purpose};
  return std::mt19937_64(sequence);
}

std::int64_t part(double share, std::int64_t whole_ns) {
  return static_cast<std::int64_t>(share * static_cast<double>(whole_ns));
}

bool probability(double p) {
  return p >= 0.0 && p <= 1.0;  // a NaN is none
}

bool duration(std::int64_t ns) {
  return ns >= 0 && ns <= kLongestNs;
}

bool sameBursts(const ImpairmentSettings& a, const ImpairmentSettings& b) {
  return a.burst_every_ns == b.burst_every_ns && a.burst_ns == b.burst_ns &&
         a.bursts_regular == b.bursts_regular;
}

}  // namespace

std::string faultOf(const ImpairmentSettings& s) {
  if (!probability(s.loss) || !probability(s.duplicate) || !probability(s.corrupt))
    return "loss, duplicate and corrupt are probabilities from 0 to 1";
  if (!duration(s.burst_every_ns) || !duration(s.burst_ns) || !duration(s.delay_ns) || !duration(s.jitter_ns))
    return "times are from 0 to an hour";
  if (s.burst_every_ns != 0 && s.burst_every_ns < kShortestPeriodNs)
    return "bursts are at least 1 ms from one's beginning to the next, or 0 for none";
  if (s.burst_every_ns != 0 && s.burst_ns > s.burst_every_ns)
    return "a burst is no longer than the time from one's beginning to the next";
  return {};
}

Impairment::Impairment(const ImpairmentStream& stream, const ImpairmentSettings& settings,
                       std::int64_t begin_ns)
    : settings_(settings),
      chances_(engineOf(stream, 0)),
      burst_chances_(engineOf(stream, 1)),
      newest_ns_(begin_ns),
      last_leaves_ns_(begin_ns) {
  assert(faultOf(settings).empty());
  burst_begin_ns_ = begin_ns + gap();
}

void Impairment::change(const ImpairmentSettings& settings, std::int64_t now_ns) {
  assert(faultOf(settings).empty() && now_ns >= newest_ns_);
  const bool same = sameBursts(settings, settings_);
  settings_ = settings;
  newest_ns_ = now_ns;
  if (!same) burst_begin_ns_ = now_ns + gap();
}

DatagramFate Impairment::pass(std::int64_t arrival_ns, std::size_t bytes) {
  assert(arrival_ns >= newest_ns_);
  newest_ns_ = arrival_ns;
  std::array<double, kChancesOfOne> chance{};
  for (double& c : chance) c = between01(chances_);
  const auto [lost, jitter, doubled, second_jitter, corrupted, bit] = chance;

  DatagramFate fate;
  using Drop = DatagramFate::Drop;
  const bool burst = inBurst(arrival_ns);
  fate.drop = settings_.block         ? Drop::Blocked
              : burst                 ? Drop::Burst
              : lost < settings_.loss ? Drop::Loss
                                      : Drop::None;
  if (fate.drop != Drop::None) return fate;

  fate.copies = doubled < settings_.duplicate ? 2 : 1;
  const std::int64_t soonest = arrival_ns + settings_.delay_ns;
  fate.leaves_ns = {soonest + part(jitter, settings_.jitter_ns),
                    soonest + part(second_jitter, settings_.jitter_ns)};
  if (fate.copies == 2) std::sort(fate.leaves_ns.begin(), fate.leaves_ns.end());
  if (!settings_.reorder)
    for (int i = 0; i < fate.copies; ++i)
      last_leaves_ns_ = fate.leaves_ns[i] = std::max(last_leaves_ns_, fate.leaves_ns[i]);
  if (corrupted < settings_.corrupt && bytes > 0)
    fate.flipped_bit =
        std::min(8 * bytes - 1, static_cast<std::size_t>(bit * 8.0 * static_cast<double>(bytes)));
  return fate;
}

bool Impairment::inBurst(std::int64_t now_ns) {
  if (settings_.burst_every_ns == 0 || settings_.burst_ns == 0) return false;
  advanceBursts(now_ns);
  return now_ns >= burst_begin_ns_;
}

/// To the first burst that has not ended.
void Impairment::advanceBursts(std::int64_t now_ns) {
  while (now_ns >= burst_begin_ns_ + settings_.burst_ns)
    burst_begin_ns_ += settings_.bursts_regular ? settings_.burst_every_ns : settings_.burst_ns + gap();
}

/// Up to the first burst, and where they are not regular from one's end to the next one's beginning.
std::int64_t Impairment::gap() {
  const double chance = between01(burst_chances_);
  if (settings_.bursts_regular) return part(chance, settings_.burst_every_ns);
  return part(-std::log1p(-chance), settings_.burst_every_ns - settings_.burst_ns);
}

}  // namespace coherency
