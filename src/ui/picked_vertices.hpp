#pragma once

#include "fields/probes.hpp"
#include "session/snapshot.hpp"
#include "ui/time_samples.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace drape::ui {

/// The vertices that the user has marked, and their values in some seconds of simulated time. Values stay when the
/// simulation returns to an earlier time of its timeline, and end where another motion replaces them. Another scene has
/// no marks.
class PickedVertices {
 public:
  static constexpr std::size_t maxCount = 4;
  /// Length of what is shown [s].
  static constexpr double window = 20.0;
  /// Length of what is kept: that of the timeline [s].
  static constexpr double kept = 60.0;
  /// Minimum distance between samples, except for the newest [s].
  static constexpr double spacing = 0.02;

  /// The values at one simulated time.
  struct Sample {
    double time = 0.0;           ///< [s]
    std::vector<double> values;  ///< as of fields::probe()
  };

  /// Marks a vertex, or removes its mark. @return false if no more can be marked
  bool toggle(int vertex);
  void clear();

  /// Adds the values of a snapshot. Adding the same one again changes nothing.
  void follow(const session::Snapshot& snapshot, fields::SnapshotFields& fields);

  [[nodiscard]] std::span<const int> vertices() const { return vertices_; }
  /// Those of the last seconds, in order of time. After a return to a time long ago, those around it.
  [[nodiscard]] std::span<const Sample> samples() const { return samples_.around(window); }
  /// The values at the present time. There must be samples.
  [[nodiscard]] const Sample& now() const { return now_; }
  /// samples() as a table (fields::probeTitles).
  [[nodiscard]] std::string csv() const;

 private:
  std::vector<int> vertices_;
  TimeSamples<Sample> samples_{kept, spacing};
  Sample now_;
  std::shared_ptr<const scene::Scene> scene_;
  std::int64_t version_ = -1;
};

}  // namespace drape::ui
