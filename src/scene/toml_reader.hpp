#pragma once

#include "settings/settings_table.hpp"
#include "sim/model/vector.hpp"

#include <toml++/toml.h>
#include <array>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// A larger coordinate in a scene is an error [m].
inline constexpr double farAway = 1e4;

/// Angles are in degrees in scene files [rad].
inline constexpr double degree = std::numbers::pi / 180.0;

/// A value as a setting takes it; a list becomes a text that no setting takes.
[[nodiscard]] settings::SettingValue settingValueOf(const toml::node& node);

/// Checked access to a TOML table. Every wrong type or unknown key becomes an InputError with file, line and key.
class TomlReader {
 public:
  /// The top of a document. Throws InputError when the text is not TOML.
  /// @param file for messages
  TomlReader(std::string_view text, const std::string& file);

  /// Throws unless all keys are in the list.
  void allowOnly(const std::vector<std::string_view>& keys) const;

  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
  [[nodiscard]] std::optional<bool> flag(std::string_view key) const;
  [[nodiscard]] std::optional<double> number(std::string_view key, double min, double max) const;
  [[nodiscard]] std::optional<int> integer(std::string_view key, int min, int max) const;
  /// Three numbers with magnitudes up to `limit`.
  [[nodiscard]] std::optional<Vec3> vector(std::string_view key, double limit = farAway) const;
  [[nodiscard]] std::optional<TomlReader> table(std::string_view key) const;

  /// Lists; empty when the key is absent.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] std::vector<int> integers(std::string_view key) const;
  [[nodiscard]] std::vector<Vec3> vectors(std::string_view key) const;
  /// Lists of two whole numbers, none negative.
  [[nodiscard]] std::vector<std::array<int, 2>> pairs(std::string_view key) const;
  [[nodiscard]] std::vector<TomlReader> tables(std::string_view key) const;
  /// The same, where a single table counts as a list of one.
  [[nodiscard]] std::vector<TomlReader> tableOrTables(std::string_view key) const;

  /// Visits every value below the table with its dotted key.
  void forEachValue(const std::function<void(const std::string& key, const toml::node& node)>& visit) const;

  /// "file:line" of the key, or of the start of this table when there is no such key.
  [[nodiscard]] std::string place(std::string_view key = {}) const;

  /// The line where this table starts; the first is 1.
  [[nodiscard]] std::size_t line() const;

  /// "file:line" of a value.
  [[nodiscard]] std::string placeOf(const toml::node& node) const;

  /// Throws InputError "file:line: message".
  [[noreturn]] void fail(const toml::node& node, const std::string& message) const;
  /// The same, at the key, or at the start of this table when there is no such key.
  [[noreturn]] void failAt(std::string_view key, const std::string& message) const;
  /// The same, at the start of this table.
  [[noreturn]] void fail(const std::string& message) const { fail(*table_, message); }

 private:
  TomlReader(const TomlReader& parent, std::string where, const toml::table& table);

  [[nodiscard]] std::string nameOf(std::string_view key) const;
  [[nodiscard]] Vec3 asVector(const toml::node& node, std::string_view key, double limit) const;
  void visitBelow(const std::string& prefix, const toml::table& table,
                  const std::function<void(const std::string& key, const toml::node& node)>& visit) const;

  template <typename T, typename Convert>
  std::vector<T> list(std::string_view key, const char* expected, const Convert& convert) const;

  std::string file_;
  std::string where_;                            // the name of the table, "" for the top of the file
  std::shared_ptr<const toml::table> document_;  // copied nodes lose their line numbers
  const toml::table* table_;
};

}  // namespace drape::scene
