#pragma once

#include "messages/error.hpp"
#include "text/sentence.hpp"

#include <utility>

namespace drape::messages {

/// Invalid input from the window or a file, whose message can be translated.
class SentenceError : public InputError {
 public:
  explicit SentenceError(text::Sentence sentence) : InputError(sentence.english()), sentence_(std::move(sentence)) {}

  [[nodiscard]] const text::Sentence& sentence() const { return sentence_; }

 private:
  text::Sentence sentence_;
};

}  // namespace drape::messages
