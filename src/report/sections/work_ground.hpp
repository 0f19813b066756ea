#pragma once

#include "report/references.hpp"
#include "report/sections/set_ups.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace drape {

/// Times at which errors are judged [s], and up to the last of them: checkpoints, steps of 1/150 s up to each.
inline constexpr std::array judgedTimes{0.2, 0.5};
inline constexpr int judgedCheckpoints = 15;
inline constexpr std::array stepsToJudged{30, 75};

/// By how much a start is jittered to see how far that carries [m], and in how many ways.
inline constexpr double jitterLength = 1e-6;
inline constexpr int seedCount = 5;
/// A motion is called chaotic where jitter has grown to more than this [m].
inline constexpr double chaoticFloor = 1e-4;

/// A cloth that methods are compared on, with what they are held against; that is made when the first of them asks.
class WorkGround {
 public:
  WorkGround(SetUp setUp, int resolution, std::string stiffness, bool quick)
      : setUp_(std::move(setUp)), resolution_(resolution), stiffness_(std::move(stiffness)), quick_(quick) {}

  [[nodiscard]] const std::string& name() const { return setUp_.name; }
  [[nodiscard]] int resolution() const { return resolution_; }
  [[nodiscard]] const std::string& stiffness() const { return stiffness_; }

  const Scene& scene();

  /// The cloth from a jittered start; the seed is from 1 to seedCount.
  const Scene& jitteredScene(int seed);

  /// Null when small steps come to no end here.
  const Reference* reference(const std::function<void()>& checkStop);

  /// How far a jitter of the start has carried the converged motion at that checkpoint: mean over the seeds of the mean
  /// distance [m]. Not a number where there is no reference.
  double noiseFloor(int checkpoint, const std::function<void()>& checkStop);

 private:
  void findReference(const std::function<void()>& checkStop);
  void findFloor(const std::function<void()>& checkStop);

  SetUp setUp_;
  int resolution_;
  std::string stiffness_;
  bool quick_;
  std::shared_ptr<const Scene> scene_;
  std::array<std::shared_ptr<const Scene>, seedCount> jittered_;
  std::optional<Reference> reference_;
  bool tried_ = false;
  std::vector<double> floor_;  // [k] at checkpoint k [m]
};

}  // namespace drape
