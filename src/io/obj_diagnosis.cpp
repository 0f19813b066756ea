#include "io/obj_diagnosis.hpp"

#include "io/quoted_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace drape {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Takes the next word off the front of a line; empty at its end.
std::string_view takeWord(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

std::string checkVertex(std::string_view line) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = takeWord(line);
    if (word.empty()) {
      return "a vertex needs three coordinates";
    }
    const std::string_view digits = word.substr(word[0] == '+' ? 1 : 0);
    double value = 0.0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    // Coordinates are kept in single precision.
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() ||
        !std::isfinite(static_cast<float>(value))) {
      return quoted(word) + " is not a finite number";
    }
  }
  return "";
}

std::string checkFace(std::string_view line, long long vertices) {
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    long long index = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), index);
    if (result.ec != std::errc()) {
      return quoted(word) + " is not the number of a vertex";
    }
    if (index == 0) {
      return "vertex 0 does not exist: OBJ counts from 1";
    }
    if (index > vertices || index < -vertices) {
      return "there is no vertex " + std::to_string(index) + ", only " + std::to_string(vertices) + " come before it";
    }
  }
  return "";
}

}  // namespace

std::string diagnoseObj(std::string_view text) {
  long long vertices = 0;
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::string_view keyword = takeWord(line);
    std::string problem;
    if (keyword == "v") {
      problem = checkVertex(line);
      ++vertices;
    } else if (keyword == "f") {
      problem = checkFace(line, vertices);
    }
    if (!problem.empty()) {
      return "line " + std::to_string(number) + ": " + problem;
    }
  }
  return "";
}

}  // namespace drape
