#pragma once

#include "sim/vector.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace drape {

/// A hash of numbers, to notice that any of them changed: the FNV-1a hash (Fowler, Noll, Vo), 64 bits at a time.
class Fingerprint {
 public:
  void add(std::uint64_t bits) { value_ = (value_ ^ bits) * 0x100000001b3ULL; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& value) {
    for (int c = 0; c < 3; ++c) {
      add(value[c]);
    }
  }
  /// Never 0, which means that there is none.
  [[nodiscard]] std::uint64_t value() const { return std::max<std::uint64_t>(1, value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace drape
