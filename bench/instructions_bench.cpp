// The same step with each of the instruction sets that this machine has.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

#include <hwy/highway.h>

namespace drape::bench {
namespace {

constexpr int batch = 50;

/// Restricts the choice of instructions while it lives.
class Instructions {
 public:
  explicit Instructions(std::int64_t target) { choose(target); }
  Instructions(const Instructions&) = delete;
  Instructions& operator=(const Instructions&) = delete;
  ~Instructions() { choose(0); }

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
  }
};

}  // namespace

void addInstructionsGroup(Suite& suite) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const std::string name = hwy::TargetName(target);
    suite.add({"instructions", "full step 33x33, " + name, "us/step"}, [target]() -> Batch {
      auto runner = std::make_shared<SliceRunner<float>>(grid(33), Method::OneIteration, fullStep());
      return {batch, [runner, target] {
                const Instructions only(target);
                return batchSeconds(*runner, batch);
              }};
    });
  }
}

}  // namespace drape::bench
