#pragma once

#include <string>
#include <string_view>

namespace drape::io {

/// The text of a file as UTF-8 with "\n" between lines. It decodes UTF-16 and UTF-32 (by their byte order mark, or
/// UTF-16 by the zero bytes of ASCII letters), removes a byte order mark, and turns a lone "\r" into "\n". "\r\n" may
/// stay. The result points into `bytes` when nothing changes, otherwise into `storage`. Throws InputError when the file
/// cannot be decoded.
[[nodiscard]] std::string_view plainText(std::string_view bytes, std::string& storage);

/// The line number, from 1, of the byte at `offset`.
[[nodiscard]] std::size_t lineAt(std::string_view text, std::size_t offset);

/// Throws InputError with the line when the text contains a zero byte.
void requireNoZeroBytes(std::string_view text);

/// Removes the next word from the front of a line; empty at its end and at a comment, which starts with '#'.
[[nodiscard]] std::string_view takeWord(std::string_view& line);

/// Reads a whole word as a decimal number with optional sign and exponent. False for other text ("nan", "1,5",
/// "1.#QNAN") and for values beyond single precision. A number too small for double becomes 0.
[[nodiscard]] bool readNumber(std::string_view word, double& value);

/// The error for a file whose last line is incomplete.
[[nodiscard]] std::string endsInLine(std::size_t line);

/// The warning for a readable file whose last line has no line break.
[[nodiscard]] std::string endsWithoutBreak(std::size_t line);

/// A face may have this many corners. The time of triangulation grows with their square.
inline constexpr std::size_t maxCorners = 20000;

/// The message about a face that has more.
[[nodiscard]] std::string tooManyCorners(std::size_t corners);

/// A warning about what follows the last element that the header promises.
[[nodiscard]] std::string moreThanPromised(const std::string& where);

}  // namespace drape::io
