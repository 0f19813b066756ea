#include "text/sentence.hpp"

#include "text/catalogue.hpp"

#include <cctype>
#include <cstddef>
#include <ostream>

namespace drape::text {
namespace {

/// A placeholder in a template.
struct Placeholder {
  std::size_t begin = std::string_view::npos;
  std::size_t end = 0;
  std::size_t index = 0;  ///< of its argument
};

/// The first placeholder from a place on. Other braces are text. @param next index of the argument of "{}"
Placeholder findPlaceholder(std::string_view pattern, std::size_t from, std::size_t next) {
  for (std::size_t begin = pattern.find('{', from); begin != std::string_view::npos;
       begin = pattern.find('{', begin + 1)) {
    if (pattern.substr(begin).starts_with("{}")) {
      return {begin, begin + 2, next};
    }
    const bool isNumbered = begin + 2 < pattern.size() && pattern[begin + 2] == '}' &&
                            std::isdigit(static_cast<unsigned char>(pattern[begin + 1])) != 0;
    if (isNumbered) {
      return {begin, begin + 3, static_cast<std::size_t>(pattern[begin + 1] - '0')};
    }
  }
  return {};
}

}  // namespace

Sentence Sentence::verbatim(std::string_view text) {
  Sentence sentence;
  if (!text.empty()) {
    Part& part = sentence.parts_.emplace_back();
    part.english = text;
    part.isVerbatim = true;
  }
  return sentence;
}

std::string Sentence::english() const {
  return Catalogue()(*this);
}

Sentence& Sentence::append(std::string_view separator, const Sentence& more) {
  const std::vector<Part> added = more.parts_;  // which may be these
  if (!empty() && !added.empty() && !separator.empty()) {
    parts_.push_back(verbatim(separator).parts_.front());
  }
  parts_.insert(parts_.end(), added.begin(), added.end());
  return *this;
}

bool operator==(const Sentence& sentence, std::string_view english) {
  return sentence.english() == english;
}

std::ostream& operator<<(std::ostream& out, const Sentence& sentence) {
  return out << sentence.english();
}

std::string filled(std::string_view pattern, const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    return std::string(pattern);
  }
  std::string text;
  std::size_t at = 0;
  std::size_t next = 0;
  for (Placeholder found = findPlaceholder(pattern, at, next); found.begin != std::string_view::npos;
       found = findPlaceholder(pattern, at, next)) {
    text += pattern.substr(at, found.begin - at);
    text += found.index < arguments.size() ? arguments[found.index] : std::string();
    at = found.end;
    ++next;
  }
  text += pattern.substr(at);
  return text;
}

std::vector<std::size_t> placeholdersOf(std::string_view pattern) {
  std::vector<std::size_t> indices;
  for (Placeholder found = findPlaceholder(pattern, 0, 0); found.begin != std::string_view::npos;
       found = findPlaceholder(pattern, found.end, indices.size())) {
    indices.push_back(found.index);
  }
  return indices;
}

}  // namespace drape::text
