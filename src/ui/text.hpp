#pragma once

#include "session/snapshot.hpp"

#include <string>
#include <string_view>

namespace drape {

/// The number in a printf format that takes one double.
[[nodiscard]] std::string printed(const char* format, double value);

/// A number with about three significant digits, as people write it: 0.0123, 45.6, 1 230 000 as "1.23e+06".
[[nodiscard]] std::string formatNumber(double value);

/// The same with a unit.
[[nodiscard]] std::string formatQuantity(double value, std::string_view unit);

/// Seconds as milliseconds or microseconds, whichever reads better.
[[nodiscard]] std::string formatDuration(double seconds);

/// A count with thin gaps between the thousands.
[[nodiscard]] std::string formatCount(long long count);

/// How fast the clock of the simulation runs: "real time", "0.4 x real time: too slow", "paused".
[[nodiscard]] std::string describePace(const Snapshot& snapshot);

/// True while the clock falls behind the speed that was set.
[[nodiscard]] bool isTooSlow(const Snapshot& snapshot);

/// The number of vertices that are pinned.
[[nodiscard]] int countPins(const ClothModel& model);

/// The text, cut to at most that many characters with an ellipsis; never inside a UTF-8 character.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t limit);

}  // namespace drape
