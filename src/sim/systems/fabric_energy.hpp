#pragma once

#include "sim/fabric/fabric.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/workers.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// The elastic energy of a fabric after a displacement from the start of a step, with force and second derivative.
///
/// The lengths of the sides are computed from their change since the start, not from positions, as in
/// IncrementalPotential.
class FabricEnergy {
 public:
  /// The arguments must outlive the step. @param start positions [m], one a vertex
  void prepare(const ClothModel& model, std::span<const Vec3> start, int threads, Workers& workers);

  /// Computes energy and forces at `start + displacement`. @param displacement [m], one a vertex
  void evaluate(std::span<const Vec3> displacement);

  /// The energy [J].
  [[nodiscard]] double energy() const;
  /// The force on a vertex [N], and the sum of the sizes of its terms, for rounding errors [N].
  [[nodiscard]] Vec3 forceOn(std::size_t vertex) const { return forces_[vertex]; }
  [[nodiscard]] double forceSizeOn(std::size_t vertex) const { return sizes_[vertex]; }

  /// Adds the second derivative times `factor` to the blocks of the vertices and of the fabric's pairs. A pair's block
  /// has the rows of its second vertex and the columns of its first [N/m times factor].
  void addDerivative(ForceDerivative variant, double factor, std::span<Mat3> diagonal, std::span<Mat3> pairs);

 private:
  void evaluateTriangle(std::size_t triangle, std::span<const Vec3> displacement);
  void gatherVertex(std::size_t vertex, std::span<const Vec3> displacement);

  const ClothModel* model_ = nullptr;
  Workers* workers_ = nullptr;
  int threads_ = 1;
  std::span<const Vec3> start_;
  std::vector<fabric::Corners> startSides_;  // of each triangle, one a column [m]
  std::vector<Vec3> startExcess_;            // (|x_e|^2 - |X_e|^2) / 2 at the start [m^2]
  std::vector<fabric::Corners> sides_;       // displaced [m]
  std::vector<Vec3> tensions_;               // [N/m]
  std::vector<double> energies_;             // of each triangle [J]
  std::vector<Vec3> forces_;                 // [N]
  std::vector<double> sizes_;                // [N]
  std::vector<double> bendingEnergies_;      // of each vertex [J]
  std::vector<Vec3> displaced_;              // positions [m]
  std::vector<fabric::Mat9> derivatives_;    // of each triangle, of the last addDerivative [N/m]
};

}  // namespace drape::sim
