#include "sim/simd/constraint_lanes.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/model/colouring.hpp"
#include "sim/simd/vertex_order.hpp"

#include <algorithm>

namespace drape::sim::simd {

ConstraintLanes::ConstraintLanes(const ClothModel& model) : order(stepOrder(model)), indexOf(order.size()) {
  for (std::size_t k = 0; k < order.size(); ++k) {
    indexOf[order[k]] = static_cast<int>(k);
  }
  for (std::vector<float>* numbers : {&vertices, &predicted, &velocities}) {
    numbers->assign(4 * (order.size() + 1), 0.0F);
  }
  Batch none;
  none.a.fill(static_cast<std::int32_t>(order.size()));
  none.b = none.a;
  const RaggedRows<int> colours = colourSprings(model);
  colourBegin.push_back(0);
  const bool even = model.evenlyStiff();
  for (std::size_t c = 0; c < colours.rowCount(); ++c) {
    std::vector<const Spring*> springs;
    for (const int s : colours[c]) {
      springs.push_back(&model.springs[s]);
    }
    std::sort(springs.begin(), springs.end(),
              [&](const Spring* s, const Spring* t) { return indexOf[s->a] < indexOf[t->a]; });
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const std::size_t lane = i % sliceLanes;
      if (lane == 0) {
        batches.push_back(none);
        relativeStiffness.resize(even ? 0 : batches.size());
      }
      batches.back().a[lane] = indexOf[springs[i]->a];
      batches.back().b[lane] = indexOf[springs[i]->b];
      batches.back().restLength[lane] = static_cast<float>(springs[i]->restLength);
      if (!even) {
        relativeStiffness.back()[lane] = static_cast<float>(springs[i]->relativeStiffness);
      }
    }
    colourBegin.push_back(static_cast<int>(batches.size()));
  }
}

LaneRange LaneRange::partOf(int member, int members) const {
  const auto boundary = [&](int m) {
    return begin + static_cast<int>(static_cast<long long>(end - begin) * m / members);
  };
  return {boundary(member), boundary(member + 1)};
}

void loadVertices(const ClothModel& model, const ClothState& state, ConstraintLanes& constraints, LaneRange range) {
  for (int index = range.begin; index < range.end; ++index) {
    const auto k = static_cast<std::size_t>(index);
    const auto v = static_cast<std::size_t>(constraints.order[k]);
    const bool free = !model.pinned[v];
    float* const x = constraints.vertices.data() + 4 * k;
    float* const velocity = constraints.velocities.data() + 4 * k;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto axis = static_cast<Eigen::Index>(c);
      x[c] = static_cast<float>(state.positions[v][axis] - constraints.origin[axis]);
      velocity[c] = free ? static_cast<float>(state.velocities[v][static_cast<Eigen::Index>(c)]) : 0.0F;
    }
    x[3] = free ? static_cast<float>(1.0 / model.vertexMass[v]) : 0.0F;
    velocity[3] = x[3];
  }
}

void storeVertices(const ClothModel& model, const ConstraintLanes& constraints, ClothState& state, LaneRange range) {
  const auto vectorAt = [](const std::vector<float>& numbers, std::size_t k) {
    const float* const from = numbers.data() + 4 * k;
    return Vec3(static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2]));
  };
  for (int index = range.begin; index < range.end; ++index) {
    const auto k = static_cast<std::size_t>(index);
    const auto v = static_cast<std::size_t>(constraints.order[k]);
    if (model.pinned[v]) {
      state.velocities[v].setZero();
    } else {
      state.positions[v] = constraints.origin + vectorAt(constraints.vertices, k);
      state.velocities[v] = vectorAt(constraints.velocities, k);
    }
  }
}

// The two loops below treat the fourth number of a vertex like the coordinates and leave it unchanged. So the compiler
// can vectorise them.
void predictVertices(ConstraintLanes& constraints, float timeStep, float gravity, LaneRange range) {
  const std::array<float, 4> step{timeStep, timeStep, timeStep, 0.0F};
  const std::array<float, 4> fall{0.0F, -timeStep * gravity, 0.0F, 0.0F};
  for (int index = range.begin; index < range.end; ++index) {
    const std::size_t at = 4 * static_cast<std::size_t>(index);
    float* const x = constraints.vertices.data() + at;
    float* const v = constraints.velocities.data() + at;
    float* const predicted = constraints.predicted.data() + at;
    const float free = v[3] > 0.0F ? 1.0F : 0.0F;
    for (std::size_t c = 0; c < 4; ++c) {
      v[c] += free * fall[c];
      x[c] += step[c] * v[c];
      predicted[c] = x[c];
    }
  }
}

void predictWithAir(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                    ConstraintLanes& constraints, LaneRange range) {
  const auto h = static_cast<float>(parameters.timeStep);
  for (int index = range.begin; index < range.end; ++index) {
    const auto k = static_cast<std::size_t>(index);
    const auto vertex = static_cast<std::size_t>(constraints.order[k]);
    float* const x = constraints.vertices.data() + 4 * k;
    float* const v = constraints.velocities.data() + 4 * k;
    Vec3 change = Vec3::Zero();
    if (!model.pinned[vertex]) {
      change = (parameters.timeStep / model.vertexMass[vertex]) * gravityAndAir(model, parameters, state, vertex);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      v[c] += static_cast<float>(change[static_cast<Eigen::Index>(c)]);
      x[c] += h * v[c];
      constraints.predicted[4 * k + c] = x[c];
    }
  }
}

void velocitiesFromVertices(ConstraintLanes& constraints, float timeStep, LaneRange range) {
  const float rate = 1.0F / timeStep;
  const std::array<float, 4> rates{rate, rate, rate, 0.0F};
  for (int index = range.begin; index < range.end; ++index) {
    const std::size_t at = 4 * static_cast<std::size_t>(index);
    const float* const x = constraints.vertices.data() + at;
    const float* const predicted = constraints.predicted.data() + at;
    float* const v = constraints.velocities.data() + at;
    for (std::size_t c = 0; c < 4; ++c) {
      v[c] += (x[c] - predicted[c]) * rates[c];
    }
  }
}

}  // namespace drape::sim::simd
