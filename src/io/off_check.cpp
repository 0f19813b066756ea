#include "io/off_check.hpp"

#include "io/quoted_text.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace drape::io {
namespace {

class OffChecker {
 public:
  explicit OffChecker(std::string_view text) : rest_(text) {}

  OffText check() {
    readHeader();
    result_.text = "OFF\n";
    const std::size_t countsAt = result_.text.size();
    for (std::size_t i = 0; i < vertices_; ++i) {
      readVertex(i);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces_; ++i) {
      kept += readFace(i) ? 1 : 0;
    }
    if (kept == 0) {
      throw messages::InputError("there are no faces in it. A cloth needs a mesh of triangles or polygons.");
    }
    result_.text.insert(countsAt, std::to_string(vertices_) + " " + std::to_string(kept) + " 0\n");
    if (broken_) {
      result_.warnings.push_back(endsWithoutBreak(number_));
    }
    if (nextLine()) {
      result_.warnings.push_back(moreThanPromised("Line " + std::to_string(number_) + " and what follows it are"));
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw messages::InputError(broken_ ? endsInLine(number_)
                                       : "line " + std::to_string(number_) + ": " + problem +
                                             ". Correct it, or export the mesh again.");
  }

  /// Moves on to the next line that holds something. False at the end of the file.
  bool nextLine() {
    while (!rest_.empty()) {
      ++number_;
      const std::size_t end = rest_.find('\n');
      broken_ = end == std::string_view::npos;
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(broken_ ? rest_.size() : end + 1);
      std::string_view look = line_;
      if (!takeWord(look).empty()) {
        return true;
      }
    }
    return false;
  }

  void requireLine(const char* what, std::size_t index, std::size_t count) {
    if (!nextLine()) {
      throw messages::InputError(std::string(what) + " " + std::to_string(index + 1) + " of " + std::to_string(count) +
                                 " is missing: the file was cut off after line " + std::to_string(number_) +
                                 ". Export or copy it again.");
    }
  }

  void readHeader() {
    constexpr std::array<std::string_view, 9> known{"OFF",    "COFF",   "NOFF",    "CNOFF", "STOFF",
                                                    "STCOFF", "STNOFF", "STCNOFF", "NCOFF"};
    if (!nextLine()) {
      throw messages::InputError("there is nothing in it. Export the mesh again.");
    }
    std::string_view look = line_;
    const std::string_view keyword = takeWord(look);
    if (keyword.find("OFF") == std::string_view::npos) {
      throw messages::InputError("it is not an OFF file: it begins with " + quoted(keyword) +
                                 ", and not with 'OFF'. Check what it is, or export it again.");
    }
    std::string_view more = look;
    if (takeWord(more) == "BINARY") {
      throw messages::InputError("it is a binary OFF file, which is not read. Export it as text, or as PLY.");
    }
    if (std::find(known.begin(), known.end(), keyword) == known.end()) {
      throw messages::InputError("it is an OFF file of the kind " + quoted(keyword) +
                                 ", which is not read. Export it as plain OFF, or as PLY.");
    }
    line_ = look;
    if (std::string_view counts = line_; takeWord(counts).empty() && !nextLine()) {
      throw messages::InputError("it ends after its first line: it was cut off. Export or copy it again.");
    }
    vertices_ = readCount("vertices");
    faces_ = readCount("faces");
  }

  /// A count that the rest of the file can hold: each element takes a line.
  std::size_t readCount(const char* what) {
    const std::string_view word = takeWord(line_);
    const auto count = wholeNumber(word);
    if (!count) {
      fail(quoted(word) + " is not the number of " + what);
    }
    if (*count > rest_.size() + 1) {
      fail("it promises " + std::to_string(*count) + " " + what + ", more than the file can hold: it was cut off");
    }
    return *count;
  }

  static std::optional<std::size_t> wholeNumber(std::string_view word) {
    std::size_t value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool fine = result.ec == std::errc() && result.ptr == word.data() + word.size() && !word.empty();
    return fine ? std::optional(value) : std::nullopt;
  }

  void readVertex(std::size_t index) {
    requireLine("vertex", index, vertices_);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = takeWord(line_);
      double value = 0.0;
      if (!readNumber(word, value)) {
        fail(word.empty() ? "a vertex needs three coordinates" : quoted(word) + " is not a finite number");
      }
      (result_.text += word) += axis < 2 ? ' ' : '\n';
    }
  }

  bool readFace(std::size_t index) {
    requireLine("face", index, faces_);
    const std::string_view word = takeWord(line_);
    const auto corners = wholeNumber(word);
    if (!corners) {
      fail(quoted(word) + " is not a number of corners");
    }
    if (*corners > maxCorners) {
      fail("the face " + tooManyCorners(*corners));
    }
    std::string face = std::to_string(*corners);
    for (std::size_t i = 0; i < *corners; ++i) {
      const std::string_view corner = takeWord(line_);
      const auto vertex = wholeNumber(corner);
      if (!vertex) {
        fail(corner.empty() ? "the face has " + std::to_string(i) + " of its " + std::to_string(*corners) + " corners"
                            : quoted(corner) + " is not the number of a vertex");
      }
      if (*vertex >= vertices_) {
        fail("there is no vertex " + std::to_string(*vertex) + ", only " + std::to_string(vertices_) +
             " counted from 0");
      }
      face += ' ' + std::to_string(*vertex);
    }
    if (*corners < 3) {
      ++result_.facesSkipped;
      return false;
    }
    (result_.text += face) += '\n';
    return true;
  }

  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
  bool broken_ = false;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  OffText result_;
};

}  // namespace

OffText checkOff(std::string_view text) {
  requireNoZeroBytes(text);
  return OffChecker(text).check();
}

}  // namespace drape::io
