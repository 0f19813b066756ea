#pragma once

#include <string>
#include <string_view>

namespace drape {

/// The text of a file as UTF-8 with "\n" between lines: UTF-16 and UTF-32 are decoded (by their byte order mark, or for
/// UTF-16 by the zero bytes of ASCII letters), a byte order mark is left out, and a lone "\r" becomes "\n". "\r\n" may
/// stay. The result points into `bytes` when nothing has to change and into `storage` otherwise.
/// Throws InputError when the file cannot be decoded.
[[nodiscard]] std::string_view plainText(std::string_view bytes, std::string& storage);

/// The number of the line, from 1, that holds the byte at `offset`.
[[nodiscard]] std::size_t lineAt(std::string_view text, std::size_t offset);

/// Throws InputError, with the line, when the text holds a zero byte.
void requireNoZeroBytes(std::string_view text);

/// Takes the next word off the front of a line; empty at its end, and where a comment begins with '#'.
[[nodiscard]] std::string_view takeWord(std::string_view& line);

/// Reads a whole word as a decimal number, with or without sign and exponent. False when it is something else ("nan",
/// "1,5", "1.#QNAN") or beyond single precision. A number too small for double is 0.
[[nodiscard]] bool readNumber(std::string_view word, double& value);

/// What is wrong with a file whose last line, `line`, is not complete.
[[nodiscard]] std::string endsInLine(std::size_t line);

/// The warning for a file whose last line has no line break, though it can be read.
[[nodiscard]] std::string endsWithoutBreak(std::size_t line);

/// A face may have this many corners. The time of triangulation grows with their square.
inline constexpr std::size_t mostCorners = 20000;

/// What is wrong with a face that has more.
[[nodiscard]] std::string tooManyCorners(std::size_t corners);

/// A warning about what follows the last element that the header promises.
[[nodiscard]] std::string moreThanPromised(const std::string& where);

}  // namespace drape
