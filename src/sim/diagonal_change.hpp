#pragma once

#include "sim/scalar_system.hpp"

#include <array>
#include <vector>

namespace drape {

/// A ScalarSystem with something added to three of its diagonal entries, differently at every step: what the hand's
/// stiffness adds where it holds. The factor stays as it is; the three columns Z of the inverse, worked out when the
/// hand takes another triangle or the factor changes, turn the answer u of the system into that of the changed one
/// (Sherman, Morrison and Woodbury):
///
///     u - Z D (I + Z_c D)^-1 u_c
///
/// with D the additions, and the index c for their rows.
class DiagonalChange {
 public:
  /// Nothing is added.
  void clear();

  /// @param changed whether the factor of the system did since the last call
  /// @param vertices to whose diagonal is added; pinned ones do not count
  /// @param additions [kg], not negative
  void set(const ScalarSystem& system, bool changed, const std::array<std::size_t, 3>& vertices, const Vec3& additions);

  /// Makes the system's answer the changed system's.
  void applyTo(ScalarSystem::Columns& answer) const;

 private:
  void findColumns(const ScalarSystem& system);

  bool known_ = false;  // columns_ belong to vertices_ and the factor
  bool active_ = false;
  std::array<std::size_t, 3> vertices_{};
  std::vector<int> rows_;             // of the vertices that are free
  std::vector<Eigen::Index> places_;  // where they stand among the three
  Eigen::VectorXd additions_;         // D [kg]
  Eigen::MatrixXd columns_;           // Z [1/kg]
};

}  // namespace drape
