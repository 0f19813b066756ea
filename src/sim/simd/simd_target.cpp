#include "sim/simd/simd_target.hpp"

#include "sim/simd/targets.hpp"

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace drape::sim::simd {

std::string simdTarget() {
  // The lowest bit is the best target that was compiled and that the machine supports.
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);
}

}  // namespace drape::sim::simd
