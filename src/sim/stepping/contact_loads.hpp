#pragma once

#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// How hard contacts press on each vertex of a cloth in a step, from the impulses along the vertex's normal:
///
///     J_i = sum over the contacts of the substeps of w_i n_i . j  +  m_i n_i . (v_i - v*_i)
///
/// with the impulse j of a contact and its weight w_i at the vertex, and the velocities v* before and v after contact
/// at the end of a contact substep. Impulses onto the front and onto the back are summed apart, so that cloth between
/// two layers that press on it has a load.
class ContactLoads {
 public:
  /// Begins a step of this cloth, without any impulse.
  void begin(const ClothModel& model);
  /// Adds the impulses of contacts that a solver applied. @param positions one a vertex [m]
  void add(const ClothModel& model, std::span<const SubstepContact> contacts, std::span<const Vec3> positions);
  /// Adds what contact changed at the end of a contact substep.
  void addCorrection(const ClothModel& model, const ClothState& before, const ClothState& after);

  /// The larger one of the loads onto the front and onto the back of each vertex over the step [N s]; 0 for a pinned
  /// vertex. Empty before the first step.
  [[nodiscard]] std::vector<double> impulses() const;
  [[nodiscard]] bool known() const { return !sides_.empty(); }

 private:
  /// Impulses towards the back and towards the front [N s].
  struct Sides {
    double fromFront = 0.0;
    double fromBack = 0.0;
  };

  void add(const ClothModel& model, std::span<const Vec3> positions, int vertex, const Vec3& impulse);

  std::vector<Sides> sides_;
};

}  // namespace drape::sim
