#pragma once

#include <string>

namespace drape {

/// The instruction set that the vectorised steps use on this machine: "AVX2".
[[nodiscard]] std::string simdTarget();

}  // namespace drape
