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
    news.push_back(fmt::format("client {} ({}) {} {}", client.id, client.eye,
                               client.connected ? "has come from" : "has left for", client.address));
  }
  here_ = std::move(now);
  return news;
}

}  // namespace coherency
