#include "io/ply_check.hpp"

#include "io/ply_header.hpp"
#include "io/quoted_text.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

namespace drape::io {
namespace {

using Kind = PlyNumber::Kind;

static_assert(std::endian::native == std::endian::little);

/// Which number is being read, for messages.
struct Place {
  const PlyElement* element = nullptr;
  std::uint64_t index = 0;  ///< of the element, from 0
};

[[noreturn]] void fail(const Place& place, const std::string& what) {
  throw messages::InputError(place.element->name + " " + std::to_string(place.index + 1) + " of " +
                             std::to_string(place.element->count) + " " + what);
}

[[noreturn]] void failCutOff(const Place& place) {
  fail(place, "is missing: the file is cut off or damaged. Export or copy it again.");
}

/// The numbers of a text file, one after the other.
class TextNumbers {
 public:
  TextNumbers(std::string_view text, std::size_t start) : text_(text), rest_(text.substr(start)) {}

  double next(const PlyNumber&, const Place& place) {
    const std::size_t begin = rest_.find_first_not_of(blanks);
    if (begin == std::string_view::npos) {
      failCutOff(place);
    }
    rest_.remove_prefix(begin);
    std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    double value = 0.0;
    if (!readNumber(word, value)) {
      const std::size_t line = lineAt(text_, text_.size() - rest_.size());
      fail(place, "has " + quoted(word) + " where a finite number should be (line " + std::to_string(line) +
                      "). Repair the file.");
    }
    return value;
  }

  /// At least two characters a number.
  [[nodiscard]] bool canHold(std::uint64_t count, std::size_t) const { return count <= rest_.size() / 2 + 1; }

  [[nodiscard]] std::size_t left() const {
    return rest_.size() - std::min(rest_.find_first_not_of(blanks), rest_.size());
  }

 private:
  static constexpr std::string_view blanks = " \t\r\n";
  std::string_view text_;
  std::string_view rest_;
};

/// The numbers of a binary file.
class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view rest, bool bigEndian) : rest_(rest), bigEndian_(bigEndian) {}

  double next(const PlyNumber& type, const Place& place) {
    if (rest_.size() < type.bytes) {
      failCutOff(place);
    }
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), rest_.data(), type.bytes);
    rest_.remove_prefix(type.bytes);
    if (bigEndian_) {
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.bytes));
    }
    return type.kind == Kind::Real ? real(raw, type.bytes) : whole(raw, type);
  }

  [[nodiscard]] bool canHold(std::uint64_t count, std::size_t bytesEach) const {
    return count <= rest_.size() / std::max<std::size_t>(1, bytesEach);
  }

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  using Raw = std::array<unsigned char, 8>;

  static double real(const Raw& raw, std::size_t bytes) {
    if (bytes == 4) {
      float value = 0.0F;
      std::memcpy(&value, raw.data(), sizeof(value));
      return static_cast<double>(value);
    }
    return std::bit_cast<double>(raw);
  }

  static double whole(const Raw& raw, const PlyNumber& type) {
    const auto bits = std::bit_cast<std::uint64_t>(raw);
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
    const bool negative = type.kind == Kind::Signed && (bits & sign) != 0;
    return static_cast<double>(bits) - (negative ? 2.0 * static_cast<double>(sign) : 0.0);
  }

  std::string_view rest_;
  bool bigEndian_;
};

bool isIndices(const PlyProperty& property) {
  return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool isCoordinate(std::string_view name) {
  return name == "x" || name == "y" || name == "z";
}

std::uint64_t countOf(const PlyHeader& header, std::string_view name) {
  std::uint64_t count = 0;
  for (const PlyElement& element : header.elements) {
    count += element.name == name ? element.count : 0;
  }
  return count;
}

/// The fewest bytes that one element takes in a binary file, and numbers in a text file.
std::size_t minSize(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += property.isList ? property.length.bytes : property.value.bytes;
  }
  return size;
}

/// The axis of a texture coordinate by its usual names; -1 for other properties.
int textureAxisOf(std::string_view name) {
  const bool first = name == "s" || name == "u" || name == "texture_u";
  const bool second = name == "t" || name == "v" || name == "texture_v";
  return first ? 0 : second ? 1 : -1;
}

/// Keeps the numbers of the mesh as they are read.
class MeshRecorder {
 public:
  explicit MeshRecorder(FileMesh& mesh) : mesh_(mesh) {}

  void begin(const PlyElement& element) {
    isVertex_ = element.name == "vertex";
    if (isVertex_) {
      mesh_.positions.emplace_back(Vec3::Zero());
      uv_.setZero();
    }
  }

  void add(const PlyProperty& property, double value) {
    if (!isVertex_) {
      return;
    }
    if (isCoordinate(property.name)) {
      mesh_.positions.back()[property.name[0] - 'x'] = value;
    } else if (const int axis = textureAxisOf(property.name); axis >= 0) {
      uv_[axis] = value;
      hasUvs_ = true;
    }
  }

  void addCorner(double vertex) { mesh_.corners.push_back(static_cast<int>(vertex)); }
  void endFace() { mesh_.endFace(); }

  void end() {
    if (isVertex_ && hasUvs_) {
      mesh_.uvs.push_back(uv_);
    }
  }

  void finish() {
    if (hasUvs_) {
      mesh_.uvCorners = mesh_.corners;
    }
  }

 private:
  FileMesh& mesh_;
  bool isVertex_ = false;
  bool hasUvs_ = false;
  Vec2 uv_ = Vec2::Zero();
};

/// The parsing library stops at a face without corners.
void requireCorners(std::size_t corners, const Place& place) {
  if (corners == 0) {
    fail(place, "has no corners: the file is damaged, or its header promises other numbers. Export or copy it again.");
  }
  if (corners > maxCorners) {
    fail(place, tooManyCorners(corners) + ". Export the mesh again.");
  }
}

template <typename Numbers>
void checkList(const PlyProperty& property, const Place& place, std::uint64_t vertices, Numbers& numbers,
               MeshRecorder& recorder) {
  const double length = numbers.next(property.length, place);
  if (!(length >= 0.0) || length != std::floor(length) || length > 4294967295.0 ||
      !numbers.canHold(static_cast<std::uint64_t>(length), property.value.bytes)) {
    failCutOff(place);
  }
  if (isIndices(property)) {
    requireCorners(static_cast<std::size_t>(length), place);
  }
  for (double i = 0.0; i < length; i += 1.0) {
    const double value = numbers.next(property.value, place);
    if (isIndices(property) && !(value >= 0.0 && value < static_cast<double>(vertices))) {
      fail(place, "uses a vertex that is not there. Export the mesh again.");
    }
    if (isIndices(property)) {
      recorder.addCorner(value);
    }
  }
  if (isIndices(property)) {
    recorder.endFace();
  }
}

template <typename Numbers>
void checkNumber(const PlyProperty& property, const Place& place, Numbers& numbers, MeshRecorder& recorder) {
  const double value = numbers.next(property.value, place);
  if (!std::isfinite(value) && isCoordinate(property.name)) {
    fail(place, "has a coordinate that is not a finite number (nan or inf). Repair the mesh.");
  }
  recorder.add(property, value);
}

/// Returns how many bytes follow the last element.
template <typename Numbers>
std::size_t checkElements(const PlyHeader& header, Numbers numbers, FileMesh& mesh) {
  MeshRecorder recorder(mesh);
  const std::uint64_t vertices = countOf(header, "vertex");
  for (const PlyElement& element : header.elements) {
    Place place{&element, 0};
    if (element.properties.empty() || !numbers.canHold(element.count, minSize(element))) {
      place.index = element.count > 0 ? element.count - 1 : 0;
      failCutOff(place);
    }
    for (; place.index < element.count; ++place.index) {
      recorder.begin(element);
      for (const PlyProperty& property : element.properties) {
        if (property.isList) {
          checkList(property, place, vertices, numbers, recorder);
        } else {
          checkNumber(property, place, numbers, recorder);
        }
      }
      recorder.end();
    }
  }
  recorder.finish();
  return numbers.left();
}

/// assimp 5.2 drops a line break at the start of binary numbers, unless the header ends in "\r\n".
std::string withLongLineBreak(std::string_view bytes, std::size_t headerSize) {
  std::string text(bytes.substr(0, headerSize));
  text.resize(text.find_last_not_of("\r\n") + 1);
  text += "\r\n";
  return text.append(bytes.substr(headerSize));
}

void requireCoordinates(const PlyHeader& header) {
  std::string found;
  for (const PlyElement& element : header.elements) {
    for (const PlyProperty& property : element.properties) {
      found += element.name == "vertex" && !property.isList && isCoordinate(property.name) ? property.name : "";
    }
  }
  for (const char axis : {'x', 'y', 'z'}) {
    if (found.find(axis) == std::string::npos) {
      throw messages::InputError(std::string("its vertices have no '") + axis + "'. Export the mesh again.");
    }
  }
}

void requireIndices(const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "face" && std::any_of(element.properties.begin(), element.properties.end(), isIndices)) {
      return;
    }
  }
  throw messages::InputError("its faces have no list 'vertex_indices' or 'vertex_index'. Export the mesh again.");
}

}  // namespace

PlyBytes checkPly(std::string_view text, std::string_view bytes, std::string& storage) {
  const PlyHeader header = readPlyHeader(text);
  if (countOf(header, "vertex") == 0 || countOf(header, "face") == 0) {
    throw messages::InputError(
        "there are no faces in it. A cloth needs a mesh of triangles or polygons, not a cloud of points.");
  }
  requireCoordinates(header);
  requireIndices(header);
  PlyBytes result{bytes, {}, {}};
  if (header.format == PlyHeader::Format::Text) {
    requireNoZeroBytes(text);
    const std::size_t left = checkElements(header, TextNumbers(text, header.size), result.mesh);
    if (left > 0) {
      const std::size_t line = lineAt(text, text.size() - left);
      result.warnings.push_back(moreThanPromised("Line " + std::to_string(line) + " and what follows it are"));
    }
    result.bytes = text;
    if (text.back() != '\n') {
      result.warnings.push_back(endsWithoutBreak(lineAt(text, text.size())));
    }
    return result;
  }
  const PlyHeader binary = readPlyHeader(bytes);
  const std::string_view numbers = bytes.substr(binary.size);
  const bool bigEndian = header.format == PlyHeader::Format::BigEndian;
  // Some programs end binary files with a line break too.
  constexpr std::size_t lineBreak = 2;
  if (const std::size_t left = checkElements(binary, BinaryNumbers(numbers, bigEndian), result.mesh);
      left > lineBreak) {
    result.warnings.push_back(moreThanPromised("The last " + std::to_string(left) + " bytes are"));
  }
  if (!numbers.empty() && numbers.front() == '\n') {
    storage = withLongLineBreak(bytes, binary.size);
    result.bytes = storage;
  }
  return result;
}

}  // namespace drape::io
