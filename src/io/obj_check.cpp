#include "io/obj_check.hpp"

#include "io/quoted_text.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <climits>
#include <cmath>
#include <iterator>

namespace drape::io {
namespace {

/// Words that begin a line of an OBJ file and do not change a mesh of polygons: normals, libraries, and curves.
constexpr std::array<std::string_view, 40> ignoredWords{
    "vn",       "vp",         "s",         "mg",    "mtllib", "maplib", "usemap", "lod",    "bevel",       "c_interp",
    "d_interp", "shadow_obj", "trace_obj", "ctech", "stech",  "cstype", "deg",    "bmat",   "step",        "curv",
    "curv2",    "surf",       "parm",      "trim",  "hole",   "scrv",   "sp",     "end",    "con",         "call",
    "csh",      "bzp",        "bsp",       "res",   "cdc",    "cdp",    "mtl",    "newmtl", "vertexgroup", "facegroup"};

/// Longer whole parts of numbers overflow in the parsing library.
constexpr std::size_t longestWholePart = 18;

/// Takes lines off a text. A backslash at the end of a line continues it.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  [[nodiscard]] std::size_t number() const { return number_; }  ///< of the line taken last, or its first part
  [[nodiscard]] bool broken() const { return broken_; }         ///< the line taken last had no line break

  std::string_view take() {
    ++number_;
    number_ += extra_;
    extra_ = 0;
    std::string_view line = takePhysical();
    if (line.empty() || line.back() != '\\' || line.find('#') != std::string_view::npos) {
      return line;
    }
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      if (rest_.empty()) {
        broken_ = true;  // The continuation is missing.
        return joined_;
      }
      ++extra_;
      line = takePhysical();
    }
    joined_ += line;
    return joined_;
  }

 private:
  std::string_view takePhysical() {
    const std::size_t end = rest_.find('\n');
    broken_ = end == std::string_view::npos;
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(broken_ ? rest_.size() : end + 1);
    line.remove_suffix(line.size() - std::min(line.size(), line.find_last_not_of(" \t\r") + 1));
    return line;
  }

  std::string_view rest_;
  std::string joined_;
  std::size_t number_ = 0;
  std::size_t extra_ = 0;
  bool broken_ = false;
};

/// One corner of a face; 0 where nothing stands.
struct Corner {
  long long vertex = 0;
  long long texture = 0;
};

/// How often something odd occurred, and where first.
struct Oddity {
  int count = 0;
  std::size_t line = 0;
  std::string word;

  void add(std::size_t number, std::string_view what) {
    if (count++ == 0) {
      line = number;
      word = quoted(what);
    }
  }
};

class Checker {
 public:
  Checker(std::string_view text, const ImportWatch& watch) : size_(text.size()), lines_(text), watch_(watch) {
    result_.text.reserve(text.size() + 1);
  }

  ObjText check() {
    constexpr std::size_t often = std::size_t{1} << 20;
    std::size_t next = size_;
    while (!lines_.done()) {
      if (lines_.left() <= next) {
        watch_.tell(1.0 - static_cast<double>(lines_.left()) / static_cast<double>(size_), "Checking");
        next = lines_.left() - std::min(often, lines_.left());
      }
      checkLine(lines_.take());
    }
    checkWhole();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    if (lines_.broken()) {
      throw messages::InputError(endsInLine(lines_.number()));
    }
    throw messages::InputError("line " + std::to_string(lines_.number()) + ": " + problem +
                               ". Correct it, or export the mesh again.");
  }

  void checkLine(std::string_view line) {
    const std::string_view whole = line;
    const std::string_view keyword = takeWord(line);
    if (keyword.empty()) {
      return;
    }
    if (keyword == "v") {
      addVertex(line);
    } else if (keyword == "vt") {
      addTexture(line);
    } else if (keyword == "f" || keyword == "fo") {
      addFace(line);
    } else if (keyword == "l" || keyword == "p") {
      result_.facesSkipped += countParts(keyword, line);
    } else if (keyword == "o" || keyword == "g" || keyword == "usemtl") {
      result_.text += whole.substr(whole.find(keyword));
      result_.text += '\n';
    } else if (std::find(ignoredWords.begin(), ignoredWords.end(), keyword) == ignoredWords.end()) {
      if (lines_.broken()) {
        fail("");
      }
      unknown_.add(lines_.number(), keyword);
    }
    lastBroken_ = lines_.broken();
  }

  void addVertex(std::string_view line) {
    std::array<std::string_view, 4> words;
    std::array<double, 4> values{};
    std::size_t count = 0;
    std::string_view word;
    while (!(word = takeWord(line)).empty()) {
      double value = 0.0;
      if (!readNumber(word, value) && count < 4) {
        fail(quoted(word) + (word.find(',') == std::string_view::npos
                                 ? " is not a finite number"
                                 : " is not a finite number: write a point, not a comma"));
      }
      if (count < 4) {
        words[count] = word;
        values[count] = value;
      }
      ++count;
    }
    if (count < 3) {
      fail("a vertex needs three coordinates");
    }
    if (count == 4 && values[3] == 0.0) {
      fail("the weight of a vertex, its fourth number, must not be 0");
    }
    result_.text += 'v';
    for (std::size_t i = 0; i < (count == 4 ? 4U : 3U); ++i) {
      appendNumber(words[i], values[i]);
    }
    result_.text += '\n';
    const Vec3 position(values[0], values[1], values[2]);
    result_.mesh.positions.emplace_back(count == 4 ? Vec3(position / values[3]) : position);
    ++vertices_;
  }

  void appendNumber(std::string_view word, double value) {
    result_.text += ' ';
    const std::size_t whole = std::min(word.find_first_of(".eE"), word.size());
    if (whole <= longestWholePart) {
      result_.text += word;
      return;
    }
    fmt::format_to(std::back_inserter(result_.text), "{:.9e}", value);
  }

  /// A coordinate that is no number becomes 0: only the picture needs it.
  void addTexture(std::string_view line) {
    result_.text += "vt";
    Vec2 uv = Vec2::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      const std::string_view word = takeWord(line);
      double value = 0.0;
      if (word.empty() && lines_.broken()) {
        fail("");
      }
      if (readNumber(word, value)) {
        uv[axis] = value;
        appendNumber(word, value);
      } else {
        result_.text += " 0";
        if (!word.empty() || axis == 0) {
          badTexture_.add(lines_.number(), word);
        }
      }
    }
    result_.text += '\n';
    result_.mesh.uvs.push_back(uv);
    ++textures_;
  }

  void addFace(std::string_view line) {
    corners_.clear();
    std::string_view word;
    while (!(word = takeWord(line)).empty()) {
      corners_.push_back(readCorner(word));
    }
    if (corners_.empty()) {
      fail("a face needs the numbers of its vertices");
    }
    if (corners_.size() < 3) {
      if (lines_.broken()) {
        fail("");
      }
      ++result_.facesSkipped;
      return;
    }
    if (corners_.size() > maxCorners) {
      fail("the face " + tooManyCorners(corners_.size()));
    }
    ++faces_;
    result_.text += 'f';
    for (const Corner& corner : corners_) {
      appendCorner(corner);
      result_.mesh.corners.push_back(static_cast<int>(std::min<long long>(corner.vertex, INT_MAX)) - 1);
      result_.mesh.uvCorners.push_back(static_cast<int>(std::min<long long>(corner.texture, INT_MAX)) - 1);
    }
    result_.mesh.endFace();
    result_.text += '\n';
  }

  Corner readCorner(std::string_view word) {
    Corner corner;
    const std::size_t slash = std::min(word.find('/'), word.size());
    corner.vertex = wholeNumber(word.substr(0, slash), word);
    const std::string_view rest = word.substr(std::min(slash + 1, word.size()));
    const std::size_t second = std::min(rest.find('/'), rest.size());
    if (second > 0) {
      corner.texture = wholeNumber(rest.substr(0, second), word);
    }
    if (second + 1 < rest.size()) {
      (void)wholeNumber(rest.substr(second + 1), word);
    }
    corner.vertex = absolute(corner.vertex, vertices_, "vertex", maxVertex_);
    if (corner.texture != 0 || second > 0) {
      corner.texture = absolute(corner.texture, textures_, "texture coordinate", maxTexture_);
    }
    return corner;
  }

  [[nodiscard]] long long wholeNumber(std::string_view part, std::string_view word) const {
    long long index = 0;
    const char* const first = part.data() + (!part.empty() && part[0] == '+' ? 1 : 0);
    const auto result = std::from_chars(first, part.data() + part.size(), index);
    if (result.ec == std::errc::result_out_of_range && result.ptr == part.data() + part.size()) {
      return part[0] == '-' ? -LLONG_MAX : LLONG_MAX;
    }
    if (result.ec != std::errc() || result.ptr != part.data() + part.size()) {
      fail(quoted(word) + " is not the number of a vertex");
    }
    return index;
  }

  /// The highest number that was used before it was there, and where.
  struct MaxIndex {
    long long index = 0;
    std::size_t line = 0;
    bool broken = false;
  };

  /// Counted from 1. Negative numbers count back from the last one before the line; positive ones may come later.
  long long absolute(long long index, long long count, const char* what, MaxIndex& largest) {
    if (index == 0) {
      fail(std::string(what) + " 0 does not exist: OBJ counts from 1");
    }
    if (index < -count) {
      fail("there is no " + std::string(what) + " " + std::to_string(index) + ", only " + std::to_string(count) +
           " come before it");
    }
    if (index > count && index > largest.index) {
      largest = {index, lines_.number(), lines_.broken()};
    }
    return index > 0 ? index : count + 1 + index;
  }

  void appendCorner(const Corner& corner) {
    result_.text += ' ';
    appendWhole(corner.vertex);
    if (corner.texture != 0) {
      result_.text += '/';
      appendWhole(corner.texture);
    }
    const auto vertex = static_cast<std::size_t>(std::min<long long>(corner.vertex, INT_MAX));
    if (vertex >= used_.size() && corner.vertex <= static_cast<long long>(size_)) {
      used_.resize(std::max(vertex + 1, 2 * used_.size()), false);
    }
    if (vertex < used_.size()) {
      used_[vertex] = true;
    }
  }

  void appendWhole(long long number) {
    const fmt::format_int digits(number);
    result_.text.append(digits.data(), digits.size());
  }

  static int countParts(std::string_view keyword, std::string_view line) {
    int words = 0;
    while (!takeWord(line).empty()) {
      ++words;
    }
    return std::max(1, keyword == "l" ? words - 1 : words);
  }

  static void requireThere(const MaxIndex& largest, long long count, const char* what) {
    if (largest.index > count) {
      throw messages::InputError("line " + std::to_string(largest.line) + ": there is no " + what + " " +
                                 std::to_string(largest.index) + ", the file has only " + std::to_string(count) +
                                 ". Correct it, or export the mesh again.");
    }
  }

  void checkWhole() {
    if (vertices_ == 0 && faces_ == 0 && unknown_.count > 0) {
      throw messages::InputError("it is not an OBJ file: line " + std::to_string(unknown_.line) + " begins with " +
                                 unknown_.word + ". Check what it is, or export the mesh again.");
    }
    requireThere(maxVertex_, vertices_, "vertex");
    requireThere(maxTexture_, textures_, "texture coordinate");
    if (faces_ == 0) {
      throw messages::InputError(
          "there are no faces in it" + std::string(result_.facesSkipped > 0 ? " but lines and points. " : ". ") +
          "A cloth needs a mesh of triangles or polygons. If it should have faces, the file was cut off.");
    }
    const auto used = std::count(used_.begin(), used_.end(), true);
    result_.unusedVertices = static_cast<int>(vertices_ - used);
    if (textures_ == 0) {
      result_.mesh.uvCorners.clear();
    }
    addWarnings();
  }

  void addWarnings() {
    if (unknown_.count > 0) {
      result_.warnings.push_back("Line " + std::to_string(unknown_.line) + " begins with " + unknown_.word +
                                 ", which OBJ does not know" + others(unknown_.count) + ": left out.");
    }
    if (badTexture_.count > 0) {
      result_.warnings.push_back("Line " + std::to_string(badTexture_.line) + " has " + badTexture_.word +
                                 " as a texture coordinate" + others(badTexture_.count) + ": 0 is used.");
    }
    if (lastBroken_) {
      result_.warnings.push_back(endsWithoutBreak(lines_.number()));
    }
  }

  static std::string others(int count) { return count > 1 ? " (and " + std::to_string(count - 1) + " more such)" : ""; }

  std::size_t size_;
  Lines lines_;
  const ImportWatch& watch_;
  ObjText result_;
  std::vector<Corner> corners_;
  std::vector<bool> used_;
  long long vertices_ = 0;
  long long textures_ = 0;
  long long faces_ = 0;
  MaxIndex maxVertex_;
  MaxIndex maxTexture_;
  Oddity unknown_;
  Oddity badTexture_;
  bool lastBroken_ = false;
};

}  // namespace

ObjText checkObj(std::string_view text, const ImportWatch& watch) {
  requireNoZeroBytes(text);
  return Checker(text, watch).check();
}

std::string nameObjVertex(std::string_view text, const Vec3& position) {
  double nearest = HUGE_VAL;
  std::size_t number = 0;
  std::string name;
  for (Lines lines(text); !lines.done();) {
    std::string_view line = lines.take();
    if (takeWord(line) != "v") {
      continue;
    }
    ++number;
    Vec3 place;
    for (double& coordinate : place) {
      (void)readNumber(takeWord(line), coordinate);
    }
    if ((place - position).norm() < nearest) {
      nearest = (place - position).norm();
      name = "vertex " + std::to_string(number) + " (line " + std::to_string(lines.number()) + ")";
    }
  }
  return name;
}

}  // namespace drape::io
