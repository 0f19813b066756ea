#include "io/ply_header.hpp"

#include "io/quoted_text.hpp"
#include "messages/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace drape::io {
namespace {

using Kind = PlyNumber::Kind;

constexpr std::array<std::pair<std::string_view, PlyNumber>, 16> numberTypes{{
    {"char", {Kind::Signed, 1}},
    {"int8", {Kind::Signed, 1}},
    {"uchar", {Kind::Unsigned, 1}},
    {"uint8", {Kind::Unsigned, 1}},
    {"short", {Kind::Signed, 2}},
    {"int16", {Kind::Signed, 2}},
    {"ushort", {Kind::Unsigned, 2}},
    {"uint16", {Kind::Unsigned, 2}},
    {"int", {Kind::Signed, 4}},
    {"int32", {Kind::Signed, 4}},
    {"uint", {Kind::Unsigned, 4}},
    {"uint32", {Kind::Unsigned, 4}},
    {"float", {Kind::Real, 4}},
    {"float32", {Kind::Real, 4}},
    {"double", {Kind::Real, 8}},
    {"float64", {Kind::Real, 8}},
}};

std::vector<std::string> wordsOf(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string> words;
  std::size_t begin = line.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

/// Parses the header line by line.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}

  PlyHeader read() {
    if (wordsOf(nextLine()) != std::vector<std::string>{"ply"}) {
      throw messages::InputError(
          "it is not a PLY file: its first line is not 'ply'. Check the file, or export it again.");
    }
    while (true) {
      const std::vector<std::string> words = wordsOf(nextLine());
      if (!words.empty() && words[0] == "end_header") {
        if (!hasFormat_) {
          throw messages::InputError("its header has no line 'format'. Export the mesh again.");
        }
        header_.size = position_;
        return header_;
      }
      readLine(words);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw messages::InputError("line " + std::to_string(line_) + " of its header " + what + ". Export the mesh again.");
  }

  std::string_view nextLine() {
    const std::size_t end = bytes_.find('\n', position_);
    if (end == std::string_view::npos || end - position_ > 4096) {
      throw messages::InputError("its header does not end: the file is cut off or damaged. Export the mesh again.");
    }
    const std::string_view line = bytes_.substr(position_, end - position_);
    position_ = end + 1;
    ++line_;
    return line;
  }

  void readLine(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      return;
    }
    if (words[0] == "format" && words.size() == 3) {
      readFormat(words[1]);
    } else if (words[0] == "element" && words.size() == 3) {
      readElement(words);
    } else if (words[0] == "property" && (words.size() == 3 || (words.size() == 5 && words[1] == "list"))) {
      readProperty(words);
    } else {
      fail("has an unknown keyword: " + quoted(words[0]));
    }
  }

  void readFormat(const std::string& word) {
    if (std::exchange(hasFormat_, true)) {
      fail("names a second format, " + quoted(word));
    }
    if (word == "ascii") {
      header_.format = PlyHeader::Format::Text;
    } else if (word == "binary_little_endian") {
      header_.format = PlyHeader::Format::LittleEndian;
    } else if (word == "binary_big_endian") {
      header_.format = PlyHeader::Format::BigEndian;
    } else {
      fail("names an unknown format, " + quoted(word));
    }
  }

  void readElement(const std::vector<std::string>& words) {
    PlyElement element{words[1], 0, {}};
    if (quoted(words[1]) != "'" + words[1] + "'") {
      fail("names an unknown element, " + quoted(words[1]));
    }
    const char* const end = words[2].data() + words[2].size();
    const auto result = std::from_chars(words[2].data(), end, element.count);
    if (result.ec != std::errc() || result.ptr != end) {
      fail("promises " + quoted(words[2]) + " of an element, which is not a count");
    }
    header_.elements.push_back(element);
  }

  void readProperty(const std::vector<std::string>& words) {
    if (header_.elements.empty()) {
      fail("names a property before any element");
    }
    const bool isList = words.size() == 5;
    PlyProperty property{words.back(), numberType(words[words.size() - 2]), isList, {}};
    if (isList) {
      property.length = numberType(words[2]);
      if (property.length.kind == Kind::Real) {
        fail("gives a list a length that is not a whole number");
      }
    }
    header_.elements.back().properties.push_back(property);
  }

  [[nodiscard]] PlyNumber numberType(const std::string& word) const {
    const auto* const found = std::find_if(numberTypes.begin(), numberTypes.end(),
                                           [&word](const auto& entry) { return entry.first == word; });
    if (found == numberTypes.end()) {
      fail("names an unknown type, " + quoted(word));
    }
    return found->second;
  }

  std::string_view bytes_;
  std::size_t position_ = 0;
  int line_ = 0;
  bool hasFormat_ = false;
  PlyHeader header_;
};

}  // namespace

PlyHeader readPlyHeader(std::string_view bytes) {
  return HeaderReader(bytes).read();
}

}  // namespace drape::io
