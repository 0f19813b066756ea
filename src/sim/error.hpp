#pragma once

#include <stdexcept>
#include <string>

namespace drape {

/// Bad input from outside: a file, a setting, a scene. The message is for the user and says what is wrong, where,
/// and what to do about it. Programs print it and exit with status 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The program was called wrongly (unknown option, setting out of range). Programs exit with status 2.
class UsageError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace drape
