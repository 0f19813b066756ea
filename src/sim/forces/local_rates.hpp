#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim {

/// The local rates of a cloth's vertices, for springs of 1 N/m with a damping of 1 N s/m, and sums over the cloth.
///
/// A fabric has its own moduli. Its frequencies are omega_i^2 themselves, so that k = 1 N/m gives them (actingMaterial
/// in stability.hpp). It has no damping, so its damping rates do not count. pinnedLength is that of its edges.
struct LocalRates {
  std::vector<double> frequencySquared;  ///< omega_i^2 / k [1/kg], one a vertex; 0 where pinned
  std::vector<double> damping;           ///< lambda_i / C_d [1/kg], one a vertex; 0 where pinned
  double median = 0.0;                   ///< of `frequencySquared` over the free vertices [1/kg]
  /// Of `frequencySquared`, for the heating by rounding [1/kg]: the mean over the free vertices of a fabric, the median
  /// for springs. The mean counts the small triangles of a fabric, which gain the most energy.
  double heatingRate = 0.0;
  double percentile99 = 0.0;         ///< of `frequencySquared`: one free vertex in 100 is faster [1/kg]
  double dampingPercentile99 = 0.0;  ///< of `damping` [1/kg]
  double bendingFrequency = 0.0;     ///< an upper bound of the angular frequencies of a fabric's bending [1/s]
  /// The sum of the sizes of the terms that add up to the bending energy of a fabric [J]. They cancel at rest, but for
  /// their rounding errors.
  double bendingTerms = 0.0;
  double diagonal = 0.0;      ///< of the rest shape [m]
  double mass = 0.0;          ///< of the whole cloth [kg]
  double area = 0.0;          ///< of the whole rest shape [m^2]
  double pinnedLength = 0.0;  ///< sum over springs with one end pinned of length times relative stiffness [m]
};

[[nodiscard]] LocalRates localRatesOf(const ClothModel& model);

}  // namespace drape::sim
