#pragma once

#include "messages/error.hpp"

#include <gtest/gtest.h>
#include <string>

namespace drape::io {

/// The message of the InputError that `action` throws; empty, with a test failure, when it throws none.
template <typename Action>
std::string inputErrorOf(Action&& action) {
  try {
    action();
  } catch (const messages::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace drape::io
