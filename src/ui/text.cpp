#include "ui/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace drape {

std::string printed(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
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
    return printed("%.2e", value);
  }
  const int decimals = size < 0.01 ? 5 : size < 0.1 ? 4 : size < 1.0 ? 3 : size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
  const std::string format = "%." + std::to_string(decimals) + "f";
  return printed(format.c_str(), value);
}

std::string formatQuantity(double value, std::string_view unit) {
  return formatNumber(value) + " " + std::string(unit);
}

std::string formatDuration(double seconds) {
  if (seconds < 0.95e-3) {
    return printed(seconds < 0.95e-4 ? "%.1f \u00B5s" : "%.0f \u00B5s", seconds * 1e6);
  }
  return printed(seconds < 0.095 ? "%.2f ms" : "%.0f ms", seconds * 1e3);
}

std::string formatCount(long long count) {
  std::string digits = std::to_string(count);
  const std::size_t sign = count < 0 ? 1 : 0;
  for (std::size_t place = digits.size(); place > sign + 3;) {
    place -= 3;
    digits.insert(place, "\u00A0");
  }
  return digits;
}

bool isTooSlow(const Snapshot& snapshot) {
  constexpr double nearEnough = 0.9;
  return !snapshot.paused && snapshot.realTimeFactor > 0.0 &&
         snapshot.realTimeFactor < nearEnough * snapshot.settings.playback.speed;
}

std::string describePace(const Snapshot& snapshot) {
  if (snapshot.paused) {
    return "paused";
  }
  if (snapshot.realTimeFactor <= 0.0) {
    return "not timed";  // no clock is running, as in a capture, or it has just started
  }
  const bool slow = isTooSlow(snapshot);
  if (!slow && snapshot.settings.playback.speed == 1.0) {
    return "real time";
  }
  const std::string factor = printed(snapshot.realTimeFactor < 0.095 ? "%.2g" : "%.1f", snapshot.realTimeFactor);
  return factor + " \u00D7 real time" + (slow ? ": too slow" : "");
}

int countPins(const ClothModel& model) {
  return static_cast<int>(std::count(model.pinned.begin(), model.pinned.end(), true));
}

std::string shortened(std::string_view text, std::size_t limit) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts && ++characters > limit) {
      return std::string(text.substr(0, i)) + "\u2026";
    }
  }
  return std::string(text);
}

}  // namespace drape
