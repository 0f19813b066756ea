#pragma once

#include "report/references.hpp"
#include "report/sections/set_ups.hpp"
#include "report/sections/work_material.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace drape::report::sections {

/// Times at which errors are measured [s], and for the last of them: checkpoints, steps of 1/150 s.
inline constexpr std::array measuredTimes{0.2, 0.5};
inline constexpr int measuredCheckpoints = 15;
inline constexpr std::array stepsToMeasured{30, 75};

/// The amplitude of the jitter of a start [m], and the number of seeds.
inline constexpr double jitterLength = 1e-6;
inline constexpr int seedCount = 5;
/// A motion is chaotic when the jitter has grown beyond this [m].
inline constexpr double chaoticFloor = 1e-4;

/// A cloth for the comparison of methods, and its reference, which is made on first use.
class ClothWithReference {
 public:
  /// @param resolution 0 for a mesh
  ClothWithReference(SetUp setUp, int resolution, WorkMaterial material, bool quick)
      : setUp_(std::move(setUp)), resolution_(resolution), material_(std::move(material)), quick_(quick) {}

  [[nodiscard]] const std::string& name() const { return setUp_.name; }
  [[nodiscard]] int resolution() const { return resolution_; }
  [[nodiscard]] const WorkMaterial& material() const { return material_; }

  const scene::Scene& scene();

  /// The cloth from a jittered start; the seed is from 1 to seedCount.
  const scene::Scene& jitteredScene(int seed);

  /// Null when small steps do not converge here.
  const Reference* reference(const std::function<void()>& checkStop);

  /// The growth of a jitter of the start until that checkpoint: mean over the seeds of the mean distance [m]. Not a
  /// number without a reference.
  double noiseFloor(int checkpoint, const std::function<void()>& checkStop);

 private:
  void findReference(const std::function<void()>& checkStop);
  void findFloor(const std::function<void()>& checkStop);

  SetUp setUp_;
  int resolution_;
  WorkMaterial material_;
  bool quick_;
  std::shared_ptr<const scene::Scene> scene_;
  std::array<std::shared_ptr<const scene::Scene>, seedCount> jittered_;
  std::optional<Reference> reference_;
  bool tried_ = false;
  std::vector<double> floor_;  // [k] at checkpoint k [m]
};

}  // namespace drape::report::sections
