#pragma once

#include "io/animation/part_file.hpp"
#include "session/simulation.hpp"

#include <string>

namespace drape::app {

/// A file for the checkpoint of a simulation. It is written beside its name and renamed.
class CheckpointFile {
 public:
  /// Throws UsageError when checkpoints of the simulation are not possible, and InputError when the file cannot be
  /// written, so that both show before the run.
  CheckpointFile(const std::string& file, const session::Simulation& simulation);

  /// Writes the checkpoint. Call it once. Throws InputError.
  void write(const session::Simulation& simulation);

 private:
  io::animation::PartFile file_;
};

/// Continues a simulation from a file. Settings that have changed since are noted on standard error. Throws InputError
/// with the name of the file.
void resumeFrom(const std::string& file, session::Simulation& simulation);

}  // namespace drape::app
