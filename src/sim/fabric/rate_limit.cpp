#include "sim/fabric/rate_limit.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace drape::sim::fabric {
namespace {

/// The share of the limit that a single triangle may take [-], since several triangles meet at a vertex.
constexpr double shareOfTriangle = 0.5;

/// The smallest area of a vertex in the ratio of stiffness to area, as a fraction of the mean [-].
constexpr double minAreaFraction = 1e-3;

/// The value at a fraction of the sorted values. Reorders them.
double quantile(std::vector<double>& values, double fraction) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

RateLimit::RateLimit(std::vector<double> rates, double maxRatio) {
  if (!rates.empty()) {
    limit_ = shareOfTriangle * std::max(maxRatio * quantile(rates, 0.5), quantile(rates, 0.99));
  }
}

std::vector<double> boundedAreas(std::span<const double> vertexAreas) {
  const double mean = std::accumulate(vertexAreas.begin(), vertexAreas.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, vertexAreas.size()));
  std::vector<double> areas;
  areas.reserve(vertexAreas.size());
  std::ranges::transform(vertexAreas, std::back_inserter(areas),
                         [&](double area) { return std::max(area, minAreaFraction * mean); });
  return areas;
}

}  // namespace drape::sim::fabric
