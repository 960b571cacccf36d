#include "motion_server/ClientNews.h"

#include <fmt/format.h>

namespace coherency {

std::vector<std::string> ClientNews::since(const std::vector<ClientStatus>& clients) {
  std::vector<std::string> news;
  std::set<std::uint32_t> now;
  for (const ClientStatus& client : clients) {
    const bool was = here_.contains(client.id);
    if (client.connected) now.insert(client.id);
    if (client.connected == was) continue;
    news.push_back(fmt::format("client {} at {} ({}) has {}", client.id, client.address, client.eye,
                               client.connected ? "come" : "gone"));
  }
  here_ = std::move(now);
  return news;
}

}  // namespace coherency
