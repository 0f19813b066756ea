#include "sim/fabric/weld.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/model/disjoint_sets.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace drape::sim::fabric {
namespace {

/// The share of its mass that a welded vertex keeps [-], because no mass may be 0.
constexpr double keptMass = 1e-6;

/// The triangles of the leaders. The rest positions of a leader are the centre of mass of what is welded to it.
ClothMesh meshOfLeaders(const ClothModel& model, std::span<const int> leaders) {
  ClothMesh mesh{.positions = meansOfWelded(model, leaders, model.restPositions), .triangles = model.triangles};
  for (Triangle& triangle : mesh.triangles) {
    std::ranges::transform(triangle, triangle.begin(), [&](int v) { return leaders[v]; });
  }
  return mesh;
}

std::vector<double> massesOfLeaders(const ClothModel& model, std::span<const int> leaders) {
  std::vector<double> masses(model.vertexMass.size(), 0.0);
  for (std::size_t v = 0; v < masses.size(); ++v) {
    const bool follows = leaders[v] != static_cast<int>(v);
    const double kept = follows ? keptMass * model.vertexMass[v] : 0.0;
    masses[v] += kept;
    masses[leaders[v]] += model.vertexMass[v] - kept;
  }
  return masses;
}

std::vector<bool> pinsOfLeaders(const ClothModel& model, std::span<const int> leaders) {
  std::vector<bool> pinned(model.pinned.size(), false);
  for (std::size_t v = 0; v < pinned.size(); ++v) {
    const bool follows = leaders[v] != static_cast<int>(v);
    pinned[v] = pinned[v] || follows || model.pinned[v];
    pinned[leaders[v]] = pinned[leaders[v]] || model.pinned[v];
  }
  return pinned;
}

/// The cloth of each vertex, where cloths with a common seam have the lowest of their numbers.
std::vector<int> joinedCloths(const ClothModel& model, std::span<const int> leaders) {
  DisjointSets sets(static_cast<std::size_t>(*std::ranges::max_element(model.clothOf)) + 1);
  for (std::size_t v = 0; v < leaders.size(); ++v) {
    sets.join(model.clothOf[v], model.clothOf[leaders[v]]);
  }
  std::vector<int> joined;
  std::ranges::transform(model.clothOf, std::back_inserter(joined), [&](int cloth) { return sets.root(cloth); });
  return joined;
}

/// Gives the springs the rest lengths and the stiffness of those that became them: the means.
std::shared_ptr<const ClothModel> withSpringsOf(const ClothModel& model, std::span<const int> leaders,
                                                const ClothModel& welded) {
  std::vector<double> lengths(welded.springs.size(), 0.0);
  std::vector<double> stiffness(welded.springs.size(), 0.0);
  std::vector<double> count(welded.springs.size(), 0.0);
  for (const Spring& spring : model.springs) {
    const int now = springBetween(welded.springEnds, leaders[spring.a], leaders[spring.b]);
    if (now >= 0) {
      lengths[now] += spring.restLength;
      stiffness[now] += spring.relativeStiffness;
      count[now] += 1.0;
    }
  }
  for (std::size_t s = 0; s < count.size(); ++s) {
    lengths[s] /= count[s];
    stiffness[s] /= count[s];
  }
  std::vector<double> areas(model.vertexArea.size(), 0.0);
  for (std::size_t v = 0; v < areas.size(); ++v) {
    areas[leaders[v]] += model.vertexArea[v];
  }
  return withSpringStiffness(*withRestSizes(welded, lengths, std::move(areas)), stiffness);
}

}  // namespace

std::shared_ptr<const ClothModel> withWelds(const ClothModel& model, std::span<const int> leaders) {
  auto welded =
      buildClothModel(meshOfLeaders(model, leaders), model.totalMass(), MassLumping::Uniform, std::vector<int>());
  welded = withPins(*withVertexMasses(*welded, massesOfLeaders(model, leaders)), pinsOfLeaders(model, leaders));
  if (!model.clothOf.empty()) {
    welded = withCloths(*welded, joinedCloths(model, leaders));
  }
  return model.fabric ? withPatternFabric(*welded, model.fabric->materials, model.fabric->shape.triangles,
                                          RestCurvature::Flat, PatternMesh::Unrelated)
                      : withSpringsOf(model, leaders, *welded);
}

std::vector<Vec3> meansOfWelded(const ClothModel& model, std::span<const int> leaders, std::span<const Vec3> values) {
  std::vector<Vec3> means(values.begin(), values.end());
  std::vector<Vec3> moments(values.size(), Vec3::Zero());
  std::vector<double> masses(values.size(), 0.0);
  std::vector<int> members(values.size(), 0);
  for (std::size_t v = 0; v < values.size(); ++v) {
    moments[leaders[v]] += model.vertexMass[v] * values[v];
    masses[leaders[v]] += model.vertexMass[v];
    ++members[leaders[v]];
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (members[v] > 1) {
      means[v] = moments[v] / masses[v];
    }
  }
  return means;
}

bool isFollower(const ClothModel& model, int vertex) {
  return model.vertexTriangles[static_cast<std::size_t>(vertex)].empty();
}

std::vector<bool> ownPinsOf(const ClothModel& model) {
  std::vector<bool> pins = model.pinned;
  for (int v = 0; v < model.vertexCount(); ++v) {
    pins[v] = pins[v] && !isFollower(model, v);
  }
  return pins;
}

}  // namespace drape::sim::fabric
