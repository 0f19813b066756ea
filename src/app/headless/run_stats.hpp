#pragma once

#include "app/output_file.hpp"
#include "session/simulation.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drape {

/// Collects what a run costs and writes it with what became of the cloth.
class RunStats {
 public:
  /// @param file to write to, or "" for none. Throws InputError when it cannot be written: before the run, not after.
  RunStats(const std::string& file, std::int64_t steps);

  /// Adds what the last step cost by the clock, and what it met.
  void add(const Simulation& simulation);

  /// docs/guide/headless.md says what each entry means.
  [[nodiscard]] nlohmann::ordered_json toJson(const Simulation& simulation) const;

  /// Throws InputError when the file could not be written.
  void write(const nlohmann::ordered_json& figures);

 private:
  [[nodiscard]] nlohmann::ordered_json contactJson(const ContactReport& last) const;
  [[nodiscard]] nlohmann::ordered_json choiceJson(const std::optional<StepChoice>& last) const;

  std::optional<OutputFile> file_;
  std::vector<float> seconds_;
  std::vector<float> bodySeconds_;
  std::vector<float> selfSeconds_;
  int mostOverlaps_ = 0;
  double deepestOverlap_ = 0.0;  // [m]
  int mostSqueezed_ = 0;
  std::vector<float> forceEvaluations_;
  int retriedSteps_ = 0;
  int fallbackSteps_ = 0;
  double largestError_ = -1.0;  // [m]
};

}  // namespace drape
