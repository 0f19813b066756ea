#pragma once

#include "messages/error.hpp"
#include "sim/model/sim_error.hpp"

#include <exception>
#include <string>

namespace drape::messages {

/// The fault as a sentence for the user.
[[nodiscard]] std::string inWords(const sim::ClothModelError& error);

/// The message of an exception for the user: the sentence of a SimError, what() of any other.
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
