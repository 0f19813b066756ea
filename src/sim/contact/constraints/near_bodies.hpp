#pragma once

#include "sim/contact/broad_phase/reachable_bodies.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"
#include "sim/contact/constraints/mesh_search.hpp"

#include <map>
#include <vector>

namespace drape::sim::contact {

/// A body that the cloth could reach in a step, with its searches and the distances that contact keeps.
struct NearBody {
  const BodyStep* step = nullptr;
  int index = 0;                   ///< among the near bodies
  SearchableMesh* mesh = nullptr;  ///< of a box or a mesh; null for other shapes
  MeshSearch* search = nullptr;    ///< finds contacts and planes on that mesh
  ContactOffsets offsets;
  double friction = 1.0;  ///< factor on the friction of the body [-]

  /// Requires a mesh. @param atEnd the cloth's start positions belong to the end of the step
  [[nodiscard]] MeshInStep meshInStep(bool atEnd) const;
  [[nodiscard]] ConstraintBuilder builder() const { return {*step, index, offsets, friction}; }
};

/// The bodies that the cloth could reach in a step. Keeps the cached data of the searches on meshes from step to step.
class NearBodies {
 public:
  void clear() { bodies_.clear(); }

  /// Adds bodies with the offsets that contact keeps.
  void add(const std::vector<ReachableBody>& found, const ClothStep& step);

  /// Starts the searches of a pass.
  void beginPass(const PreparedCloth& cloth);

  [[nodiscard]] bool empty() const { return bodies_.empty(); }
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] std::vector<NearBody>::iterator begin() { return bodies_.begin(); }
  [[nodiscard]] std::vector<NearBody>::iterator end() { return bodies_.end(); }
  [[nodiscard]] std::vector<NearBody>::const_iterator begin() const { return bodies_.begin(); }
  [[nodiscard]] std::vector<NearBody>::const_iterator end() const { return bodies_.end(); }
  [[nodiscard]] const NearBody& operator[](std::size_t body) const { return bodies_[body]; }

  /// The motions of the bodies.
  [[nodiscard]] std::vector<const BodyStep*> steps() const;
  [[nodiscard]] bool haveMeshes() const;
  /// The largest contact offset [m]; 0 without bodies.
  [[nodiscard]] double maxContactOffset() const;

 private:
  std::vector<NearBody> bodies_;
  std::map<const Body*, MeshSearch> searches_;  // never iterated over, since the order of addresses varies
};

}  // namespace drape::sim::contact
