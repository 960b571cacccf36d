#pragma once

#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "common/config/ConfigError.h"

namespace coherency {

/// Parses a TOML file; throws ConfigError for a file that is missing, unreadable or malformed.
toml::table parseTomlFile(const std::string& path);

/// Reads one table of a file key by key; every getter checks type and range and throws ConfigError with file,
/// line and column. A key that is absent gives the fallback. finish() refuses keys nobody asked for, so that
/// a misspelt one is never silently ignored. Internal to common/config.
class TomlTable {
 public:
  /// `table` may be null (the whole table is absent: fallbacks hold). `name` is its dotted name, empty for
  /// the root.
  TomlTable(const toml::table* table, std::string file, std::string name);

  double number(std::string_view key, double fallback, double min, double max);
  std::int64_t integer(std::string_view key, std::int64_t fallback, std::int64_t min, std::int64_t max);
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key, const std::string& fallback);
  /// A text that isPlainText() (Names.h), as whatever is shown on other machines must be.
  std::string plainText(std::string_view key, const std::string& fallback);
  std::string oneOf(std::string_view key, const std::string& fallback,
                    std::initializer_list<std::string_view> allowed);
  /// `count` numbers in brackets; empty where the key is absent.
  std::vector<double> numbers(std::string_view key, std::size_t count, double min, double max);
  TomlTable table(std::string_view key);
  /// An array of tables, [[key]]; empty where it is absent.
  std::vector<TomlTable> tables(std::string_view key);
  bool has(std::string_view key) const { return table_ != nullptr && table_->contains(key); }

  void finish() const;
  /// ConfigError placed at `key` (or at the table where the key is absent).
  ConfigError error(std::string_view key, const std::string& what) const;

 private:
  const toml::node* find(std::string_view key);

  const toml::table* table_;
  std::string file_;
  std::string name_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace coherency
