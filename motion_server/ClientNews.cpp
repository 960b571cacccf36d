#include "motion_server/ClientNews.h"

#include <algorithm>

#include <fmt/format.h>

namespace coherency {

std::vector<std::string> ClientNews::since(const std::vector<ClientStatus>& clients) {
  std::vector<std::string> news;
  std::set<std::uint32_t> now;
  for (const ClientStatus& client : clients) {
    const bool was = here_.contains(client.id);
    if (client.connected) now.insert(client.id);
    const bool came_and_went = !was && !client.connected && client.id > newest_;
    if (client.connected == was && !came_and_went) continue;
    news.push_back(fmt::format("client {} at {} ({}) has {}", client.id, client.address, client.eye,
                               client.connected ? "come"
                               : came_and_went  ? "come and gone"
                                                : "gone"));
  }
  for (const ClientStatus& client : clients) newest_ = std::max(newest_, client.id);
  here_ = std::move(now);
  return news;
}

}  // namespace coherency
