#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"
#include "sim/contact/exact/pair_search.hpp"
#include "sim/contact/exact/pair_separation.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace drape::sim::contact {

/// The last stage of exact self-collision: keeps the features of a cloth from passing through each other in a step. It
/// changes only the positions at the end of the step.
///
/// PairSearch lists the pairs that come near each other, and separationInStep decides whether a pair is separated. All
/// vertices move on straight lines from start to end.
///
/// If a pair is not separated, its vertices are moved:
/// 1. Sweeps move the features of each such pair apart, weighted by their masses.
/// 2. If pairs remain, each gets two parallel planes between its fallback positions, one for each feature. Every vertex
///    is projected onto its planes, or moves back towards its fallback position (SeparatingPlaneFilter). Other pairs
///    that this violates get planes too. If the fallback positions satisfy all planes and no pin violates one, all
///    pairs are separated.
/// 3. If pairs remain, because pins or bodies move far, the motion is divided into parts, and each part is guarded.
/// 4. If pairs remain in a part, their vertices move back to their fallback positions or to their start, as do those of
///    other pairs that this violates. Only pairs that a pin moves into each other remain.
class PairGuard {
 public:
  struct Inputs {
    const ClothModel& model;
    std::span<const double> inverseMass;          ///< 0: the vertex does not move [1/kg]
    std::span<const Vec3> start;                  ///< positions at the start of the step [m]
    std::span<const Vec3> fallback;               ///< positions to which vertices move back [m]
    std::span<const SeparatingPlane> bodyPlanes;  ///< planes of bodies, which the vertices must satisfy too
    std::span<const char> entangled;              ///< vertices of triangles that intersect at the start; may be empty
    SharedFeaturePatches patches;                 ///< pairs of one patch are not checked; null: all pairs are
    double thickness = 0.0;                       ///< of the cloth [m]
    double reach = 0.0;                           ///< of a new search [m]
    bool obstaclesMove = false;                   ///< pins, or bodies near the cloth, move in the step
    int threads = 1;
  };

  /// Numbers of pairs, and of planes. Pairs that intersect at the start do not count.
  struct Result {
    int crossings = 0;     ///< pairs that are not separated
    int touching = 0;      ///< pairs without a separating plane at the start: not guarded, may intersect at the end
    int insideBodies = 0;  ///< planes of bodies that are violated at the end
  };

  /// Begins a step, in which `apply` can be called several times.
  void begin() { searches_ = 0; }

  /// The result of `apply` if it would not move a vertex; empty otherwise.
  [[nodiscard]] std::optional<Result> resultWithoutMotion(const Inputs& inputs, PairSearch& search, Workers& workers,
                                                          std::span<const Vec3> positions);

  /// Changes `positions`, those at the end of the step [m]. After many searches in a step it only moves cloth back.
  Result apply(const Inputs& inputs, PairSearch& search, Workers& workers, std::span<Vec3> positions);

 private:
  struct Guarded {
    PairVertices vertices;
    PairInStep inStep;
    std::uint64_t key = 0;  // identifies the pair
  };

  /// How far and how long sweeps may move vertices.
  struct Limits {
    int sweepRounds = 0;
    double correction = 0.0;  ///< of a vertex [m]
  };

  void sweep(const Inputs& inputs, const Limits& limits, PairSearch& search, Workers& workers,
             std::span<Vec3> positions);
  Result applyAtOnce(const Inputs& inputs, int sweepRounds, PairSearch& search, Workers& workers,
                     std::span<Vec3> positions);
  Result applyInParts(const Inputs& inputs, int parts, PairSearch& search, Workers& workers, std::span<Vec3> positions);
  void findCrossing(const Inputs& inputs, const PairSearch& search, Workers& workers, std::span<const Vec3> positions);
  void guardFound();
  [[nodiscard]] bool mayContinue() const;
  bool find(const Inputs& inputs, PairSearch& search, Workers& workers, std::span<const Vec3> positions);
  bool moveBackFound(const Inputs& inputs, std::span<const Vec3> target, std::span<Vec3> positions) const;
  Result stop(const Inputs& inputs, PairSearch& search, Workers& workers, std::span<Vec3> positions);
  void moveApart(const Inputs& inputs, std::span<Vec3> positions) const;
  void addPlanes(const Inputs& inputs, std::size_t first);

  int searches_ = 0;            // in this step
  std::vector<Guarded> found_;  // pairs that are not separated now
  int touching_ = 0;
  std::vector<Guarded> guarded_;            // all pairs that were found in this step
  std::unordered_set<std::uint64_t> keys_;  // of these; never iterated over
  std::vector<SeparatingPlane> planes_;
  std::vector<Vec3> unswept_;  // positions before sweeps [m]
  std::vector<Vec3> wanted_;   // positions before planes [m]
  std::vector<double> bounds_;
  std::vector<Vec3> predicted_;                 // positions before the guard [m]
  std::vector<Vec3> partStart_, partFallback_;  // of a part of the motion [m]
  std::vector<SeparatingPlane> partPlanes_;     // of the bodies, in a part of the motion
  SeparatingPlaneFilter filter_;
};

}  // namespace drape::sim::contact
