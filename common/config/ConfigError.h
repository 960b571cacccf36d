#pragma once

#include <stdexcept>
#include <string>

namespace coherency {

/// A configuration file or an argument that cannot be used. The message reads `file:line:column: what is
/// wrong; what would be right`. Programs end with exit status 2.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace coherency
