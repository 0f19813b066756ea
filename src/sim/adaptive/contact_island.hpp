#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drape::sim::adaptive {

/// A vertex of the cloth with a contact, in a substep. Sweeps read and write the members up to `changes`, which lie in
/// one cache line.
struct alignas(64) ContactVertex {
  Vec3 velocity = Vec3::Zero();   // with the impulses so far [m/s]
  double inverseMass = 0.0;       // [1/kg]; 0 if pinned
  double changes = 0.0;           // sum of the changes of velocity since the last complete sweep began, or more [m/s]
  Vec3 position = Vec3::Zero();   // after the drift, without impulses [m]
  Vec3 afterKick = Vec3::Zero();  // velocity before the impulses [m/s]
  double mass = 0.0;              // [kg]
  Vec3 before = Vec3::Zero();     // velocity in the substep before [m/s]
  double work = 0.0;              // so far [J]
  int index = 0;                  // permuted index
};

/// A half-space for a point of the cloth, or for the difference of two points, and its impulse. Sweeps read
/// the members up to `minSpeed` of every contact that they visit, which are two cache lines.
struct alignas(64) ImpulseContact {
  Vec3 normal = Vec3::UnitY();
  Vec3 bodyVelocity = Vec3::Zero();         // in the solver's frame [m/s]
  std::array<double, 4> weights{};          // [-]
  std::array<std::uint32_t, 4> vertices{};  // indices into the vertices with contacts
  float restGap = 0.0F;                     // [m]
  std::uint8_t count = 0;                   // of its vertices
  bool isFeaturePair = false;               // of the cloth with itself
  double height = 0.0;                      // at the start of the step [m]
  double normalImpulse = 0.0;               // of the substep [N s]
  double minSpeed = 0.0;                    // lower bound of the normal velocity in the substep [m/s]
  double inverseMass = 0.0;                 // of the point [1/kg]
  Vec3 friction = Vec3::Zero();             // of the substep [N s]
  double staticFriction = 0.0;              // [-]
  double kineticFriction = 0.0;             // [-]
  Vec3 impulse = Vec3::Zero();              // so far [N s]
  std::size_t source = 0;                   // index into the contacts of the inputs
};

/// Contacts that share free vertices, and these vertices.
struct ContactIsland {
  std::span<ImpulseContact> contacts;
  std::span<const std::uint32_t> vertices;  // the free ones: indices into the vertices with contacts
  std::span<std::uint32_t> near;            // memory for as many indices as there are contacts
  bool hasFeaturePairs = false;
  bool isDense = false;       // many contacts had an impulse in the substep before
  std::size_t nearCount = 0;  // the first of `near` are contacts that may have an impulse, ascending
  double margin = 0.0;        // normal velocity above the lower bound up to which a contact is one of them [m/s]
};

/// A drift of the substeps.
struct Drift {
  double time = 0.0;      // from the start of the step to the end of the drift [s]
  double duration = 0.0;  // [s]
};

/// What solving a contact once has changed.
struct SolvedContact {
  bool hasChanged = false;  // the impulse, noticeably
  double changes = 0.0;     // upper bound of ContactVertex::changes of its vertices if the impulse has changed [m/s]
};

/// Changes the impulse of a contact in a substep so that the contact is satisfied. `minSpeed` must be set.
SolvedContact solveContact(ImpulseContact& contact, std::span<ContactVertex> vertices);

/// The lower bound of the normal velocity of a contact [m/s]. It does not depend on the impulses of the substep.
[[nodiscard]] double minSpeedOf(const ImpulseContact& contact, std::span<const ContactVertex> vertices,
                                const Drift& drift);

/// Solves the contacts of an island in a substep by projected Gauss-Seidel sweeps, starting with the impulses of the
/// substep before. Then it limits the speeds that moving bodies and pins cause.
///
/// A complete sweep lists the contacts that have an impulse, or whose normal velocity is within a margin of its lower
/// bound. In dense islands it lists all contacts. The next sweeps solve only the listed contacts, until the velocities
/// have changed so much that another contact may need an impulse. The result has the bits of complete sweeps.
/// @param vertices with contacts; `position`, `afterKick` and `velocity` are set
void solveIsland(ContactIsland& island, std::span<ContactVertex> vertices, const Drift& drift);

}  // namespace drape::sim::adaptive
