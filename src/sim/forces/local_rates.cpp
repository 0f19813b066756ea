#include "sim/forces/local_rates.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/model/local_frequency.hpp"
#include "sim/model/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace drape::sim {
namespace {

/// By the row sums of the bending matrix (fabric::halfRowSums).
double bendingFrequencyOf(const ClothModel& model) {
  double squared = 0.0;
  for (std::size_t i = 0; i < model.restPositions.size() && model.fabric && model.fabric->bends(); ++i) {
    squared = std::max(squared, model.pinned[i] ? 0.0 : 2.0 * model.fabric->bendingHalfSums[i] / model.vertexMass[i]);
  }
  return std::sqrt(squared);
}

/// The energy is the sum of 1/4 K_ij |x_i - x_j|^2 over all entries of the matrix.
double bendingTermsOf(const ClothModel& model) {
  double sum = 0.0;
  for (const fabric::VertexPair& pair : model.fabric ? model.fabric->pairs : std::vector<fabric::VertexPair>()) {
    sum += 0.5 * std::abs(pair.bending) * (model.restPositions[pair.a] - model.restPositions[pair.b]).squaredNorm();
  }
  return sum;
}

}  // namespace

LocalRates localRatesOf(const ClothModel& model) {
  LocalRates rates;
  std::vector<double> free;
  std::vector<double> freeDamping;
  for (std::size_t i = 0; i < model.restPositions.size(); ++i) {
    const auto ends = static_cast<double>(model.springEnds[i].size());
    rates.frequencySquared.push_back(model.pinned[i] ? 0.0 : unitFrequencySquared(model, i));
    rates.damping.push_back(model.pinned[i] ? 0.0 : 2.0 * ends / model.vertexMass[i]);
    if (!model.pinned[i]) {
      free.push_back(rates.frequencySquared.back());
      freeDamping.push_back(rates.damping.back());
    }
  }
  rates.median = quantileExceededBy(free, 2);
  rates.heatingRate = model.fabric && !free.empty()
                          ? std::accumulate(free.begin(), free.end(), 0.0) / static_cast<double>(free.size())
                          : rates.median;
  rates.percentile99 = quantileExceededBy(free, 100);
  rates.dampingPercentile99 = quantileExceededBy(freeDamping, 100);
  rates.bendingFrequency = bendingFrequencyOf(model);
  rates.bendingTerms = bendingTermsOf(model);
  rates.diagonal = diagonalOf(model);
  rates.mass = model.totalMass();
  rates.area = model.restArea();
  for (const Spring& spring : model.springs) {
    const bool atPin = model.pinned[spring.a] != model.pinned[spring.b];
    rates.pinnedLength += atPin ? spring.relativeStiffness * spring.restLength : 0.0;
  }
  return rates;
}

}  // namespace drape::sim
