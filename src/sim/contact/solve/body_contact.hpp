#pragma once

#include "sim/contact/broad_phase/reachable_bodies.hpp"
#include "sim/contact/constraints/cloth_frames.hpp"
#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/constraints/near_bodies.hpp"
#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/recovery/body_overlaps.hpp"
#include "sim/contact/separating_planes/separating_planes.hpp"
#include "sim/contact/solve/contact_response.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Contact of a cloth with bodies in a contact substep (docs/theory/contact.md). Input are the positions at its start,
/// the positions and velocities at its end that a solver predicted without contact, and the motion of the bodies in it.
/// Result are positions without intersections and velocities without approach.
///
/// First the broad phase finds the bodies that the cloth could reach (`ReachableBodies`). Passes work in the frame of
/// each body, in which a rigid body stands still. A pass has these stages:
///
/// 1. Transform the cloth into the frames of the bodies, and bound the displacement of each vertex (`ClothFrames`).
/// 2. Find the cloth that is inside bodies, and its exits (`BodyOverlaps`).
/// 3. Find contacts of vertices (`findVertexContacts`), and solve for impulses with friction (`ContactResponse`). On
///    meshes, find contacts of edges and faces at the solved positions (`findSharpFeatureContacts`), and solve again.
/// 4. Find planes that separate each triangle of the cloth from every part of the bodies that it could reach
///    (`SeparatingPlanes::find`).
/// 5. Project the vertices onto the permitted side of the planes of their triangles, so that nothing intersects
///    (`SeparatingPlanes::apply`).
///
/// If a pass moved the cloth far, the constraints no longer fit the bodies (`needsAnotherPass`). Then another pass
/// starts from the result, at most four in all. The velocities are corrected after the last pass.
class BodyContact {
 public:
  /// Corrects positions and velocities of `state`, which a solver predicted from `start`.
  /// @param bodies their motion in the contact substep  @param start positions at its start [m]
  /// @param points the active contacts are appended
  void resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
               const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
               ContactReport& report, std::vector<ContactPoint>& points);

  /// Searches planes again after the guard of self-collision has changed the positions that `resolve` found, and moves
  /// vertices out of bodies.
  /// @param outside positions outside all bodies at the end of the step [m]
  /// @return whether positions changed
  bool keepOut(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
               const std::vector<BodyStep>& bodies, const std::vector<Vec3>& outside, std::vector<Vec3>& positions);

  /// Finds the contacts that can become active in a step, for solvers that resolve contacts in their substeps. Vertices
  /// inside bodies get none, since they must leave.
  /// @param start positions at the start of the step [m]  @param ahead the same, extrapolated by the velocities [m]
  /// @param found the contacts are appended
  void findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                           const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                           const std::vector<Vec3>& start, const std::vector<Vec3>& ahead,
                           std::vector<SubstepContact>& found);

  /// Reports contacts of vertices that acted in the substeps, unless `resolve` reported these vertices.
  void reportSubstepContacts(const std::vector<SubstepContact>& contacts, const ClothState& state,
                             ContactReport& report, std::vector<ContactPoint>& points) const;

  /// The separating planes of the last pass of `resolve`, or of `keepOut`. They suffice for the positions that these
  /// found.
  [[nodiscard]] std::span<const SeparatingPlane> planes() const { return planes_.all(); }
  /// Completes the planes, for further displacements of the cloth. See SeparatingPlanes.
  /// @param start positions at the start of the contact substep [m]
  void completePlanes(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                      const std::vector<Vec3>& start);
  /// Moves positions at the start of the step [m] along with the bodies whose planes limit the cloth in `resolve`. If
  /// these have the same rigid motion, all positions move with it, so that they stay outside and apart from each other.
  /// Otherwise, only the vertices that have planes move.
  /// @return whether all move along
  bool carryAlong(std::vector<Vec3>& positions) const;

  /// Whether cloth that moves from one box into another could come near any of the bodies.
  [[nodiscard]] bool couldReachAnyBody(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                       const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end);

  /// Whether cloth that moves from `start` to `end` comes so near to a body that the step needs contact substeps.
  /// The result depends on these arguments only, not on earlier calls.
  /// @param spread possible distance of the final positions from `end` [m]
  [[nodiscard]] bool isNearAnyBody(const ClothModel& model, const ContactParameters& contact,
                                   const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                   const std::vector<Vec3>& end, double spread);

 private:
  const PreparedCloth& prepared(const ClothModel& model);
  bool addReachableBodies(const ClothStep& step, const std::vector<BodyStep>& bodies,
                          const std::vector<Vec3>& positions, const Eigen::AlignedBox3d& ends);
  void removeApproachToPlanes(const ClothStep& step, ClothState& state) const;
  void runPasses(const ClothStep& step, ContactReport& report, std::vector<Vec3>& positions);
  bool runPass(const ContactPass& pass, ContactReport& report, std::vector<Vec3>& positions);
  bool findAndSolveContacts(const ContactPass& pass, std::vector<Vec3>& positions);

  ModelCache<PreparedCloth> prepared_;
  std::uint64_t models_ = 0;  // number of models so far
  ReachableBodies reachable_;
  NearBodies bodies_;
  ClothFrames frames_;
  BodyOverlaps overlaps_;
  Candidates candidates_;  // of the last pass; its planes are in `planes_`
  ContactResponse response_;
  SeparatingPlanes planes_;
  std::vector<Vec3> predicted_;       // positions at the end of the step, without contact [m]
  bool lastPassStartsAtEnd_ = false;  // see ContactPass
  Workers workers_;
};

}  // namespace drape::sim::contact
