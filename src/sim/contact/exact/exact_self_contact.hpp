#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/exact/feature_patches.hpp"
#include "sim/contact/exact/intersection_contours.hpp"
#include "sim/contact/exact/pair_contacts.hpp"
#include "sim/contact/exact/pair_guard.hpp"
#include "sim/contact/exact/pair_search.hpp"
#include "sim/contact/self/memory.hpp"
#include "sim/contact/self_approach.hpp"
#include "sim/contact/solve/contact_solver.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace drape::sim::contact {

/// A contact substep of the cloth with exact self-collision.
struct ExactStep {
  const ClothModel& model;
  const CommonParameters& parameters;
  const ContactParameters& contact;
  const std::vector<Vec3>& start;                   ///< positions at its start [m]
  bool hasNoSelfIntersection = false;               ///< whether certainly nothing intersects at its start
  std::shared_ptr<const SelfContactMemory> memory;  ///< ClothState::selfContact at its start; may be null
};

/// Self-collision by pairs of features: vertices with triangles, and edges with edges (docs/theory/contact.md). The
/// input of a step are the positions at its start, and the positions and velocities at its end that a solver predicted.
/// The result are positions and velocities at its end. If the cloth does not intersect itself at the start, it does not
/// at the end, unless pins or bodies force it.
///
/// 1. PairSearch lists the pairs that come near each other. It omits pairs of one collision-free patch.
/// 2. findPairContacts chooses the contacts among them, which keep the thickness of the cloth.
/// 3. ContactSolver solves for impulses with friction: `resolve`. `auto` has already resolved most contacts in its
///    substeps.
/// 4. Cloth that intersects itself at the start moves apart (recoverFromCrossings), as the last part of `resolve`.
/// 5. After contact with bodies, PairGuard keeps pairs of different patches from passing through each other: `guard`.
///    Before, patches that are not collision-free at the end of the step are replaced by smaller ones.
class ExactSelfContact {
 public:
  /// Planes of bodies, and positions that satisfy them.
  struct BodyLimits {
    std::span<const SeparatingPlane> planes;
    std::span<const Vec3> fallback;  ///< positions outside the bodies [m]; empty: there are no bodies near
    bool planesAreComplete = true;   ///< whether the planes suffice for further displacements of the cloth
  };

  /// Whether features come into contact on the way to `ahead` [m], and how far they move relative to each other.
  [[nodiscard]] SelfApproach approach(const ExactStep& step, const std::vector<Vec3>& ahead);

  /// Finds the contacts on the way to `ahead` [m], for solvers that resolve contacts in their substeps.
  /// @param found the contacts are appended
  void findSubstepContacts(const ExactStep& step, const std::vector<Vec3>& ahead, std::vector<SubstepContact>& found);

  /// Finds the contacts that the motion to `predicted` [m] violates and that are not in the list of the substeps: in
  /// the substeps, forces moved the features elsewhere than their velocities at the start would have done.
  /// @param listed contacts of the substeps; the missed ones are appended  @returns whether there are any
  bool addMissedContacts(const ExactStep& step, const std::vector<Vec3>& predicted,
                         std::vector<SubstepContact>& listed);

  /// Corrects the predicted positions and velocities by the impulses of contacts, and recovers from crossings.
  /// @param points the active contacts are appended  @returns their number
  int resolve(const ExactStep& step, ClothState& state, std::vector<ContactPoint>& points);

  /// The number of pairs of triangles that intersect at the start of the step of the last `resolve`.
  [[nodiscard]] int intersectionsAtStart() const;

  /// Requires a call of `resolve` for the same step. Keeps features from passing through each other, and removes the
  /// velocity of vertices towards what stops them. Stores in `state` whether the cloth is now free of intersections
  /// with itself, and its collision-free patches.
  /// @returns number of pairs that could not be separated; those that intersect at the start do not count. Empty if
  /// cloth must be moved and the planes of bodies are not complete; nothing has changed then.
  std::optional<int> guard(const ExactStep& step, const BodyLimits& bodies, ClothState& state);

 private:
  void findContacts(const ExactStep& step, double margin, double separationStep, const std::vector<Vec3>& predicted,
                    std::vector<SubstepContact>& found);
  void findContactsAtEnd(const ExactStep& step, const std::vector<Vec3>& predicted);
  void solvePositions(const ExactStep& step, ClothState& state);
  [[nodiscard]] double pinSpeedOf(const ExactStep& step, std::span<const Vec3> end);
  int solveVelocities(const ExactStep& step, ClothState& state, std::vector<ContactPoint>& points);
  void recover(const ExactStep& step, ClothState& state);
  void findEntangledAt(const ExactStep& step);
  SharedFeaturePatches patchesAtStart(const ExactStep& step);
  std::optional<PairGuard::Result> keepApart(const ExactStep& step, PairGuard::Inputs inputs, bool mayMove,
                                             std::vector<Vec3>& positions, PatchHistory& history);
  const std::vector<double>& inverseMass(const ClothModel& model);

  PatchFinder patches_;
  PairSearch search_;
  PairGuard guard_;
  ContactSolver solver_;
  ModelCache<std::vector<double>> inverseMass_;
  ModelCache<std::unique_ptr<CrossingField>> crossingField_;
  std::vector<SubstepContact> contacts_;
  std::vector<Vec3> predicted_;  // positions at the end for which `contacts_` were found [m]; empty: none
  std::vector<ContactConstraint> constraints_;
  std::vector<ContactConstraint> active_;
  std::vector<ContactGoal> goals_;
  std::vector<Vec3> before_;             // positions before the guard [m]
  std::vector<Vec3> wanted_;             // positions before a round of the guard [m]
  std::vector<Vec3> fallback_;           // [m]
  std::vector<EdgeCrossing> crossings_;  // at the start
  double pinSpeed_ = 0.0;                // of the fastest pin in the step [m/s]
  std::vector<char> entangled_;          // marks the vertices of `crossings_`; empty if there are none
  Workers workers_;
};

}  // namespace drape::sim::contact
