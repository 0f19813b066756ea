#include "io/garments/puff.hpp"

#include <algorithm>

namespace drape::io {

// Solves z - reach^2 laplace(z) = height, with z = 0 at seams.
std::vector<double> puffed(const FlatMesh& mesh, const std::vector<bool>& sewn, double edgeLength, double height) {
  constexpr double puffReach = 0.1;  // decay length of the distance near a seam [m]
  const double coupling = 4.0 * puffReach * puffReach / (edgeLength * edgeLength);
  constexpr int passes = 400;
  std::vector<double> distance(mesh.points.size(), 0.0);
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<double> sum(distance.size(), 0.0);
    std::vector<int> count(distance.size(), 0);
    for (const Triangle& triangle : mesh.triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const int self = triangle[corner];
        for (const std::size_t step : {1U, 2U}) {
          sum[self] += distance[triangle[(corner + step) % 3]];
          ++count[self];
        }
      }
    }
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const bool isSewn = i < sewn.size() && sewn[i];
      distance[i] = isSewn ? 0.0 : (height + coupling * sum[i] / std::max(1, count[i])) / (1.0 + coupling);
    }
  }
  return distance;
}

}  // namespace drape::io
