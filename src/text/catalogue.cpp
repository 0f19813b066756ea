#include "text/catalogue.hpp"

#include <vector>

namespace drape::text {

std::string Catalogue::operator()(std::string_view english) const {
  if (entries_ != nullptr) {
    if (const auto found = entries_->find(english); found != entries_->end()) {
      return found->second;
    }
    if (missing_ != nullptr && !english.empty()) {
      missing_->emplace(english);
    }
  }
  // The meaning before a bar is one small word.
  const std::size_t end = english.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  const bool hasMeaning = end != std::string_view::npos && end > 0 && english[end] == '|';
  return std::string(hasMeaning ? english.substr(end + 1) : english);
}

std::string Catalogue::operator()(const Sentence& sentence) const {
  std::string text;
  for (const Sentence::Part& part : sentence.parts_) {
    std::vector<std::string> arguments;
    arguments.reserve(part.arguments.size());
    for (const Sentence& argument : part.arguments) {
      arguments.push_back((*this)(argument));
    }
    text += part.isVerbatim ? part.english : filled((*this)(part.english), arguments);
  }
  return text;
}

}  // namespace drape::text
