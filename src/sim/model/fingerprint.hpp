#pragma once

#include "sim/model/vector.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace drape::sim {

/// Mixes two 64-bit values; every bit of the result depends on all bits of both. The hash of everything that is
/// compared within one run. Results that are kept use the state hash (cloth_state.hpp).
[[nodiscard]] constexpr std::uint64_t mixHash(std::uint64_t seed, std::uint64_t value) {
  std::uint64_t mixed = (seed ^ value) * 0x9e3779b97f4a7c15ULL;
  mixed ^= mixed >> 32;
  mixed *= 0xd6e8feb86659fd93ULL;
  return mixed ^ (mixed >> 29);
}

/// A hash of numbers, to notice that any of them changed.
class Fingerprint {
 public:
  void add(std::uint64_t bits) { value_ = mixHash(value_, bits); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& value) {
    for (int c = 0; c < 3; ++c) {
      add(value[c]);
    }
  }
  /// Never 0, which means that there is none.
  [[nodiscard]] std::uint64_t value() const { return std::max<std::uint64_t>(1, value_); }

 private:
  std::uint64_t value_ = 1;  // not 0, so that leading zeros count
};

}  // namespace drape::sim
