#include "render_client/receive/NameLookup.h"

#include <array>
#include <memory>
#include <system_error>
#include <thread>

#include <netdb.h>
#include <sys/socket.h>

namespace coherency {
namespace {

NameAnswer ask(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  NameAnswer answer;
  const int failure = ::getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (failure != 0) {
    answer.error = ::gai_strerror(failure);
    return answer;
  }
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
  for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
    std::array<char, NI_MAXHOST> text{};
    if (::getnameinfo(entry->ai_addr, entry->ai_addrlen, text.data(), text.size(), nullptr, 0,
                      NI_NUMERICHOST) == 0) {
      answer.addresses.emplace_back(text.data());
    }
  }
  if (answer.addresses.empty()) answer.error = "the name has no address";
  return answer;
}

}  // namespace

void lookUpName(const std::string& host, std::function<void(const NameAnswer&)> done) {
  std::thread([host, done = std::move(done)] { done(ask(host)); }).detach();
}

}  // namespace coherency
