#include "common/sync/SlewedMapping.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace coherency {

void SlewedMapping::steer(ClientTime now, std::int64_t offset_ns, double skew) {
  assert(std::abs(skew) <= 0.01 && (!set_ || now >= slewing_.client));
  const ServerTime target{now.ns + offset_ns};
  if (!set_ || std::abs(toServer(now) - target) > kStepNs) {
    set_ = true;
    before_ = slewing_ = arrived_ = {now, target, skew};
    return;
  }
  const ServerTime here = toServer(now);
  const auto ahead = static_cast<double>(here - target);
  const double room = kMaxRate - std::abs(skew);
  const std::int64_t takes =
      std::max(kSpreadNs, static_cast<std::int64_t>(std::ceil(std::abs(ahead) / room)));
  if (now > slewing_.client) before_ = now < arrived_.client ? slewing_ : arrived_;
  slewing_ = {now, here, skew - ahead / static_cast<double>(takes)};
  arrived_ = {now + takes, slewing_.toServer(now + takes), skew};
}

ServerTime SlewedMapping::toServer(ClientTime t) const {
  const Ray& ray = t < slewing_.client ? before_ : t < arrived_.client ? slewing_ : arrived_;
  return ray.toServer(t);
}

ClientTime SlewedMapping::toClient(ServerTime t) const {
  const Ray& ray = t < slewing_.server ? before_ : t < arrived_.server ? slewing_ : arrived_;
  return ray.toClient(t);
}

ServerTime SlewedMapping::Ray::toServer(ClientTime t) const {
  const std::int64_t since = t - client;
  return server + since + std::llround(rate * static_cast<double>(since));
}

ClientTime SlewedMapping::Ray::toClient(ServerTime t) const {
  const std::int64_t since = t - server;
  return client + since - std::llround(rate / (1.0 + rate) * static_cast<double>(since));
}

}  // namespace coherency
