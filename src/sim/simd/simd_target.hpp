#pragma once

#include <string>

namespace drape {

/// The instruction set of the vectorised steps on this machine, as "AVX2".
[[nodiscard]] std::string simdTarget();

}  // namespace drape
