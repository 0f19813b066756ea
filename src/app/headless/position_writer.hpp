#pragma once

#include "sim/model/cloth_state.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace drape::app {

/// Writes positions as CSV: "time,vertex,x,y,z", one line per vertex and sample, 9 significant digits, in metres and
/// seconds. A sample is taken at the first step at or after its time (to half a step).
class PositionWriter {
 public:
  /// Throws InputError when the file cannot be written.
  PositionWriter(const std::string& file, double every, double timeStep);

  /// Writes the state when a sample is due. Throws InputError when an earlier write failed.
  void sample(const sim::ClothState& state);

  /// Flushes and closes. Throws InputError when the file could not be written completely.
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

}  // namespace drape::app
