#pragma once

#include <string>

namespace drape::sim::simd {

/// The instruction set of the vectorised steps on this machine, as "AVX2".
[[nodiscard]] std::string simdTarget();

}  // namespace drape::sim::simd
