#pragma once

#include "fields/probes.hpp"
#include "session/simulation.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace drape::app {

/// The arguments "[--probe VERTEX,... --probe-output FILE]".
struct ProbeArguments {
  std::vector<int> vertices;
  std::string file;

  void addTo(CLI::App& app);
};

/// Writes the values of all fields at some vertices as CSV (fields::probeTitles), one line a step. It writes FILE.part
/// and renames it at the end, so that an older FILE stays until the new one is complete.
class ProbeWriter {
 public:
  /// Asks the simulation for what the fields need, and writes the first line. Throws UsageError for a vertex that does
  /// not exist, and InputError when the file cannot be written.
  ProbeWriter(const ProbeArguments& arguments, session::Simulation& simulation);

  /// Writes one line. Throws InputError when an earlier write failed.
  void sample(const session::Simulation& simulation);

  /// Closes and renames. Throws InputError when the file could not be written completely.
  void close();

 private:
  [[noreturn]] void fail(int reason) const;

  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::vector<int> vertices_;
  std::string name_;
  std::unique_ptr<std::FILE, Closer> file_;
  session::Snapshot snapshot_;
  fields::SnapshotFields fields_;
};

}  // namespace drape::app
