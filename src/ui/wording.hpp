#pragma once

#include "text/sentence.hpp"

#include <concepts>
#include <string_view>
#include <utility>

namespace drape::ui {

/// What the window says at some place: an English text that is translated, or a sentence. Sentence::verbatim() makes
/// one of a name.
class Wording : public text::Sentence {
 public:
  Wording() = default;
  template <std::convertible_to<std::string_view> Text>
  Wording(const Text& english) : text::Sentence(std::string_view(english)) {}
  Wording(text::Sentence sentence) : text::Sentence(std::move(sentence)) {}
};

}  // namespace drape::ui
