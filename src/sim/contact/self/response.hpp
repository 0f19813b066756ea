#pragma once

#include "sim/contact/contact_report.hpp"
#include "sim/contact/self/float_lanes.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Coloured pairs: no two pairs of a colour share a vertex.
struct ColouredPairs {
  std::vector<VertexPair> pairs;  ///< by colour, in input order within a colour, and padded by a vector
  std::vector<int> begin;         ///< first pair of each colour, and one past the last

  [[nodiscard]] int count() const { return begin.empty() ? 0 : begin.back(); }
  [[nodiscard]] std::size_t colourCount() const { return begin.empty() ? 0 : begin.size() - 1; }
  /// The pairs of a colour. A whole vector can be read from each.
  [[nodiscard]] std::span<const VertexPair> colour(std::size_t c) const {
    return {pairs.data() + begin[c], pairs.data() + begin[c + 1]};
  }
};

/// Colours pairs greedily, in linear time.
/// @param vertices number of vertices  @param scratch memory for reuse  @param coloured the result
void colourPairs(int vertices, const std::vector<VertexPair>& pairs, std::vector<std::uint64_t>& scratch,
                 ColouredPairs& coloured);

/// The contacts of a step, one array per quantity. Each colour is padded to whole vectors.
struct ContactLanes {
  std::vector<std::int32_t> a, b;                      ///< vertices; the vertex count in padding
  std::vector<float> normalX, normalY, normalZ;        ///< unit vector from a to b at the start of the step
  std::vector<float> offsetX, offsetY, offsetZ;        ///< predicted offset from a to b [m]
  std::vector<float> minDistance;                      ///< T, see SelfResponse [m]
  std::vector<float> mass;                             ///< 1 / (1 / m_a + 1 / m_b) [kg]
  std::vector<float> normalImpulse;                    ///< h times the impulse along the normal so far [kg m]
  std::vector<float> frictionX, frictionY, frictionZ;  ///< h times the friction impulse on b so far [kg m]
  int count = 0;

  void resize(std::size_t capacity);
};

/// Collects the pairs that are closer than `closeMargin` times `thickness` [m], or that have passed each other since
/// the start of the step. Returns true if one of them was closer than the thickness at the start.
/// @param positions predicted positions at the end of the step [m]
/// @param inverseMasses per vertex [1/kg], and a 0 at the end
bool collectContacts(const ColouredPairs& pairs, const PositionLanes& startPositions, const PositionLanes& positions,
                     const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts);

/// Friction coefficients [-].
struct Friction {
  float staticCoefficient = 0.0F;
  float kineticCoefficient = 0.0F;
};

/// One sweep over all contacts. Returns the maximum displacement of a pair along its normal [m].
/// @param displacements of each vertex [m], interleaved with its inverse mass [1/kg]
float sweepContacts(const Friction& friction, ContactLanes& contacts, std::vector<float>& displacements);

/// Pushes pairs that were too close at the start of the step apart by a fraction of the missing distance.
/// @param share the fraction [-]  @param pushOuts like `displacements`, but without effect on velocities
void pushOutContacts(float thickness, float share, const ContactLanes& contacts,
                     const std::vector<float>& displacements, std::vector<float>& pushOuts);

/// Keeps pairs of vertices apart at the end of a step. Let d be the offset between a pair, d0 and n its length and
/// direction at the start of the step, T = min(thickness, d0), and l the component of d normal to n. A pair must
/// satisfy
///
///     n.d >= sqrt(T^2 - l^2)   where |l| < T
///
/// So the two vertices are no closer than T and have not passed each other. Otherwise an impulse along n changes both
/// velocities according to their masses, and both positions by h times these changes, as if the impulse were part of
/// the step. Positions and velocities stay consistent, and the relative motion is only slowed down. Friction opposes
/// the relative motion normal to n over the step: it stops the motion if at most the static coefficient times the
/// normal impulse suffices for that. Otherwise it is the kinetic coefficient times the normal impulse.
///
/// Gauss-Seidel sweeps, colour by colour, find the impulses, until no pair moves by more than `tolerance` times the
/// thickness, at most `maxSweeps` times. Normal impulses are never negative. Pairs that were too close at the start of
/// the step are then pushed apart by the fraction `pushOut` of the missing distance, in positions only, without
/// velocity.
///
/// Pinned vertices have inverse mass 0 and do not move. Linear momentum is conserved to the rounding of float, 1e-7 of
/// the impulses. Angular momentum is too, without friction and push-out, if the step was x1 = x0 + h v1, as in all
/// backward-Euler steps. A friction impulse changes it by at most its size times the thickness.
class SelfResponse {
 public:
  static constexpr int maxSweeps = 8;
  static constexpr float tolerance = 0.01F;
  static constexpr float pushOut = 0.2F;

  struct Inputs {
    double timeStep = 0.0;   ///< h [s]
    double thickness = 0.0;  ///< [m]
    Friction friction = {};
    float pushOut = SelfResponse::pushOut;  ///< fraction of the missing distance [-]
  };

  /// Corrects the positions and velocities of `state`.
  /// @param pairs that may be too close  @param startPositions, positions at the start of the step, and predicted [m]
  /// @param points the active contacts are appended  @returns their number
  int resolve(const ClothModel& model, const Inputs& inputs, const ColouredPairs& pairs,
              const PositionLanes& startPositions, const PositionLanes& positions, ClothState& state,
              std::vector<ContactPoint>& points);

 private:
  [[nodiscard]] int report(const Inputs& inputs, const ClothState& state, std::vector<ContactPoint>& points) const;

  struct Buffers {
    std::vector<float> inverseMasses;  // per vertex [1/kg], then a 0 and padding
    std::vector<float> displacements;  // per vertex: its displacement [m], zero between steps, and its inverse mass
    std::vector<float> pushOuts;       // the same
  };

  ModelCache<Buffers> buffers_;
  ContactLanes contacts_;
};

}  // namespace drape::sim::contact
