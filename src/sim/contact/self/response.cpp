#include "sim/contact/self/response.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace drape::sim::contact {
namespace {

constexpr int maxColours = 64;

std::vector<float> inverseMassesOf(const ClothModel& model) {
  std::vector<float> inverse(model.vertexMass.size() + 1 + maxLanes, 0.0F);
  for (std::size_t v = 0; v < model.vertexMass.size(); ++v) {
    inverse[v] = model.pinned[v] ? 0.0F : static_cast<float>(1.0 / model.vertexMass[v]);
  }
  return inverse;
}

/// Zero displacements, interleaved with the inverse masses.
void prepareDisplacements(const std::vector<float>& inverseMasses, std::vector<float>& displacements) {
  displacements.resize(4 * inverseMasses.size());
  for (std::size_t v = 0; v < inverseMasses.size(); ++v) {
    displacements[4 * v] = 0.0F;
    displacements[4 * v + 1] = 0.0F;
    displacements[4 * v + 2] = 0.0F;
    displacements[4 * v + 3] = inverseMasses[v];
  }
}

/// Calls visit(vertex, displacement) once per displaced vertex, and sets the displacements to zero.
template <typename Visit>
void applyAndClear(const ContactLanes& contacts, std::vector<float>& displacements, const Visit& visit) {
  for (const std::vector<std::int32_t>* ends : {&contacts.a, &contacts.b}) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
      const auto v = static_cast<std::size_t>((*ends)[i]);
      float* const move = displacements.data() + 4 * v;
      if (move[0] != 0.0F || move[1] != 0.0F || move[2] != 0.0F) {
        visit(v, Vec3(static_cast<double>(move[0]), static_cast<double>(move[1]), static_cast<double>(move[2])));
        move[0] = move[1] = move[2] = 0.0F;
      }
    }
  }
}

}  // namespace

void colourPairs(int vertices, const std::vector<VertexPair>& pairs, std::vector<std::uint64_t>& scratch,
                 ColouredPairs& coloured) {
  scratch.assign(static_cast<std::size_t>(vertices) + pairs.size(), 0);
  std::uint64_t* const taken = scratch.data();
  std::uint64_t* const colours = taken + vertices;
  coloured.begin.assign(maxColours + 1, 0);
  std::size_t left = 0;  // pairs without a free colour
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const VertexPair& pair = pairs[i];
    const int colour = std::countr_one(taken[pair.a] | taken[pair.b]);
    colours[i] = static_cast<std::uint64_t>(colour);
    if (colour == maxColours) {
      ++left;
      continue;
    }
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(colour);
    taken[pair.a] |= bit;
    taken[pair.b] |= bit;
    ++coloured.begin[colour + 1];
  }
  for (std::size_t c = 0; c < maxColours; ++c) {
    coloured.begin[c + 1] += coloured.begin[c];
  }
  std::array<int, maxColours + 1> next{};
  std::copy(coloured.begin.begin(), coloured.begin.end(), next.begin());
  coloured.pairs.resize(pairs.size() + maxLanes);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    coloured.pairs[next[colours[i]]++] = pairs[i];
  }
  for (std::size_t i = 0; i < left; ++i) {  // each gets its own colour
    coloured.begin.push_back(coloured.begin.back() + 1);
  }
  while (coloured.begin.size() > 1 && coloured.begin[coloured.begin.size() - 2] == coloured.begin.back()) {
    coloured.begin.pop_back();
  }
}

void ContactLanes::resize(std::size_t capacity) {
  if (a.size() >= capacity) {
    return;
  }
  for (std::vector<std::int32_t>* part : {&a, &b}) {
    part->resize(capacity);
  }
  for (std::vector<float>* part : {&normalX, &normalY, &normalZ, &offsetX, &offsetY, &offsetZ, &minDistance, &mass,
                                   &normalImpulse, &frictionX, &frictionY, &frictionZ}) {
    part->resize(capacity);
  }
}

int SelfResponse::report(const Inputs& inputs, const ClothState& state, std::vector<ContactPoint>& points) const {
  const auto outside = static_cast<std::int32_t>(state.positions.size());
  int touching = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts_.count); ++i) {
    const bool hasImpulse = contacts_.normalImpulse[i] > 0.0F;
    if (contacts_.a[i] != outside && (hasImpulse || contacts_.minDistance[i] < static_cast<float>(inputs.thickness))) {
      const Vec3& a = state.positions[contacts_.a[i]];
      const Vec3& b = state.positions[contacts_.b[i]];
      const Vec3 normal(static_cast<double>(contacts_.normalX[i]), static_cast<double>(contacts_.normalY[i]),
                        static_cast<double>(contacts_.normalZ[i]));
      points.push_back({0.5 * (a + b), normal});
      ++touching;
    }
  }
  return touching;
}

int SelfResponse::resolve(const ClothModel& model, const Inputs& inputs, const ColouredPairs& pairs,
                          const PositionLanes& startPositions, const PositionLanes& positions, ClothState& state,
                          std::vector<ContactPoint>& points) {
  Buffers& buffers = buffers_.get(model, [](const ClothModel& m) {
    Buffers made;
    made.inverseMasses = inverseMassesOf(m);
    prepareDisplacements(made.inverseMasses, made.displacements);
    prepareDisplacements(made.inverseMasses, made.pushOuts);
    return made;
  });
  const auto thickness = static_cast<float>(inputs.thickness);
  const bool overlap = collectContacts(pairs, startPositions, positions, buffers.inverseMasses, thickness, contacts_);
  if (contacts_.count == 0) {
    return 0;
  }
  for (int sweep = 0; sweep < maxSweeps; ++sweep) {
    if (sweepContacts(inputs.friction, contacts_, buffers.displacements) <= tolerance * thickness) {
      break;
    }
  }
  if (overlap) {
    pushOutContacts(thickness, inputs.pushOut, contacts_, buffers.displacements, buffers.pushOuts);
    applyAndClear(contacts_, buffers.pushOuts, [&](std::size_t v, const Vec3& push) { state.positions[v] += push; });
  }
  const double perTime = 1.0 / inputs.timeStep;
  applyAndClear(contacts_, buffers.displacements, [&](std::size_t v, const Vec3& move) {
    state.positions[v] += move;
    state.velocities[v] += perTime * move;
  });
  return report(inputs, state, points);
}

}  // namespace drape::sim::contact
