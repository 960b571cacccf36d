#pragma once

#include <string>

#include <gtest/gtest.h>

#include "common/math/TransformMatrix.h"

namespace coherency {

inline void expectNear(const Coord3& a, const Coord3& b, double tolerance = 1e-12) {
  EXPECT_LE(norm(a - b), tolerance) << "(" << a.x << ' ' << a.y << ' ' << a.z << ") is not (" << b.x << ' '
                                    << b.y << ' ' << b.z << ")";
}

/// Runs `action`; expects an `Error` whose message holds each of `parts`.
template <class Error, class Action, class... Parts>
void expectRefusal(Action&& action, const Parts&... parts) {
  try {
    action();
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    const std::string message = error.what();
    for (const std::string& part : {std::string(parts)...})
      EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' does not say '" << part << "'";
  }
}

}  // namespace coherency
