#pragma once

#include "session/simulation.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape::app {

/// Counts the intersecting triangle pairs of a running cloth at intervals, with exact arithmetic
/// (intersection/intersections.hpp): pairs within the cloth, and pairs with the active bodies as they are drawn.
class IntersectionWatch {
 public:
  /// @param every steps between two counts, at least 1
  explicit IntersectionWatch(std::int64_t every) : every_(every) {}

  /// Call it at the start and after each step. It counts at every multiple of `every`.
  void observe(const session::Simulation& simulation);

  /// Call it at the end. It counts there too, unless the last step has been counted.
  void finish(const session::Simulation& simulation);

  /// Adds `intersecting_pairs_...` and `intersection_check_us` to the results of a run (docs/guide/headless.md).
  void addTo(nlohmann::ordered_json& json) const;

  /// For the terminal: "intersecting triangle pairs: at most 12 (step 40), 3 at the end".
  [[nodiscard]] std::string summary() const;

 private:
  /// The counts of one kind over a run.
  struct Tally {
    std::size_t max = 0;
    std::size_t last = 0;
    std::int64_t worstStep = 0;  ///< the first step with the maximum
    void add(std::int64_t step, std::size_t count);
    [[nodiscard]] nlohmann::ordered_json toJson() const;
    [[nodiscard]] std::string text() const;
  };

  void count(const session::Simulation& simulation);

  std::int64_t every_;
  std::int64_t lastStep_ = -1;
  Tally all_;
  Tally self_;
  Tally bodies_;
  std::vector<double> seconds_;  ///< of each count
};

}  // namespace drape::app
