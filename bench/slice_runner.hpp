#pragma once

#include "bench/cloths.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/simd/thread_team.hpp"

namespace drape::bench {

enum class Method { OneIteration, Verlet };

/// Steps of a cloth that stays in the sliced layout: the cost of a step without the conversion of the state before the
/// first and after the last step.
template <typename T>
class SliceRunner {
 public:
  SliceRunner(ModelPtr model, Method method, const sim::StepParameters& parameters);

  /// The state with waves from which each batch starts.
  void restart();

  void steps(int count);

  /// Throws when a position is not finite or far away: such numbers may cost less or more.
  void check();

  [[nodiscard]] const sim::ClothModel& model() const { return *model_; }

 private:
  void phases(int member, int count);

  ModelPtr model_;
  Method method_;
  sim::simd::SlicedCloth<T> cloth_;
  sim::simd::SliceStep<T> step_;
  sim::ClothState start_;
  int threads_;
  sim::simd::ThreadTeam team_;
};

/// The time of a batch of steps that starts from the waves: CPU time of the thread, or wall-clock time.
template <typename T>
[[nodiscard]] double batchSeconds(SliceRunner<T>& runner, int count, bool wall = false);

}  // namespace drape::bench
