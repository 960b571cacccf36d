#include "common/config/TomlTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "common/config/Shipped.h"
#include "common/world/Names.h"

namespace coherency {
namespace {

std::string place(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

std::string join(const auto& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

}  // namespace

toml::table parseTomlFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw ConfigError(
        fmt::format("{}: is a folder; name a TOML file in it, there are: {}", path, namesIn(path)));
  if (!std::filesystem::is_regular_file(path, ignored))
    throw ConfigError(fmt::format("{}: no such file; name an existing TOML file", path));
  try {
    return toml::parse_file(path);
  } catch (const toml::parse_error& e) {
    throw ConfigError(fmt::format("{}: {}", place(path, e.source()), e.description()));
  }
}

TomlTable::TomlTable(const toml::table* table, std::string file, std::string name)
    : table_(table), file_(std::move(file)), name_(std::move(name)) {}

const toml::node* TomlTable::find(std::string_view key) {
  known_.emplace(key);
  return table_ == nullptr ? nullptr : table_->get(key);
}

ConfigError TomlTable::error(std::string_view key, const std::string& what) const {
  const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
  if (node == nullptr) node = table_;
  const std::string where = node == nullptr ? file_ : place(file_, node->source());
  const std::string full = name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
  return ConfigError(fmt::format("{}: {}: {}", where, full, what));
}

double TomlTable::number(std::string_view key, double fallback, double min, double max) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value) throw error(key, fmt::format("must be a number from {} to {}", min, max));
  if (!(*value >= min && *value <= max))
    throw error(key, fmt::format("{} is out of range; must be from {} to {}", *value, min, max));
  return *value;
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t fallback, std::int64_t min,
                                std::int64_t max) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  const auto* value = node->as_integer();
  if (value == nullptr) throw error(key, fmt::format("must be a whole number from {} to {}", min, max));
  if (value->get() < min || value->get() > max)
    throw error(key, fmt::format("{} is out of range; must be from {} to {}", value->get(), min, max));
  return value->get();
}

bool TomlTable::flag(std::string_view key, bool fallback) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  if (!node->is_boolean()) throw error(key, "must be true or false");
  return node->as_boolean()->get();
}

std::string TomlTable::text(std::string_view key, const std::string& fallback) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  if (!node->is_string()) throw error(key, "must be a text in quotes");
  return node->as_string()->get();
}

std::string TomlTable::plainText(std::string_view key, const std::string& fallback) {
  std::string value = text(key, fallback);
  if (!isPlainText(value))
    throw error(key,
                fmt::format("\"{}\" is shown on every machine: it must be of printable ASCII characters, "
                            "as \"{}\", at most {} of them",
                            value, coherency::plainText(value), kMaxText));
  return value;
}

std::string TomlTable::oneOf(std::string_view key, const std::string& fallback,
                             std::initializer_list<std::string_view> allowed) {
  std::string value = text(key, fallback);
  for (const auto& name : allowed)
    if (value == name) return value;
  throw error(key, fmt::format("\"{}\" is not known; must be one of: {}", value, join(allowed)));
}

TomlTable TomlTable::table(std::string_view key) {
  const toml::node* node = find(key);
  const std::string full = name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
  if (node != nullptr && !node->is_table()) throw error(key, fmt::format("must be a table: [{}]", full));
  return {node == nullptr ? nullptr : node->as_table(), file_, full};
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t count, double min, double max) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const auto wrong = [&] {
    return error(key, fmt::format("must be {} numbers from {} to {} in brackets", count, min, max));
  };
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != count) throw wrong();
  std::vector<double> values;
  for (const toml::node& element : *list) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !(*value >= min && *value <= max)) throw wrong();
    values.push_back(*value);
  }
  return values;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr ||
      !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); }))
    throw error(key, fmt::format("must be tables: [[{}]]", key));
  std::vector<TomlTable> all;
  for (const toml::node& element : *list)
    all.emplace_back(element.as_table(), file_, fmt::format("{}[{}]", key, all.size()));
  return all;
}

void TomlTable::finish() const {
  if (table_ == nullptr) return;
  for (const auto& [key, node] : *table_)
    if (!known_.contains(std::string_view(key)))
      throw error(key.str(), fmt::format("is not a known key here; known are: {}", join(known_)));
}

}  // namespace coherency
