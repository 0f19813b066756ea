#include "convex_reference.hpp"

#include <Eigen/Geometry>
#include <cstdint>
#include <numeric>
#include <vector>

namespace drape::intersection::testing {
namespace {

using Column = std::array<std::int64_t, 4>;
using Vec3i = Eigen::Vector3i;

Column column(const Vec3i& v, int last) {
  return {v[0], v[1], v[2], last};
}

/// Whether `target` is a combination of linearly independent columns with non-negative coefficients; false if they are
/// dependent. By fraction-free elimination.
bool isCombination(std::vector<Column> columns, const Column& target) {
  const std::size_t unknowns = columns.size();
  columns.push_back(target);
  std::size_t rank = 0;
  for (std::size_t unknown = 0; unknown < unknowns; ++unknown, ++rank) {
    std::size_t pivot = rank;
    while (pivot < 4 && columns[unknown][pivot] == 0) {
      ++pivot;
    }
    if (pivot == 4) {
      return false;
    }
    for (Column& c : columns) {
      std::swap(c[rank], c[pivot]);
    }
    const std::int64_t head = columns[unknown][rank];
    for (std::size_t row = 0; row < 4; ++row) {
      const std::int64_t factor = columns[unknown][row];
      if (row == rank || factor == 0) {
        continue;
      }
      std::int64_t divisor = 0;
      for (Column& c : columns) {
        c[row] = c[row] * head - c[rank] * factor;
        divisor = std::gcd(divisor, c[row]);
      }
      for (Column& c : columns) {
        c[row] /= divisor > 1 ? divisor : 1;
      }
    }
  }
  for (std::size_t row = 0; row < 4; ++row) {
    const std::int64_t right = columns[unknowns][row];
    if (row >= rank ? right != 0 : right * columns[row][row] < 0) {
      return false;
    }
  }
  return true;
}

/// Caratheodory: a non-negative combination of columns is one of independent columns, hence of at most four.
bool isCombinationOfSome(const std::vector<Column>& columns, const Column& target) {
  for (unsigned chosen = 1; chosen < (1U << columns.size()); ++chosen) {
    std::vector<Column> some;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if ((chosen >> i & 1U) != 0) {
        some.push_back(columns[i]);
      }
    }
    if (some.size() <= 4 && isCombination(some, target)) {
      return true;
    }
  }
  return false;
}

/// Whether the cones over a1, a2 and over b1, b2 share a direction d with d . along > 0.
bool conesShare(const Vec3i& a1, const Vec3i& a2, const Vec3i& b1, const Vec3i& b2, const Vec3i& along) {
  return isCombinationOfSome({column(a1, a1.dot(along)), column(a2, a2.dot(along)), column(-b1, 0), column(-b2, 0)},
                             {0, 0, 0, 1});
}

}  // namespace

bool meetByDifferences(const WholeTriangle& a, const WholeTriangle& b) {
  std::vector<Column> differences;
  for (const Vec3i& p : a) {
    for (const Vec3i& q : b) {
      differences.push_back(column(p - q, 1));
    }
  }
  return isCombinationOfSome(differences, {0, 0, 0, 1});
}

bool meetBeyondCornerByCones(const WholeTriangle& a, const WholeTriangle& b) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      if (conesShare(a[1] - a[0], a[2] - a[0], b[1] - b[0], b[2] - b[0], sign * Vec3i::Unit(axis))) {
        return true;
      }
    }
  }
  return false;
}

bool meetBeyondEdgeByCones(const WholeTriangle& a, const WholeTriangle& b) {
  const Vec3i& u = a[0];
  const Vec3i& v = a[1];
  const Vec3i edge = v - u;
  if (edge.isZero()) {
    return meetBeyondCornerByCones(a, b);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3i off = edge.cross(Vec3i::Unit(axis));
    if (conesShare(edge, a[2] - u, edge, b[2] - u, off) || conesShare(edge, a[2] - u, edge, b[2] - u, -off)) {
      return true;
    }
  }
  return conesShare(edge, a[2] - u, edge, b[2] - u, -edge) || conesShare(-edge, a[2] - v, -edge, b[2] - v, edge);
}

}  // namespace drape::intersection::testing
