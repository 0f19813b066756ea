#include "io/stl_check.hpp"

#include "io/quoted_text.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace drape::io {
namespace {

constexpr std::size_t headerSize = 84;
constexpr std::size_t triangleSize = 50;

std::size_t promisedTriangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + headerSize - sizeof(count), sizeof(count));
  return count;
}

void checkTriangle(std::string_view bytes, std::size_t index, std::size_t count) {
  std::array<float, 12> numbers{};  // normal, then three corners
  std::memcpy(numbers.data(), bytes.data() + headerSize + index * triangleSize, sizeof(numbers));
  for (std::size_t i = 3; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) {
      throw messages::InputError("triangle " + std::to_string(index + 1) + " of " + std::to_string(count) +
                                 " has a coordinate that is not a finite number (nan or inf). Repair the mesh.");
    }
  }
}

StlBytes checkBinary(std::string_view bytes) {
  if (bytes.size() < headerSize) {
    throw messages::InputError("it is too short for an STL file: it was cut off. Export or copy it again.");
  }
  const std::size_t promised = promisedTriangles(bytes);
  const std::size_t present = (bytes.size() - headerSize) / triangleSize;
  if (present < promised) {
    throw messages::InputError(
        "it holds " + std::to_string(present) + " of the " + std::to_string(promised) +
        " triangles that it promises: it was cut off, or it is not an STL file. Export or copy it again.");
  }
  for (std::size_t i = 0; i < promised; ++i) {
    checkTriangle(bytes, i, promised);
  }
  if (promised == 0) {
    throw messages::InputError("there are no faces in it. A cloth needs a mesh of triangles or polygons.");
  }
  StlBytes stl{bytes.substr(0, headerSize + promised * triangleSize), {}};
  // Some programs end the file with a remark.
  if (const std::size_t left = bytes.size() - stl.bytes.size(); left >= triangleSize) {
    stl.warnings.push_back(moreThanPromised("The last " + std::to_string(left) + " bytes are"));
  }
  return stl;
}

bool fitsBinary(std::string_view bytes) {
  return bytes.size() >= headerSize && bytes.size() == headerSize + promisedTriangles(bytes) * triangleSize;
}

/// Goes through the lines of a text file and writes its facets anew.
class TextChecker {
 public:
  explicit TextChecker(std::string_view text) : rest_(text) {}

  std::string check() {
    text_ = "solid\n";
    while (!rest_.empty()) {
      ++line_;
      const std::size_t end = rest_.find('\n');
      broken_ = end == std::string_view::npos;
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(broken_ ? rest_.size() : end + 1);
      checkLine(line);
    }
    if (open_) {
      throw messages::InputError("it ends in the middle of a solid, after line " + std::to_string(line_) +
                                 ", without 'endsolid': it was cut off. Export or copy it again.");
    }
    if (facets_ == 0) {
      throw messages::InputError("there are no faces in it. A cloth needs a mesh of triangles or polygons.");
    }
    return std::move(text_) + "endsolid\n";
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw messages::InputError(broken_ ? endsInLine(line_)
                                       : "line " + std::to_string(line_) + ": " + problem +
                                             ". Correct it, or export the mesh again.");
  }

  void checkLine(std::string_view line) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "solid") {
      open_ = true;
    } else if (keyword == "endsolid") {
      open_ = false;
    } else if (keyword == "facet") {
      endFacet();
      beginFacet();
    } else if (keyword == "vertex") {
      addVertex(line);
    } else if (keyword == "endfacet") {
      endFacet();
    } else if (!keyword.empty() && keyword != "outer" && keyword != "endloop" && keyword != "end") {
      fail(quoted(keyword) + " is not a word of an STL file");
    }
  }

  void beginFacet() {
    corners_ = 0;
    inFacet_ = true;
    ++facets_;
    text_ += "facet normal 0 0 0\nouter loop\n";
  }

  void endFacet() {
    if (!std::exchange(inFacet_, false)) {
      return;
    }
    if (corners_ != 3) {
      fail("the facet before it has " + std::to_string(corners_) + " corners, and not 3");
    }
    text_ += "endloop\nendfacet\n";
  }

  void addVertex(std::string_view line) {
    if (!inFacet_) {
      fail("a vertex stands outside of a facet");
    }
    ++corners_;
    text_ += "vertex";
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = takeWord(line);
      double value = 0.0;
      if (!readNumber(word, value)) {
        fail(word.empty() ? "a vertex needs three coordinates" : quoted(word) + " is not a finite number");
      }
      (text_ += ' ') += word;
    }
    text_ += '\n';
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  std::size_t facets_ = 0;
  int corners_ = 0;
  bool broken_ = false;
  bool open_ = false;
  bool inFacet_ = false;
  std::string text_;
};

}  // namespace

StlBytes checkStl(std::string_view text, std::string_view bytes, std::string& storage) {
  std::string_view start = text.substr(0, headerSize);
  if (fitsBinary(bytes) || takeWord(start) != "solid") {
    return checkBinary(bytes);
  }
  // Some programs begin binary files with "solid" too.
  if (text.find("facet") == std::string_view::npos && bytes.find('\0') != std::string_view::npos) {
    return checkBinary(bytes);
  }
  requireNoZeroBytes(text);
  storage = TextChecker(text).check();
  return {storage, {}};
}

}  // namespace drape::io
