#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace coherency {

// What the programs' Options.cpp share, and only they include: CLI11 is their affair.

/// Checks that an option is a number within limits; CLI::Range lets NaN pass.
inline CLI::Validator finite(double min, double max) {
  const auto check = [min, max](const std::string& text) {
    double value = 0.0;
    const bool good =
        CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= min && value <= max;
    return good ? std::string() : fmt::format("\"{}\" is not a number from {} to {}", text, min, max);
  };
  return {check, ""};
}

/// Checks that an option is a whole number within limits; for unsigned ones CLI11 lets -1 be the largest.
inline CLI::Validator whole(std::int64_t min, std::int64_t max) {
  const auto check = [min, max](const std::string& text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good =
        error == std::errc{} && end == text.data() + text.size() && value >= min && value <= max;
    return good ? std::string() : fmt::format("\"{}\" is not a whole number from {} to {}", text, min, max);
  };
  return {check, ""};
}

/// Parses the command line. -1: go on; else the program ends with it: 0 after --help and --version, 2 for
/// what is wrong, which has then been said on stderr.
inline int parseArguments(CLI::App& app, int argc, char** argv, const std::string& program) {
  app.allow_extras();
  std::string wrong;
  try {
    app.parse(argc, argv);
    if (const auto extra = app.remaining(); !extra.empty())
      wrong = fmt::format("\"{}\" is no option of this program", extra.front());
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    wrong = e.what();
  }
  if (wrong.empty()) return -1;
  fmt::print(stderr, "{}: {}; --help names every option and what it takes\n", program, wrong);
  return 2;
}

}  // namespace coherency
