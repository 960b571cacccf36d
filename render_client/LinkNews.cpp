#include "render_client/LinkNews.h"

#include <utility>

namespace coherency {

std::optional<std::string> LinkNews::since(const LinkStats& link) {
  const bool was = std::exchange(connected_, link.connected);
  const bool again = std::exchange(connections_, link.connections) < link.connections;
  if (!link.connected && (was || again))
    return "lost the server at " + server_ + ": holding the last pose and trying again";
  if (link.connected && (!was || again)) return "the server at " + server_ + " is back";
  return std::nullopt;
}

}  // namespace coherency
