#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/self/float_lanes.hpp"
#include "sim/model_cache.hpp"

#include <vector>

namespace drape {

/// Pairs in colours, such that no two of one colour share a vertex: colour c holds pairs begin[c] to begin[c + 1] - 1,
/// in the order in which they came. There is room for a vector at the end.
struct ColouredPairs {
  std::vector<VertexPair> pairs;
  std::vector<int> begin;

  [[nodiscard]] int count() const { return begin.empty() ? 0 : begin.back(); }
};

/// Colours pairs greedily, in linear time. `scratch` is memory that is used again.
void colourPairs(int vertices, const std::vector<VertexPair>& pairs, std::vector<std::uint64_t>& scratch,
                 ColouredPairs& coloured);

/// What a step's response works on, one entry a contact, the contacts of a colour filled up to whole vectors.
struct ContactLanes {
  std::vector<std::int32_t> a, b;                      ///< vertices; one past the last in what fills up
  std::vector<float> normalX, normalY, normalZ;        ///< direction from a to b when the step began
  std::vector<float> offsetX, offsetY, offsetZ;        ///< offset from a to b as the solver left them [m]
  std::vector<float> minDistance;                      ///< T [m]
  std::vector<float> mass;                             ///< 1 / (1 / m_a + 1 / m_b) [kg]
  std::vector<float> normalImpulse;                    ///< h times the impulse along n so far [kg m]
  std::vector<float> frictionX, frictionY, frictionZ;  ///< h times the impulse of friction on b so far [kg m]
  std::vector<int> begin;                              ///< of each colour
  int count = 0;

  void resize(std::size_t capacity);
};

/// Takes in those pairs that are nearer than `closeMargin` times `thickness` [m], or that are on other sides of each
/// other than when the step began. Returns true when one of them was nearer than the thickness then.
/// @param inverseMasses [1/kg]; one more than there are vertices, which is 0
bool collectContacts(const ColouredPairs& pairs, const PositionLanes& startPositions, const PositionLanes& positions,
                     const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts);

/// What friction there is [-].
struct Friction {
  float staticCoefficient = 0.0F;
  float kineticCoefficient = 0.0F;
};

/// One sweep over all contacts. Returns the most [m] by which a pair was moved along its normal.
/// @param moves by how much each vertex is moved [m], and its inverse mass [1/kg], side by side
float sweepContacts(const Friction& friction, ContactLanes& contacts, std::vector<float>& displacements);

/// Moves what was nearer than the thickness when the step began apart by a share of what is missing.
/// @param pushes as moves, but of positions alone
void pushOutContacts(float thickness, float share, const ContactLanes& contacts,
                     const std::vector<float>& displacements, std::vector<float>& pushOuts);

/// Keeps pairs of vertices apart at the end of a step. With d the offset between a pair, d0 and n its length and
/// direction when the step began, T = min(thickness, d0) and l the part of d across n, a pair must end with
///
///     n.d >= sqrt(T^2 - l^2)   where |l| < T
///
/// that is, no nearer than T and not on the other side. Where it does not, an impulse along n changes both velocities
/// by mass, and both positions by h times that, as if the impulse had stood in the step: positions and velocities go on
/// agreeing, and what was solved implicitly is only ever slowed down. Friction opposes the pair's motion across n over
/// the step: all of it up to `staticFriction` times the normal impulse, else with `kineticFriction` times that.
///
/// The impulses are found by Gauss-Seidel, colour by colour, until no pair is moved by more than `tolerance` of the
/// thickness, at most `mostSweeps` times. They never pull. What was nearer than the thickness when the step began is
/// then moved apart by `pushOut` of what is missing, in positions alone, which leaves no velocity behind.
///
/// Pinned vertices have no inverse mass and stay. Momentum is kept to the rounding of float, 1e-7 of the impulses:
/// linear momentum always, angular momentum without friction and push-out where the step was x1 = x0 + h v1, as in all
/// backward-Euler steps. An impulse of friction turns it by at most its size times the thickness.
class SelfResponse {
 public:
  static constexpr int maxSweeps = 8;
  static constexpr float tolerance = 0.01F;
  static constexpr float pushOut = 0.2F;

  struct Inputs {
    double timeStep = 0.0;   ///< h [s]
    double thickness = 0.0;  ///< [m]
    Friction friction = {};
    float pushOut = SelfResponse::pushOut;  ///< the share of what is missing [-]
  };

  /// @param pairs that may be too near  @param before, places at the start of the step, and as the solver left them [m]
  /// @param points what is in contact is appended  @returns how many pairs
  int resolve(const ClothModel& model, const Inputs& inputs, const ColouredPairs& pairs,
              const PositionLanes& startPositions, const PositionLanes& positions, ClothState& state,
              std::vector<ContactPoint>& points);

 private:
  [[nodiscard]] int report(const Inputs& inputs, const ClothState& state, std::vector<ContactPoint>& points) const;

  /// Four numbers a vertex: how far it is moved, zero between steps, and its inverse mass.
  struct Buffers {
    std::vector<float> inverseMasses;  // [1/kg]; one more than there are vertices, which is 0, and room for a vector
    std::vector<float> displacements;
    std::vector<float> pushOuts;
  };

  ModelCache<Buffers> buffers_;
  ContactLanes contacts_;
};

}  // namespace drape
