#pragma once

#include "io/animation/part_file.hpp"
#include "session/simulation.hpp"

#include <string>
#include <vector>

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

/// Continues a simulation from a file. Throws InputError with the name of the file.
/// @return a sentence for each setting and each part of the scene that has changed since, if it acts on the motion
[[nodiscard]] std::vector<std::string> resumeFrom(const std::string& file, session::Simulation& simulation);

}  // namespace drape::app
