#pragma once

#include "sim/cloth_state.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace drape {

/// Writes positions as CSV: "time,vertex,x,y,z", one line a vertex and sample, 9 significant digits, metres and
/// seconds. A sample is taken at the first step that is not earlier than its due time (to half a step).
class PositionWriter {
 public:
  /// Throws InputError when the file cannot be written.
  PositionWriter(const std::string& file, double every, double timeStep);

  /// Writes the state when a sample is due. Throws InputError when what came before could not be written.
  void sample(const ClothState& state);

  /// Flushes and closes. Throws InputError when not everything could be written.
  void close();

 private:
  [[noreturn]] void fail(int reason) const;

  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string name_;
  std::unique_ptr<std::FILE, Closer> file_;
  double every_;
  double tolerance_;
  std::int64_t samples_ = 0;
};

}  // namespace drape
