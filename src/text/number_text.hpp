#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drape::text {

// The ways to write a number that have a rule. Where the number of digits is fixed, call fmt::format.

/// A number with at most this number of significant digits: "0.0123", "1.2e-05"; all digits up to a million; "-" when
/// it is not finite.
[[nodiscard]] std::string figure(double value, int digits = 3);

/// The same, but from 100 to ten million rounded to this number of significant digits and without an exponent:
/// "120000".
[[nodiscard]] std::string roundedFigure(double value, int digits = 2);

/// A number with three significant digits, zeros at the end included: "0.0123", "45.0"; from a million, and below a
/// thousandth, with an exponent: "1.23e+06". "not finite" when it is not.
[[nodiscard]] std::string formatNumber(double value);

/// The same with a unit.
[[nodiscard]] std::string formatQuantity(double value, std::string_view unit);

/// The shortest text that reads back as the same number: "0.1", "1e+05".
[[nodiscard]] std::string exactNumber(double value);

/// Short times, from seconds: "9.4 µs", "16.70 ms", "250 ms".
[[nodiscard]] std::string formatDuration(double seconds);

/// Long times, from seconds: "59 s", "2 min 5 s".
[[nodiscard]] std::string formatMinutes(double seconds);

/// A length with three significant digits in km, m, mm or um, from metres: "1.5 mm".
[[nodiscard]] std::string formatLength(double metres);

/// A count with non-breaking spaces between the thousands.
[[nodiscard]] std::string formatCount(long long count);

/// The next larger of 1, 2 and 5 times a power of ten, or the positive number itself when it is one up to rounding.
[[nodiscard]] double nextRoundNumber(double value);

/// Parses a number or a fraction such as 1/150. Empty for any other text.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace drape::text
