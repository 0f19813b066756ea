#pragma once

#include "session/simulation.hpp"

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape {

/// Collects what a run costs and writes it with what became of the cloth.
class RunStats {
 public:
  /// @param file to write to, or "" for none. Throws InputError when it cannot be written: before the run, not after.
  RunStats(const std::string& file, std::int64_t steps);

  /// Adds a step's wall-clock time [s].
  void add(double seconds) { seconds_.push_back(static_cast<float>(seconds)); }

  /// docs/headless.md says what each entry means.
  [[nodiscard]] nlohmann::ordered_json toJson(const Simulation& simulation) const;

  /// Throws InputError when the file could not be written.
  void write(const nlohmann::ordered_json& figures);

 private:
  std::string name_;
  std::ofstream file_;
  std::vector<float> seconds_;
};

}  // namespace drape
