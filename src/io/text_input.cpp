#include "io/text_input.hpp"

#include "messages/error.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <optional>

namespace drape::io {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

struct Encoding {
  std::string_view mark;  ///< byte order mark
  const char* name;       ///< iconv's name
};

constexpr std::array<Encoding, 5> encodings{{
    {{"\xef\xbb\xbf", 3}, "UTF-8"},
    {{"\xff\xfe\0\0", 4}, "UTF-32LE"},  // before UTF-16LE, whose mark is a prefix of this one
    {{"\0\0\xfe\xff", 4}, "UTF-32BE"},
    {{"\xff\xfe", 2}, "UTF-16LE"},
    {{"\xfe\xff", 2}, "UTF-16BE"},
}};

/// UTF-16 without a mark: every second byte of the first characters is 0.
std::optional<Encoding> encodingWithoutMark(std::string_view bytes) {
  constexpr std::size_t looked = 16;
  if (bytes.size() < looked) {
    return std::nullopt;
  }
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < looked; ++i) {
    zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  }
  if (zeros[0] + zeros[1] != looked / 2 || (zeros[0] != 0 && zeros[1] != 0)) {
    return std::nullopt;
  }
  return Encoding{{}, zeros[1] != 0 ? "UTF-16LE" : "UTF-16BE"};
}

std::optional<Encoding> encodingOf(std::string_view bytes) {
  const auto* const found = std::find_if(encodings.begin(), encodings.end(), [bytes](const Encoding& encoding) {
    return bytes.substr(0, encoding.mark.size()) == encoding.mark;
  });
  return found != encodings.end() ? std::optional(*found) : encodingWithoutMark(bytes);
}

/// An iconv conversion, closed at the end of its scope.
class Decoder {
 public:
  explicit Decoder(const char* from) : handle_(iconv_open("UTF-8", from)) {}
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() {
    if (isOpen()) {
      iconv_close(handle_);
    }
  }

  /// The text up to an incomplete character at its end.
  std::string decode(std::string_view bytes) {
    std::string text;
    std::string from(bytes);
    char* in = from.data();
    std::size_t left = from.size();
    std::array<char, 65536> buffer{};
    while (isOpen() && left > 0) {
      char* out = buffer.data();
      std::size_t available = buffer.size();
      const bool done = iconv(handle_, &in, &left, &out, &available) != static_cast<std::size_t>(-1);
      const int problem = done ? 0 : errno;
      text.append(buffer.data(), buffer.size() - available);
      if (problem == EINVAL) {
        break;
      }
      if (problem != 0 && problem != E2BIG) {
        throw messages::InputError("line " + std::to_string(lineAt(text, text.size())) +
                                   " contains invalid characters: the file is damaged. Save it as UTF-8.");
      }
    }
    return text;
  }

 private:
  // NOLINTNEXTLINE(performance-no-int-to-ptr): iconv_open defines this value for failures.
  [[nodiscard]] bool isOpen() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  iconv_t handle_;
};

bool hasLoneReturn(std::string_view text) {
  for (std::size_t i = text.find('\r'); i != std::string_view::npos; i = text.find('\r', i + 1)) {
    if (i + 1 == text.size() || text[i + 1] != '\n') {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string_view plainText(std::string_view bytes, std::string& storage) {
  std::string_view text = bytes;
  if (const auto encoding = encodingOf(bytes)) {
    text.remove_prefix(encoding->mark.size());
    if (std::string_view(encoding->name) != "UTF-8") {
      storage = Decoder(encoding->name).decode(text);
      text = storage;
    }
  }
  if (hasLoneReturn(text)) {
    if (text.data() != storage.data()) {
      storage = text;
    }
    for (std::size_t i = storage.find('\r'); i != std::string::npos; i = storage.find('\r', i + 1)) {
      storage[i] = i + 1 < storage.size() && storage[i + 1] == '\n' ? ' ' : '\n';
    }
    text = storage;
  }
  return text;
}

std::size_t lineAt(std::string_view text, std::size_t offset) {
  return 1 +
         static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

void requireNoZeroBytes(std::string_view text) {
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    throw messages::InputError("line " + std::to_string(lineAt(text, zero)) +
                               " contains a zero byte: the file is damaged. Export or copy it again.");
  }
}

std::string_view takeWord(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  if (!line.empty() && line.front() == '#') {
    line = {};
  }
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

bool readNumber(std::string_view word, double& value) {
  if (!word.empty() && word[0] == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word[0] == '-') {
      return false;
    }
  }
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ptr != word.data() + word.size() || word.empty()) {
    return false;
  }
  if (result.ec == std::errc::result_out_of_range) {
    value = 0.0;
    return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
  }
  return result.ec == std::errc() && std::isfinite(static_cast<float>(value));
}

std::string endsInLine(std::size_t line) {
  return "the file ends in the middle of line " + std::to_string(line) + ": it was cut off. Export or copy it again.";
}

std::string endsWithoutBreak(std::size_t line) {
  return "The last line, " + std::to_string(line) +
         ", has no line break at its end. If the file was cut off there, faces are missing: export it again.";
}

std::string tooManyCorners(std::size_t corners) {
  return "has " + std::to_string(corners) + " corners, and faces of at most " + std::to_string(maxCorners) +
         " are read";
}

std::string moreThanPromised(const std::string& where) {
  return where + " more than its header promises: left out. If faces are missing, export it again.";
}

}  // namespace drape::io
