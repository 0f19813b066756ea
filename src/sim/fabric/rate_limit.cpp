#include "sim/fabric/rate_limit.hpp"

#include "sim/model/quantile.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>

namespace drape::sim::fabric {
namespace {

/// The share of the limit that a single triangle may take [-].
constexpr double shareOfTriangle = 0.5;

/// The smallest area of a vertex in the ratio of stiffness to area, as a fraction of the mean [-].
constexpr double minAreaFraction = 1e-3;

}  // namespace

RateLimit::RateLimit(std::span<const double> stiffness, std::span<const double> vertexAreas, double maxRatio) {
  const double mean = std::accumulate(vertexAreas.begin(), vertexAreas.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, vertexAreas.size()));
  std::ranges::transform(vertexAreas, std::back_inserter(areas_),
                         [&](double area) { return std::max(area, minAreaFraction * mean); });
  std::vector<double> rates;
  std::ranges::transform(stiffness, areas_, std::back_inserter(rates), std::divides<>());
  limit_ = shareOfTriangle * std::max(maxRatio * quantileExceededBy(rates, 2), quantileExceededBy(rates, 100));
}

}  // namespace drape::sim::fabric
