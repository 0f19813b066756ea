#pragma once

#include "sim/adaptive/contact_island.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/ragged_rows.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/simd/step_share.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace drape::sim::adaptive {

/// The impulses of contacts in the substeps of a step.
///
/// After each kick, and the drift that follows it, a point that would enter the half-space of a contact gets the normal
/// velocity with which it ends on the surface, and loses tangential velocity by friction. Positions are corrected by
/// the change of velocity times the drift, as if the impulse had acted before the drift. A point that rests on the
/// surface only loses its approach velocity: a correction of its height would turn rounding into velocity.
///
/// A contact of one vertex that has no other contact is solved exactly. All others form islands, which share no free
/// vertex with each other. Projected Gauss-Seidel sweeps solve the contacts of an island together, until they have
/// converged. They start with the impulses of the substep before, so that few sweeps suffice. An island of slow cloth
/// in contact with itself gets more sweeps, so that it comes to rest.
template <typename T>
class ContactImpulses {
 public:
  /// Prepares for a step. Contacts of pinned vertices do nothing.
  void prepare(const StepInputs& inputs, const simd::SlicedCloth<T>& cloth);

  [[nodiscard]] bool any() const { return !vertices_.empty(); }
  [[nodiscard]] bool anyCoupled() const { return !coupled_.empty(); }

  /// Stores the velocities at the start of the step, for the vertices of one thread.
  void start(const simd::SlicedCloth<T>& cloth, const simd::StepShare& share);

  /// The first of three stages after a kick and a drift: solves the contacts that have an exact solution. All threads
  /// wait for each other before each stage.
  /// @param time from the start of the step to the end of the drift [s]  @param drift time of the drift [s]
  void applySingle(simd::SlicedCloth<T>& cloth, double time, double drift, const simd::StepShare& share);
  /// The second stage: solves the islands. An island belongs to the thread of its first vertex. A thread that has
  /// solved its own islands takes those that others have not begun. Which thread solves an island does not change the
  /// result.
  void applyCoupled(simd::SlicedCloth<T>& cloth, double time, double drift, const simd::StepShare& share);
  /// The third stage: adds the work of the impulses.
  void addWork(const simd::StepShare& share);

  /// Work of all impulses so far on the cloth [J]: an impulse times the mean of the velocities in the substeps before
  /// and after it, which is the energy that it adds to a Verlet scheme.
  [[nodiscard]] double work() const;

  /// Writes the impulses into the contacts.
  void store(std::vector<SubstepContact>& contacts) const;

 private:
  /// Islands from `first` to before `last`.
  struct IslandRange {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void addContact(const SubstepContact& from, std::size_t source, const Vec3& frameVelocity,
                  const simd::SlicedCloth<T>& cloth);
  void separateCoupled();
  [[nodiscard]] std::size_t freeVertexOf(const ImpulseContact& contact) const;
  template <typename Visit>
  void forEachFreeVertex(const ImpulseContact& contact, Visit&& visit) const {
    for (std::size_t c = 0; c < contact.count; ++c) {
      if (vertices_[contact.vertices[c]].inverseMass > 0.0) {
        visit(contact.vertices[c]);
      }
    }
  }
  void findIslands();
  void listIslands(const RaggedRows<std::uint32_t>& contacts, const RaggedRows<std::uint32_t>& vertices);
  void applyIsland(ContactIsland& island, const Drift& drift, simd::SlicedCloth<T>& cloth);
  static void write(const ContactVertex& vertex, double drift, simd::SlicedCloth<T>& cloth);
  [[nodiscard]] std::span<ContactVertex> verticesOf(const simd::StepShare& share);
  [[nodiscard]] IslandRange islandsOf(const simd::StepShare& share) const;
  bool take(std::size_t island);

  std::vector<ContactVertex> vertices_;  // by permuted index
  std::vector<ImpulseContact> single_;   // of one vertex that has no other contact, by permuted index of the vertex
  std::vector<ImpulseContact> coupled_;  // by island
  std::vector<ImpulseContact> sorted_;   // scratch
  std::vector<std::uint32_t> coupledVertices_;  // indices into vertices_, by island
  std::vector<std::uint32_t> near_;             // memory for the islands, as long as coupled_
  std::vector<ContactIsland> islands_;          // by first vertex
  std::vector<unsigned char> taken_;            // of each island: 1 if a thread has begun it in this substep
  std::vector<int> contactCount_;               // of each vertex
  std::vector<std::size_t> slots_;              // by permuted index: index into vertices_
};

}  // namespace drape::sim::adaptive
