#include "sim/simd/constraint_lanes.hpp"

#include "sim/colouring.hpp"
#include "sim/simd/vertex_order.hpp"

#include <algorithm>

namespace drape {

ConstraintLanes::ConstraintLanes(const ClothModel& model) : order(stepOrder(model)) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  }
  vertices.assign(4 * (order.size() + 1), 0.0F);
  Batch none;
  none.a.fill(static_cast<std::int32_t>(order.size()));
  none.b = none.a;
  const RaggedRows<int> colours = colourSprings(model);
  for (std::size_t c = 0; c + 1 < colours.begin.size(); ++c) {
    std::vector<const Spring*> springs;
    for (int i = colours.begin[c]; i < colours.begin[c + 1]; ++i) {
      springs.push_back(&model.springs[static_cast<std::size_t>(colours.values[static_cast<std::size_t>(i)])]);
    }
    std::sort(springs.begin(), springs.end(), [&](const Spring* s, const Spring* t) {
      return place[static_cast<std::size_t>(s->a)] < place[static_cast<std::size_t>(t->a)];
    });
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const std::size_t lane = i % sliceLanes;
      if (lane == 0) {
        batches.push_back(none);
      }
      batches.back().a[lane] = place[static_cast<std::size_t>(springs[i]->a)];
      batches.back().b[lane] = place[static_cast<std::size_t>(springs[i]->b)];
      batches.back().restLength[lane] = static_cast<float>(springs[i]->restLength);
    }
  }
}

void ConstraintLanes::load(const ClothModel& model, const std::vector<Vec3>& positions) {
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto v = static_cast<std::size_t>(order[k]);
    for (std::size_t c = 0; c < 3; ++c) {
      vertices[4 * k + c] = static_cast<float>(positions[v][static_cast<Eigen::Index>(c)]);
    }
    vertices[4 * k + 3] = model.pinned[v] ? 0.0F : static_cast<float>(1.0 / model.vertexMass[v]);
  }
  for (Batch& batch : batches) {
    batch.multiplier.fill(0.0F);
  }
}

void ConstraintLanes::store(std::vector<Vec3>& positions) const {
  for (std::size_t k = 0; k < order.size(); ++k) {
    const float* from = vertices.data() + 4 * k;
    positions[static_cast<std::size_t>(order[k])] =
        Vec3(static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2]));
  }
}

}  // namespace drape
