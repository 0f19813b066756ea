#pragma once

#include "sim/systems/scalar_system.hpp"

#include <array>
#include <vector>

namespace drape::sim {

/// Additions to three diagonal entries of a ScalarSystem, for the stiffness of an attachment. They differ from step to
/// step, but the factor does not change. The solution u of the system becomes that of the changed system by the formula
/// of Sherman, Morrison and Woodbury:
///
///     u - Z D (I + Z_c D)^-1 u_c
///
/// D are the additions, the index c means their rows, and Z are the three columns of the inverse. Z is computed when
/// the attachment moves to another triangle or the factor changes.
class DiagonalChange {
 public:
  /// Removes the additions.
  void clear();

  /// @param changed whether the factor of the system changed since the last call
  /// @param vertices whose diagonals change; pinned ones are ignored
  /// @param additions [kg], not negative
  void set(const ScalarSystem& system, bool changed, const std::array<std::size_t, 3>& vertices, const Vec3& additions);

  /// Converts a solution of the system to one of the changed system.
  void applyTo(ScalarSystem::Columns& answer) const;

 private:
  void findColumns(const ScalarSystem& system);

  bool known_ = false;  // columns_ belong to vertices_ and the factor
  bool active_ = false;
  std::array<std::size_t, 3> vertices_{};
  std::vector<int> rows_;              // of the free vertices
  std::vector<Eigen::Index> corners_;  // their indices among the three
  Eigen::VectorXd additions_;          // D [kg]
  Eigen::MatrixXd columns_;            // Z [1/kg]
};

}  // namespace drape::sim
