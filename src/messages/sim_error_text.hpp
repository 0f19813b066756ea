#pragma once

#include "messages/error.hpp"
#include "sim/model/sim_error.hpp"
#include "text/sentence.hpp"

#include <exception>
#include <string>
#include <string_view>

namespace drape::messages {

/// The fault as a sentence for the user.
[[nodiscard]] text::Sentence inWords(const sim::ClothModelError& error);

/// The refusal of a solver that cannot move a fabric, with the names of those that can.
/// @param setting the key of the setting that names it
[[nodiscard]] text::Sentence takesSpringsOnly(std::string_view setting, std::string_view solver);

/// The message of an exception for the user: the sentence of a SimError or a SentenceError, what() of any other,
/// which is translated where a catalogue has it. messageOf is in English.
[[nodiscard]] text::Sentence sentenceOf(const std::exception& error);
[[nodiscard]] std::string messageOf(const std::exception& error);

/// Calls `call` and returns its result. A SimError becomes an InputError with its sentence.
template <typename Call>
auto withInputErrors(const Call& call) {
  try {
    return call();
  } catch (const sim::SimError& error) {
    throw InputError(messageOf(error));
  }
}

}  // namespace drape::messages
