#pragma once

#include "app/exported_cloth.hpp"
#include "session/simulation.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {

/// The arguments "--export FILE... [--rate R] [--coordinates file|scene]".
struct ExportArguments {
  std::vector<std::string> files;
  std::optional<double> rate;  ///< frames per second
  std::string coordinates;     ///< "file", "scene", or empty for the usual ones

  void addTo(CLI::App& app);
  /// Whether any file holds several frames. Throws UsageError for an unknown format.
  [[nodiscard]] bool hasFrames() const;
  [[nodiscard]] double frameRate() const;
};

/// The numbers of frames; frame 0 is the start.
struct FrameRange {
  int first = 0;
  int count = 1;  ///< at least 1
};

/// Writes the motion of a simulation to files (docs/guide/export.md): the last state, or frames at exact times, the
/// first of which is the start.
class MotionExport {
 public:
  /// @param steps that the simulation will take from its present one; the present state is the first frame if it is one
  /// Opens the files. Throws UsageError for names and formats that do not fit, and InputError when a file cannot be
  /// written.
  MotionExport(const ExportArguments& arguments, const session::Simulation& simulation, std::int64_t steps);
  /// The same for frames that `addFrame` adds.
  MotionExport(ExportArguments arguments, const session::Simulation& simulation, FrameRange frames);
  ~MotionExport();
  MotionExport(const MotionExport&) = delete;
  MotionExport& operator=(const MotionExport&) = delete;

  /// Call it at the start and after each step. Throws InputError when a file cannot be written.
  void sample(const session::Simulation& simulation);
  /// @param positions of the cloth in the next frame [m]
  void addFrame(const session::Simulation& simulation, const std::vector<Vec3>& positions);
  /// Ends the files. @param last positions at the end [m]
  void finish(const session::Simulation& simulation, const std::vector<Vec3>& last);
  /// The names of all files, those of single frames included.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  /// One line for each file: its name, frames and vertices.
  [[nodiscard]] std::vector<std::string> summary() const;

 private:
  struct Output;
  void open(const session::Simulation& simulation);
  void add(const std::string& file, const session::Simulation& simulation);
  void addOutput(const std::string& file, const std::vector<std::size_t>& cloths,
                 const session::Simulation& simulation);

  std::vector<Output> outputs_;
  ExportArguments arguments_;
  int stepsPerFrame_ = 1;
  FrameRange frames_;
};

}  // namespace drape::app
