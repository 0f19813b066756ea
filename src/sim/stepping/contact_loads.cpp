#include "sim/stepping/contact_loads.hpp"

#include "sim/model/normals.hpp"

#include <algorithm>

namespace drape::sim {

void ContactLoads::begin(const ClothModel& model) {
  sides_.assign(static_cast<std::size_t>(model.vertexCount()), {});
}

void ContactLoads::add(const ClothModel& model, std::span<const SubstepContact> contacts,
                       std::span<const Vec3> positions) {
  for (const SubstepContact& contact : contacts) {
    if (contact.impulse.isZero(0.0)) {
      continue;
    }
    for (std::size_t i = 0; i < contact.vertices.size(); ++i) {
      if (contact.weights[i] != 0.0) {
        add(model, positions, contact.vertices[i], contact.weights[i] * contact.impulse);
      }
    }
  }
}

void ContactLoads::addCorrection(const ClothModel& model, const ClothState& before, const ClothState& after) {
  for (int v = 0; v < model.vertexCount(); ++v) {
    const Vec3 change = after.velocities[v] - before.velocities[v];
    if (!change.isZero(0.0)) {
      add(model, after.positions, v, model.vertexMass[v] * change);
    }
  }
}

void ContactLoads::add(const ClothModel& model, std::span<const Vec3> positions, int vertex, const Vec3& impulse) {
  if (model.pinned[vertex]) {
    return;
  }
  const double normal = impulse.dot(vertexNormal(model, positions, vertex));
  (normal > 0.0 ? sides_[vertex].fromBack : sides_[vertex].fromFront) += normal;
}

std::vector<double> ContactLoads::impulses() const {
  std::vector<double> loads(sides_.size());
  std::transform(sides_.begin(), sides_.end(), loads.begin(),
                 [](const Sides& sides) { return std::max(sides.fromBack, -sides.fromFront); });
  return loads;
}

}  // namespace drape::sim
