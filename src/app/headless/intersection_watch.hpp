#pragma once

#include "session/simulation.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape {

/// Counts the intersecting triangle pairs of a running cloth now and then, by exact arithmetic
/// (judge/intersections.hpp).
class IntersectionWatch {
 public:
  /// @param every steps between two counts, at least 1
  explicit IntersectionWatch(std::int64_t every) : every_(every) {}

  /// Call at the start and after each step: counts at every multiple of `every`.
  void observe(const Simulation& simulation);

  /// Call at the end: counts there too, unless the last step has been counted.
  void finish(const Simulation& simulation);

  /// Adds `intersecting_pairs_...` and `intersection_check_us` to a run's figures (docs/headless.md).
  void addTo(nlohmann::ordered_json& json) const;

  /// For the terminal: "intersecting triangle pairs: at most 12 (step 40), 3 at the end".
  [[nodiscard]] std::string summary() const;

 private:
  void count(const Simulation& simulation);

  std::int64_t every_;
  std::int64_t lastStep_ = -1;
  std::int64_t worstStep_ = 0;  ///< the first at which there were most
  std::size_t most_ = 0;
  std::size_t last_ = 0;
  std::vector<double> seconds_;  ///< of each count
};

}  // namespace drape
