#pragma once

#include "app/output_file.hpp"
#include "session/simulation.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {

/// Collects the cost of a run and writes it with the final state of the cloth.
class RunStats {
 public:
  /// @param file to write to, or "" for none. Throws InputError before the run when it cannot be written.
  RunStats(const std::string& file, std::int64_t steps);

  /// Adds the duration and the report of the last step.
  void add(const session::Simulation& simulation);

  /// docs/guide/headless.md explains each entry.
  [[nodiscard]] nlohmann::ordered_json toJson(const session::Simulation& simulation) const;

  /// Throws InputError when the file could not be written.
  void write(const nlohmann::ordered_json& figures);

 private:
  [[nodiscard]] nlohmann::ordered_json contactJson(const session::Simulation& simulation) const;
  [[nodiscard]] nlohmann::ordered_json choiceJson(const session::Simulation& simulation) const;

  std::optional<OutputFile> file_;
  std::vector<float> seconds_;
  std::vector<float> bodySeconds_;
  std::vector<float> selfSeconds_;
  std::vector<float> impulseSeconds_;  // of contacts in the substeps of the solver
  int maxOverlaps_ = 0;
  double deepestOverlap_ = 0.0;  // [m]
  int maxInfeasible_ = 0;
  int maxCrossings_ = 0;
  int maxIntersections_ = 0;
  std::vector<float> forceEvaluations_;
  int retriedSteps_ = 0;
  int fallbackSteps_ = 0;
  double largestError_ = -1.0;  // [m]
};

}  // namespace drape::app
