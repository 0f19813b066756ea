#include "bench/plain_xpbd.hpp"

#include "sim/model/colouring.hpp"

#include <cmath>

namespace drape::bench {

PlainXpbd::PlainXpbd(const sim::ClothModel& model) {
  const sim::RaggedRows<int> colours = sim::colourSprings(model);
  for (const int index : colours.values()) {
    const sim::Spring& spring = model.springs[index];
    constraints_.push_back({spring.a, spring.b, static_cast<float>(spring.restLength), 0.0F});
  }
}

void PlainXpbd::load(const sim::ClothModel& model, const sim::ClothState& state) {
  vertices_.clear();
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Eigen::Vector3f x = state.positions[v].cast<float>();
    vertices_.push_back({x.x(), x.y(), x.z(), model.pinned[v] ? 0.0F : static_cast<float>(1.0 / model.vertexMass[v])});
  }
  for (Constraint& constraint : constraints_) {
    constraint.multiplier = 0.0F;
  }
}

void PlainXpbd::iterate(float inverseCompliance) {
  for (Constraint& constraint : constraints_) {
    Vertex& a = vertices_[static_cast<std::size_t>(constraint.a)];
    Vertex& b = vertices_[static_cast<std::size_t>(constraint.b)];
    const float x = b.x - a.x;
    const float y = b.y - a.y;
    const float z = b.z - a.z;
    const float length = std::sqrt(x * x + y * y + z * z);
    if (length <= 1e-9F * constraint.restLength) {
      continue;
    }
    const float weight = a.inverseMass + b.inverseMass;
    const float change = -(inverseCompliance * (length - constraint.restLength) + constraint.multiplier) /
                         (inverseCompliance * weight + 1.0F);
    constraint.multiplier += change;
    const float along = change / length;
    const float pullA = along * a.inverseMass;
    const float pullB = along * b.inverseMass;
    a.x -= pullA * x;
    a.y -= pullA * y;
    a.z -= pullA * z;
    b.x += pullB * x;
    b.y += pullB * y;
    b.z += pullB * z;
  }
}

}  // namespace drape::bench
