#include "common/wire/Sodium.h"

#include <stdexcept>

#include <sodium.h>

namespace coherency {

void requireSodium() {
  static const bool ready = [] {
    if (sodium_init() < 0) {
      throw std::runtime_error("libsodium cannot start; it needs getrandom() or a readable /dev/urandom");
    }
    return true;
  }();
  (void)ready;
}

}  // namespace coherency
