#pragma once

// To be included before Highway. Registers whose size only the machine knows cannot stand in the structs of the vector
// loops, so Arm's scalable ones are left out; NEON, which every 64-bit Arm has, serves.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
