#include "scene/toml_text.hpp"

#include "scene/toml_reader.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace drape::scene {
namespace {

/// The shortest text of a number near `guess` for which `function` returns exactly `wanted`; that of `guess` if none
/// does. The function is nearly linear, so few neighbours are enough.
template <typename Function>
std::string shortestInverse(double wanted, double guess, const Function& function) {
  constexpr int neighbours = 4;  // on each side
  if (wanted == 0.0) {
    return "0";
  }
  double candidate = guess;
  for (int i = 0; i < neighbours; ++i) {
    candidate = std::nextafter(candidate, -std::numeric_limits<double>::infinity());
  }
  std::string shortest;
  for (int i = 0; i <= 2 * neighbours; ++i) {
    const std::string text = text::exactNumber(candidate);
    if (function(candidate) == wanted && (shortest.empty() || text.size() < shortest.size())) {
      shortest = text;
    }
    candidate = std::nextafter(candidate, std::numeric_limits<double>::infinity());
  }
  return shortest.empty() ? text::exactNumber(guess) : shortest;
}

}  // namespace

std::string quotedText(std::string_view text) {
  std::ostringstream stream;
  stream << toml::value<std::string>(std::string(text));
  return stream.str();
}

std::string vectorText(const Vec3& vector) {
  return "[" + text::exactNumber(vector.x()) + ", " + text::exactNumber(vector.y()) + ", " +
         text::exactNumber(vector.z()) + "]";
}

std::string listText(const std::vector<int>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string degreesText(const Vec3& radians) {
  const auto inDegrees = [](double angle) {
    return shortestInverse(angle, angle / degree, [](double degrees) { return degree * degrees; });
  };
  return "[" + inDegrees(radians.x()) + ", " + inDegrees(radians.y()) + ", " + inDegrees(radians.z()) + "]";
}

std::string rateText(double time) {
  return shortestInverse(time, 1.0 / time, [](double rate) { return 1.0 / rate; });
}

void TomlText::table(std::string_view header, bool needed) {
  header_ = header;
  if (needed) {
    begin();
  }
}

void TomlText::begin() {
  if (!header_.empty()) {
    document_ += (document_.empty() ? "" : "\n") + std::exchange(header_, {}) + '\n';
  }
}

void TomlText::value(std::string_view key, const std::string& written) {
  begin();
  document_ += std::string(key) + " = " + written + '\n';
}

void TomlText::number(std::string_view key, double number) {
  value(key, text::exactNumber(number));
}

void TomlText::append(std::string_view lines) {
  header_.clear();
  document_ += (document_.empty() ? "" : "\n") + std::string(lines);
}

}  // namespace drape::scene
