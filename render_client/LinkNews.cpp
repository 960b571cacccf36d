#include "render_client/LinkNews.h"

#include <utility>

namespace coherency {

std::optional<std::string> LinkNews::since(const LinkStats& link) {
  const bool was = std::exchange(connected_, link.connected);
  const bool again = std::exchange(connections_, link.connections) < link.connections;
  if (!link.connected && (was || again))
    return "lost the server at " + server_ + ": holding the last pose and trying again";
  if (link.connected && (!was || again)) return "the server at " + server_ + " is back";
  const MotionWay before = std::exchange(way_, link.way);
  if (link.way == before) return std::nullopt;
  switch (link.way) {
    case MotionWay::Tcp:
      return "no UDP comes from " + server_ +
             ": motion comes over TCP, later and less often; let UDP through";
    case MotionWay::Multicast:
      return "motion comes by multicast";
    case MotionWay::Udp:
      return "motion comes over UDP";
  }
  return std::nullopt;
}

}  // namespace coherency
