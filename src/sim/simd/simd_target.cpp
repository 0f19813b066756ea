#include "sim/simd/simd_target.hpp"

#include "sim/simd/targets.hpp"

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace drape {

std::string simdTarget() {
  // Of those that were compiled and that the machine has, the lowest bit is the best.
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);
}

}  // namespace drape
