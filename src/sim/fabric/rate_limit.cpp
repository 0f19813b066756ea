#include "sim/fabric/rate_limit.hpp"

#include "sim/model/quantile.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace drape::sim::fabric {
namespace {

/// The share of the limit that a single triangle may take [-].
constexpr double shareOfTriangle = 0.5;

/// The smallest area of a vertex in the ratio of stiffness to area, as a fraction of the mean [-].
constexpr double minAreaFraction = 1e-3;

/// The limit of a triangle in a cloth whose vertices have these rates [N/m^3].
double limitOf(std::vector<double>& rates, double maxRatio) {
  return shareOfTriangle * std::max(maxRatio * quantileExceededBy(rates, 2), quantileExceededBy(rates, 100));
}

}  // namespace

RateLimit::RateLimit(std::span<const double> stiffness, std::span<const double> vertexAreas, double maxRatio,
                     std::span<const int> clothOf)
    : clothOf_(clothOf.begin(), clothOf.end()) {
  const double mean = std::accumulate(vertexAreas.begin(), vertexAreas.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, vertexAreas.size()));
  std::ranges::transform(vertexAreas, std::back_inserter(areas_),
                         [&](double area) { return std::max(area, minAreaFraction * mean); });
  const int cloths = clothOf_.empty() ? 1 : 1 + *std::ranges::max_element(clothOf_);
  std::vector<std::vector<double>> rates(static_cast<std::size_t>(cloths));
  for (std::size_t v = 0; v < stiffness.size(); ++v) {
    rates[clothOf_.empty() ? 0 : clothOf_[v]].push_back(stiffness[v] / areas_[v]);
  }
  std::ranges::transform(rates, std::back_inserter(limits_),
                         [&](std::vector<double>& own) { return limitOf(own, maxRatio); });
}

}  // namespace drape::sim::fabric
