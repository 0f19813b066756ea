#pragma once

// Include this before Highway. The vector loops keep registers in structs, so their size must be known at compile time.
// This excludes Arm's scalable vectors; NEON, which every 64-bit Arm processor has, is used instead.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
