#pragma once

#include "sim/model/vector.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// The text in the quotes of TOML.
[[nodiscard]] std::string quotedText(std::string_view text);

/// "[0.5, 1, -2]". Reads back to the same bits.
[[nodiscard]] std::string vectorText(const Vec3& vector);

/// "[1, 2, 17]"
[[nodiscard]] std::string listText(const std::vector<int>& numbers);

/// The vector [degrees] whose product with `degree` has exactly the bits of `radians`, in short numbers.
[[nodiscard]] std::string degreesText(const Vec3& radians);

/// The rate whose inverse has exactly the bits of `time`, as a short number.
[[nodiscard]] std::string rateText(double time);

/// Writes the tables of a TOML document, one value a line.
class TomlText {
 public:
  /// Starts a table: "[cloth]" or "[[bodies]]". It appears with its first value, or at once when it is `needed`.
  void table(std::string_view header, bool needed = false);
  /// A value of the last table, as it stands in the file.
  void value(std::string_view key, const std::string& written);
  void text(std::string_view key, std::string_view text) { value(key, quotedText(text)); }
  void number(std::string_view key, double number);
  void flag(std::string_view key, bool flag) { value(key, flag ? "true" : "false"); }
  /// Lines of TOML that another function wrote.
  void append(std::string_view lines);

  [[nodiscard]] const std::string& document() const { return document_; }

 private:
  void begin();

  std::string document_;
  std::string header_;  // of a table without values so far
};

}  // namespace drape::scene
