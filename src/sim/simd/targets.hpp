#pragma once

// Include this before Highway. The vector loops keep registers in structs, so their size must be known at compile time.
// This excludes Arm's scalable vectors; NEON, which every 64-bit Arm processor has, is used instead.
#define DRAPE_SCALABLE_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

// Each instruction set takes minutes to compile with a sanitizer. Sanitizer builds contain only the narrowest and AVX2.
#ifdef DRAPE_SANITIZED
#define HWY_DISABLED_TARGETS (DRAPE_SCALABLE_TARGETS | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS DRAPE_SCALABLE_TARGETS
#endif
