#include "scene/toml_reader.hpp"

#include "messages/error.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::scene {
namespace {

/// A whole number that is not negative; none for any other value.
std::optional<int> indexOf(const toml::node& node) {
  const auto value = node.value_exact<std::int64_t>();
  if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) {
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

}  // namespace

settings::SettingValue settingValueOf(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) {
    return flag->get();
  }
  if (const auto* whole = node.as_integer()) {
    const std::int64_t value = whole->get();
    if (value == static_cast<int>(value)) {
      return static_cast<int>(value);
    }
    return static_cast<double>(value);
  }
  if (const auto* real = node.as_floating_point()) {
    return real->get();
  }
  return node.value_or(std::string("a list"));
}

TomlReader::TomlReader(std::string_view text, const std::string& file) : file_(file) {
  try {
    document_ = std::make_shared<const toml::table>(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    throw messages::InputError(file + ":" + std::to_string(error.source().begin.line) +
                               ": this is not valid TOML: " + std::string(error.description()));
  }
  table_ = document_.get();
}

TomlReader::TomlReader(const TomlReader& parent, std::string where, const toml::table& table)
    : file_(parent.file_), where_(std::move(where)), document_(parent.document_), table_(&table) {}

void TomlReader::fail(const toml::node& node, const std::string& message) const {
  throw messages::InputError(placeOf(node) + ": " + message);
}

void TomlReader::failAt(std::string_view key, const std::string& message) const {
  throw messages::InputError(place(key) + ": " + message);
}

std::string TomlReader::placeOf(const toml::node& node) const {
  return file_ + ":" + std::to_string(node.source().begin.line);
}

std::size_t TomlReader::line() const {
  return table_->source().begin.line;
}

std::string TomlReader::place(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return placeOf(node == nullptr ? static_cast<const toml::node&>(*table_) : *node);
}

std::string TomlReader::nameOf(std::string_view key) const {
  return where_.empty() ? std::string(key) : where_ + "." + std::string(key);
}

void TomlReader::allowOnly(const std::vector<std::string_view>& keys) const {
  for (const auto& [key, node] : *table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
      fail(node, fmt::format("there is no '{}'; known keys here: {}", nameOf(key.str()), fmt::join(keys, ", ")));
    }
  }
}

std::optional<std::string> TomlReader::text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  if (const auto* value = node->as_string()) {
    return value->get();
  }
  fail(*node, nameOf(key) + " must be a text in quotes");
}

std::optional<bool> TomlReader::flag(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  if (const auto* value = node->as_boolean()) {
    return value->get();
  }
  fail(*node, nameOf(key) + " must be true or false");
}

std::optional<double> TomlReader::number(std::string_view key, double min, double max) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !(*value >= min && *value <= max)) {
    fail(*node, fmt::format("{} must be a number from {:g} to {:g}", nameOf(key), min, max));
  }
  return value;
}

std::optional<int> TomlReader::integer(std::string_view key, int min, int max) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  const auto* value = node->as_integer();
  if (value == nullptr || value->get() < min || value->get() > max) {
    fail(*node, fmt::format("{} must be a whole number from {} to {}", nameOf(key), min, max));
  }
  return static_cast<int>(value->get());
}

Vec3 TomlReader::asVector(const toml::node& node, std::string_view key, double limit) const {
  const toml::array* array = node.as_array();
  Vec3 vector = Vec3::Zero();
  const bool three = array != nullptr && array->size() == 3;
  for (std::size_t i = 0; three && i < 3; ++i) {
    const toml::node& entry = *array->get(i);
    vector[static_cast<Eigen::Index>(i)] =
        entry.is_number() ? *entry.value<double>() : std::numeric_limits<double>::quiet_NaN();
  }
  if (!three || !vector.allFinite()) {
    fail(node, nameOf(key) + " must be three finite numbers: [x, y, z]");
  }
  if (vector.cwiseAbs().maxCoeff() > limit) {
    fail(node, fmt::format("{} must be three numbers from {:g} to {:g}", nameOf(key), -limit, limit));
  }
  return vector;
}

std::optional<Vec3> TomlReader::vector(std::string_view key, double limit) const {
  const toml::node* node = table_->get(key);
  return node == nullptr ? std::nullopt : std::optional(asVector(*node, key, limit));
}

std::optional<TomlReader> TomlReader::table(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  if (const toml::table* table = node->as_table()) {
    return TomlReader(*this, nameOf(key), *table);
  }
  fail(*node, nameOf(key) + " must be a table: [" + nameOf(key) + "]");
}

template <typename T, typename Convert>
std::vector<T> TomlReader::list(std::string_view key, const char* expected, const Convert& convert) const {
  std::vector<T> values;
  const toml::node* node = table_->get(key);
  if (node == nullptr) {
    return values;
  }
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    fail(*node, nameOf(key) + " must be a list of " + expected);
  }
  for (const toml::node& entry : *array) {
    std::optional<T> value = convert(entry);
    if (!value) {
      fail(entry, nameOf(key) + " must be a list of " + expected);
    }
    values.push_back(std::move(*value));
  }
  return values;
}

std::vector<std::string> TomlReader::texts(std::string_view key) const {
  return list<std::string>(key, "texts", [](const toml::node& entry) { return entry.value_exact<std::string>(); });
}

std::vector<int> TomlReader::integers(std::string_view key) const {
  return list<int>(key, "whole numbers", indexOf);
}

std::vector<std::array<int, 2>> TomlReader::pairs(std::string_view key) const {
  return list<std::array<int, 2>>(key, "pairs of vertices [a, b]",
                                  [](const toml::node& entry) -> std::optional<std::array<int, 2>> {
                                    const toml::array* both = entry.as_array();
                                    if (both == nullptr || both->size() != 2) {
                                      return std::nullopt;
                                    }
                                    const std::optional<int> first = indexOf(*both->get(0));
                                    const std::optional<int> second = indexOf(*both->get(1));
                                    return first && second ? std::optional(std::array{*first, *second}) : std::nullopt;
                                  });
}

std::vector<Vec3> TomlReader::vectors(std::string_view key) const {
  return list<Vec3>(key, "points: [[x, y, z], ...]", [&](const toml::node& entry) {
    return entry.is_array() ? std::optional(asVector(entry, key, farAway)) : std::nullopt;
  });
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
  return list<TomlReader>(key, "tables", [&](const toml::node& entry) -> std::optional<TomlReader> {
    const toml::table* table = entry.as_table();
    return table == nullptr ? std::nullopt : std::optional(TomlReader(*this, nameOf(key), *table));
  });
}

std::vector<TomlReader> TomlReader::tableOrTables(std::string_view key) const {
  if (has(key) && table_->get(key)->is_table()) {
    return {*table(key)};
  }
  return tables(key);
}

void TomlReader::visitBelow(const std::string& prefix, const toml::table& table,
                            const std::function<void(const std::string&, const toml::node&)>& visit) const {
  for (const auto& [key, node] : table) {
    const std::string dotted = prefix.empty() ? std::string(key.str()) : prefix + "." + std::string(key.str());
    if (const toml::table* below = node.as_table()) {
      visitBelow(dotted, *below, visit);
    } else {
      visit(dotted, node);
    }
  }
}

void TomlReader::forEachValue(const std::function<void(const std::string&, const toml::node&)>& visit) const {
  visitBelow("", *table_, visit);
}

}  // namespace drape::scene
