#pragma once

#include <stdexcept>
#include <string>

namespace drape::messages {

/// Invalid input: a file, a setting, a scene. The message is for the user and tells what is wrong, where, and what to
/// do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A request that the documentation excludes: an unknown option, a setting out of range. Programs tell it apart from
/// other invalid input (ExitStatus in app/command_line.hpp).
class UsageError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace drape::messages
