#pragma once

#include <stdexcept>
#include <string>

namespace drape {

/// Invalid input: a file, a setting, a scene. The message is for the user and tells what is wrong, where, and what to
/// do. Programs print it and exit with status 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Wrong usage of a program (unknown option, setting out of range). Programs exit with status 2.
class UsageError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace drape
