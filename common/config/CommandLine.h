#pragma once

#include <cmath>
#include <string>

#include <CLI/CLI.hpp>

namespace coherency {

/// Checks that an option is a number within limits; CLI::Range lets NaN pass. Only for the programs'
/// Options.cpp.
inline CLI::Validator finite(double min, double max) {
  const auto check = [min, max](const std::string& text) {
    double value = 0.0;
    const bool good =
        CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= min && value <= max;
    return good ? std::string{}
                : "'" + text + "' is not a number from " + CLI::detail::to_string(min) + " to " +
                      CLI::detail::to_string(max);
  };
  return {check, "NUMBER"};
}

}  // namespace coherency
