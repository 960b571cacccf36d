#include "common/wire/Key.h"

#include <sodium.h>

#include "common/wire/Sodium.h"

namespace coherency {

Key randomKey() {
  requireSodium();
  Key key;
  randombytes_buf(key.data(), key.size());
  return key;
}

}  // namespace coherency
