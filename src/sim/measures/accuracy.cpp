#include "sim/measures/accuracy.hpp"

#include "sim/model/fingerprint.hpp"

#include <cstdint>

namespace drape::sim {

bool isErrorKnown(const Accuracy& accuracy) {
  constexpr double visible = 1e-4;          // [m]
  constexpr double smallShare = 1.0 / 3.0;  // of the error
  return accuracy.spread < visible || accuracy.spread < smallShare * accuracy.error;
}

void displaceForTest(const std::vector<bool>& pinned, std::span<Vec3> positions) {
  constexpr double unit = 1.0 / 9007199254740992.0;  // 2^-53
  std::uint64_t random = 1;
  const auto next = [&random] {
    random = mixHash(random, 1);
    return 2.0 * unit * static_cast<double>(random >> 11) - 1.0;
  };
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double x = next();
    const double y = next();
    const Vec3 direction(x, y, next());
    if (!pinned[v]) {
      positions[v] += testDisplacement * direction.normalized();
    }
  }
}

}  // namespace drape::sim
