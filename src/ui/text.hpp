#pragma once

#include "session/snapshot.hpp"

#include <string>
#include <string_view>

namespace drape {

/// The number in a printf format that takes one double.
[[nodiscard]] std::string printed(const char* format, double value);

/// A number with about three significant digits: 0.0123, 45.6, 1 230 000 as "1.23e+06".
[[nodiscard]] std::string formatNumber(double value);

/// The same with a unit.
[[nodiscard]] std::string formatQuantity(double value, std::string_view unit);

/// Seconds in milliseconds or microseconds.
[[nodiscard]] std::string formatDuration(double seconds);

/// A count with thin spaces between the thousands.
[[nodiscard]] std::string formatCount(long long count);

/// The speed of the simulation: "real time", "0.4 x real time: too slow", "paused".
[[nodiscard]] std::string describePace(const Snapshot& snapshot);

/// Whether the simulation is slower than the chosen speed.
[[nodiscard]] bool isTooSlow(const Snapshot& snapshot);

/// The number of pinned vertices.
[[nodiscard]] int countPins(const ClothModel& model);

/// The text, cut to at most that many characters with an ellipsis, never inside a UTF-8 character.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t limit);

}  // namespace drape
