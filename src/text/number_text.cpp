#include "text/number_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace drape::text {
namespace {

std::optional<double> parsePlainNumber(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || text.empty()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

std::string figure(double value, int digits) {
  if (!std::isfinite(value)) {
    return "-";
  }
  // Plain digits up to a million: easier to read than "1.02e+03".
  const double magnitude = std::abs(value);
  const bool plain = magnitude >= std::pow(10.0, digits) && magnitude < 1e6;
  return plain ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string roundedFigure(double value, int digits) {
  const double magnitude = std::abs(value);
  if (!(magnitude >= 100.0 && magnitude < 1e7)) {
    return fmt::format("{:.{}g}", value, digits);
  }
  const double unit = std::pow(10.0, std::floor(std::log10(magnitude)) - digits + 1);
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

std::string formatNumber(double value) {
  const double size = std::abs(value);
  if (!std::isfinite(value)) {
    return "not finite";
  }
  if (size == 0.0) {
    return "0";
  }
  if (size < 1e-3 || size >= 1e6) {
    return fmt::format("{:.2e}", value);
  }
  const int decimals = size < 0.01 ? 5 : size < 0.1 ? 4 : size < 1.0 ? 3 : size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
  return fmt::format("{:.{}f}", value, decimals);
}

std::string formatQuantity(double value, std::string_view unit) {
  return fmt::format("{} {}", formatNumber(value), unit);
}

std::string exactNumber(double value) {
  std::array<char, 40> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

std::string formatDuration(double seconds) {
  if (seconds < 0.95e-3) {
    return fmt::format("{:.{}f} \u00B5s", seconds * 1e6, seconds < 0.95e-4 ? 1 : 0);
  }
  return fmt::format("{:.{}f} ms", seconds * 1e3, seconds < 0.095 ? 2 : 0);
}

std::string formatMinutes(double seconds) {
  const auto whole = std::lround(seconds);
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string formatLength(double metres) {
  struct Unit {
    double metres;
    const char* name;
  };
  constexpr std::array<Unit, 5> units{{{1e3, "km"}, {1.0, "m"}, {1e-3, "mm"}, {1e-6, "um"}, {0.0, "m"}}};
  const auto* const unit =
      std::find_if(units.begin(), units.end(), [metres](const Unit& each) { return metres >= each.metres; });
  return fmt::format("{:.3g} {}", unit->metres > 0.0 ? metres / unit->metres : metres, unit->name);
}

std::string formatCount(long long count) {
  std::string digits = std::to_string(count);
  for (auto place = static_cast<int>(digits.size()) - 3; place > (count < 0 ? 1 : 0); place -= 3) {
    digits.insert(static_cast<std::size_t>(place), "\u00A0");
  }
  return digits;
}

double nextRoundNumber(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= value * (1.0 - 1e-9)) {
      return factor * decade;
    }
  }
  return 10.0 * decade;
}

std::optional<double> parseNumber(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) {
    return parsePlainNumber(text);
  }
  const auto numerator = parsePlainNumber(text.substr(0, slash));
  const auto denominator = parsePlainNumber(text.substr(slash + 1));
  if (!numerator || !denominator) {
    return std::nullopt;
  }
  return *numerator / *denominator;
}

}  // namespace drape::text
