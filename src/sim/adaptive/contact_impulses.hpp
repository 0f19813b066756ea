#pragma once

#include "sim/forces/step_inputs.hpp"
#include "sim/model/ragged_rows.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/simd/step_share.hpp"

#include <array>
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
  /// A vertex with a contact.
  struct Vertex {
    int index = 0;                  // permuted index
    double mass = 0.0;              // [kg]
    double inverseMass = 0.0;       // [1/kg]; 0 if pinned
    Vec3 before = Vec3::Zero();     // velocity in the substep before [m/s]
    Vec3 afterKick = Vec3::Zero();  // velocity before the impulses [m/s]
    Vec3 velocity = Vec3::Zero();   // with the impulses so far [m/s]
    double work = 0.0;              // so far [J]
  };
  /// The sweeps read the members up to `minSpeed` of every contact, which are two cache lines.
  struct alignas(64) Contact {
    Vec3 normal = Vec3::UnitY();
    Vec3 bodyVelocity = Vec3::Zero();         // in the solver's frame [m/s]
    std::array<double, 4> weights{};          // [-]
    std::array<std::uint32_t, 4> vertices{};  // indices into vertices_
    std::uint32_t count = 0;                  // of its vertices
    bool isFeaturePair = false;               // of the cloth with itself
    double inverseMass = 0.0;                 // of the point [1/kg]
    double normalImpulse = 0.0;               // of the substep [N s]
    double minSpeed = 0.0;                    // lower bound of the normal velocity in the substep [m/s]
    Vec3 friction = Vec3::Zero();             // of the substep [N s]
    double staticFriction = 0.0;              // [-]
    double kineticFriction = 0.0;             // [-]
    Vec3 impulse = Vec3::Zero();              // so far [N s]
    double height = 0.0;                      // at the start of the step [m]
    double restGap = 0.0;                     // [m]
    double normalSpeed = 0.0;                 // of the body [m/s]
    std::size_t source = 0;                   // index into the contacts of the inputs
  };

  /// Contacts that share free vertices, and these vertices. It refers to coupled_ and coupledVertices_.
  struct Island {
    std::span<Contact> contacts;
    std::span<const std::uint32_t> vertices;
    bool hasFeaturePairs = false;
  };

  /// Islands from `first` to before `last`.
  struct IslandRange {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void addContact(const SubstepContact& from, std::size_t source, const Vec3& frameVelocity,
                  const simd::SlicedCloth<T>& cloth);
  void separateCoupled();
  [[nodiscard]] std::size_t freeVertexOf(const Contact& contact) const;
  template <typename Visit>
  void forEachFreeVertex(const Contact& contact, Visit&& visit) const {
    for (std::size_t c = 0; c < contact.count; ++c) {
      if (vertices_[contact.vertices[c]].inverseMass > 0.0) {
        visit(contact.vertices[c]);
      }
    }
  }
  void findIslands();
  void listIslands(const RaggedRows<std::uint32_t>& contacts, const RaggedRows<std::uint32_t>& vertices);
  [[nodiscard]] bool isSlow(const Island& island) const;
  void applyIsland(const Island& island, double time, double drift, simd::SlicedCloth<T>& cloth);
  void solveIsland(const Island& island);
  void limitSpeeds(const Island& island);
  [[nodiscard]] double squaredSpeedOfObstacles(const Island& island) const;
  [[nodiscard]] double minSpeedOf(const simd::SlicedCloth<T>& cloth, double time, double drift,
                                  const Contact& contact) const;
  bool solve(Contact& contact);
  void apply(const Vec3& impulse, const Contact& contact);
  static void write(const Vertex& vertex, double drift, simd::SlicedCloth<T>& cloth);
  [[nodiscard]] std::span<Vertex> verticesOf(const simd::StepShare& share);
  [[nodiscard]] IslandRange islandsOf(const simd::StepShare& share) const;
  bool take(std::size_t island);

  std::vector<Vertex> vertices_;  // by permuted index
  std::vector<Contact> single_;   // of one vertex that has no other contact, by permuted index of the vertex
  std::vector<Contact> coupled_;  // by island
  std::vector<Contact> sorted_;   // scratch
  std::vector<std::uint32_t> coupledVertices_;  // indices into vertices_, by island
  std::vector<Island> islands_;                 // by first vertex
  std::vector<unsigned char> taken_;            // of each island: 1 if a thread has begun it in this substep
  std::vector<int> contactCount_;               // of each vertex
  std::vector<std::size_t> slots_;              // by permuted index: index into vertices_
};

}  // namespace drape::sim::adaptive
