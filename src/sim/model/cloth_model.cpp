#include "sim/model/cloth_model.hpp"

#include "sim/model/bounds.hpp"
#include "sim/model/local_frequency.hpp"
#include "sim/model/mesh_topology.hpp"
#include "sim/model/sim_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace drape::sim {
namespace {

using Fault = ClothModelError::Fault;

void checkMesh(const ClothMesh& mesh) {
  if (mesh.positions.empty() || mesh.triangles.empty()) {
    throw ClothModelError(Fault::NoTriangle, {.found = static_cast<std::int64_t>(mesh.triangles.size()),
                                              .count = static_cast<std::int64_t>(mesh.positions.size())});
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite()) {
      throw ClothModelError(Fault::VertexNotFinite, {.index = static_cast<std::int64_t>(v)});
    }
  }
  const int count = static_cast<int>(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      if (v < 0 || v >= count) {
        throw ClothModelError(Fault::NoSuchVertex, {.index = static_cast<std::int64_t>(t), .found = v, .count = count});
      }
    }
  }
}

std::vector<Spring> springsOf(const ClothMesh& mesh) {
  const MeshEdges topology = edgesOf(mesh.triangles, mesh.positions.size());
  std::vector<Spring> springs;
  springs.reserve(topology.edges.size());
  for (const auto& [a, b] : topology.edges) {
    springs.push_back({a, b, (mesh.positions[b] - mesh.positions[a]).norm()});
  }
  return springs;
}

std::vector<double> vertexAreasOf(const ClothMesh& mesh) {
  std::vector<double> areas(mesh.positions.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3& b = mesh.positions[t[1]];
    const Vec3& c = mesh.positions[t[2]];
    const double third = (b - a).cross(c - a).norm() / 6.0;
    for (const int v : t) {
      areas[v] += third;
    }
  }
  return areas;
}

/// With area lumping every vertex gets at least this fraction of the mean mass. A vertex of tiny area would otherwise
/// have almost no mass and make the system arbitrarily stiff.
constexpr double minMassFraction = 0.05;

/// Computes the largest local frequency and damping rate of the free vertices in the rest shape. The frequencies of a
/// fabric are an upper bound of those of the whole mesh only all together (ClothModel::fabricStiffness), so its pinned
/// vertices count, too.
void findRates(ClothModel& model) {
  model.unitFrequency = 0.0;
  model.stiffestSpring =
      std::accumulate(model.springs.begin(), model.springs.end(), model.springs.empty() ? 1.0 : 0.0,
                      [](double largest, const Spring& spring) { return std::max(largest, spring.relativeStiffness); });
  model.unitDampingRate = 0.0;
  for (std::size_t i = 0; i < model.restPositions.size(); ++i) {
    if (!model.pinned[i] || !model.fabricStiffness.empty()) {
      model.unitFrequency = std::max(model.unitFrequency, std::sqrt(unitFrequencySquared(model, i)));
    }
    if (model.pinned[i]) {
      continue;
    }
    const auto springs = static_cast<double>(model.springEnds[i].size());
    model.unitDampingRate = std::max(model.unitDampingRate, 2.0 * springs / model.vertexMass[i]);
  }
}

void requireSize(std::size_t given, std::size_t needed, Fault fault) {
  if (given != needed) {
    throw ClothModelError(fault,
                          {.found = static_cast<std::int64_t>(given), .count = static_cast<std::int64_t>(needed)});
  }
}

}  // namespace

std::vector<double> lumpedMasses(std::span<const double> vertexAreas, double totalMass, MassLumping lumping) {
  if (!(totalMass > 0.0) || !std::isfinite(totalMass)) {
    throw ClothModelError(Fault::Mass, {.value = totalMass});
  }
  const auto count = static_cast<double>(vertexAreas.size());
  std::vector<double> masses(vertexAreas.size(), totalMass / count);
  const double area = std::accumulate(vertexAreas.begin(), vertexAreas.end(), 0.0);
  if (lumping == MassLumping::Uniform || !(area > 0.0)) {
    return masses;
  }
  std::transform(vertexAreas.begin(), vertexAreas.end(), masses.begin(),
                 [&](double vertexArea) { return std::max(vertexArea, minMassFraction * area / count); });
  const double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
  std::for_each(masses.begin(), masses.end(), [&](double& mass) { mass *= totalMass / sum; });
  return masses;
}

RaggedRows<SpringEnd> springEndsOf(const std::vector<Spring>& springs, std::size_t vertexCount) {
  auto ends = RaggedRows<SpringEnd>::collect(vertexCount, [&](const auto& add) {
    for (std::size_t s = 0; s < springs.size(); ++s) {
      add(springs[s].a, {springs[s].b, static_cast<int>(s)});
      add(springs[s].b, {springs[s].a, static_cast<int>(s)});
    }
  });
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const std::span<SpringEnd> row = ends[v];
    std::sort(row.begin(), row.end(), [](const SpringEnd& x, const SpringEnd& y) { return x.neighbour < y.neighbour; });
  }
  return ends;
}

int springBetween(const RaggedRows<SpringEnd>& ends, int vertex, int neighbour) {
  const std::span<const SpringEnd> own = ends[vertex];
  const auto found = std::ranges::lower_bound(own, neighbour, {}, &SpringEnd::neighbour);
  return found != own.end() && found->neighbour == neighbour ? found->spring : -1;
}

double ClothModel::restArea() const {
  return std::accumulate(vertexArea.begin(), vertexArea.end(), 0.0);
}

double ClothModel::totalMass() const {
  return std::accumulate(vertexMass.begin(), vertexMass.end(), 0.0);
}

bool ClothModel::evenlyStiff() const {
  return std::all_of(springs.begin(), springs.end(), [](const Spring& s) { return s.relativeStiffness == 1.0; });
}

double diagonalOf(const ClothModel& model) {
  return boundsOf(model.restPositions).diagonal().norm();
}

double restAreaOf(const ClothMesh& mesh) {
  checkMesh(mesh);
  const std::vector<double> areas = vertexAreasOf(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::shared_ptr<const ClothModel> buildClothModel(const ClothMesh& mesh, double totalMass, MassLumping lumping,
                                                  const std::vector<int>& pins) {
  checkMesh(mesh);
  auto model = std::make_shared<ClothModel>();
  const int count = static_cast<int>(mesh.positions.size());
  model->restPositions = mesh.positions;
  model->triangles = mesh.triangles;
  model->springs = springsOf(mesh);
  model->springEnds = springEndsOf(model->springs, mesh.positions.size());
  model->vertexTriangles = trianglesOfVertices(mesh.triangles, mesh.positions.size());
  model->vertexArea = vertexAreasOf(mesh);
  model->vertexMass = lumpedMasses(model->vertexArea, totalMass, lumping);
  model->pinned.assign(mesh.positions.size(), false);
  for (const int pin : pins) {
    if (pin < 0 || pin >= count) {
      throw ClothModelError(Fault::NoSuchPin, {.index = pin, .count = count});
    }
    model->pinned[pin] = true;
  }
  findRates(*model);
  return model;
}

std::shared_ptr<const ClothModel> withMass(const ClothModel& model, double totalMass, MassLumping lumping) {
  auto changed = std::make_shared<ClothModel>(model);
  changed->vertexMass = lumpedMasses(model.vertexArea, totalMass, lumping);
  findRates(*changed);
  return changed;
}

std::shared_ptr<const ClothModel> withVertexMasses(const ClothModel& model, std::vector<double> masses) {
  requireSize(masses.size(), model.restPositions.size(), Fault::MassCount);
  for (std::size_t v = 0; v < masses.size(); ++v) {
    if (!(masses[v] > 0.0) || !std::isfinite(masses[v])) {
      throw ClothModelError(Fault::VertexMass, {.index = static_cast<std::int64_t>(v), .value = masses[v]});
    }
  }
  auto changed = std::make_shared<ClothModel>(model);
  changed->vertexMass = std::move(masses);
  findRates(*changed);
  return changed;
}

std::shared_ptr<const ClothModel> withSpringStiffness(const ClothModel& model, const std::vector<double>& relative) {
  requireSize(relative.size(), model.springs.size(), Fault::StiffnessCount);
  auto changed = std::make_shared<ClothModel>(model);
  for (std::size_t s = 0; s < relative.size(); ++s) {
    if (!(relative[s] >= 0.0) || !std::isfinite(relative[s])) {
      throw ClothModelError(Fault::Stiffness, {.index = static_cast<std::int64_t>(s), .value = relative[s]});
    }
    changed->springs[s].relativeStiffness = relative[s];
  }
  findRates(*changed);
  return changed;
}

std::shared_ptr<const ClothModel> withFabric(const ClothModel& model, std::shared_ptr<const fabric::Fabric> fabric,
                                             std::vector<double> stiffness) {
  requireSize(stiffness.size(), model.restPositions.size(), Fault::StiffnessCount);
  auto changed = std::make_shared<ClothModel>(model);
  changed->fabric = std::move(fabric);
  changed->fabricStiffness = std::move(stiffness);
  findRates(*changed);
  return changed;
}

std::shared_ptr<const ClothModel> withRestSizes(const ClothModel& model, std::span<const double> lengths,
                                                std::vector<double> areas) {
  requireSize(lengths.size(), model.springs.size(), Fault::LengthCount);
  requireSize(areas.size(), model.restPositions.size(), Fault::AreaCount);
  auto changed = std::make_shared<ClothModel>(model);
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    changed->springs[s].restLength = lengths[s];
  }
  changed->vertexArea = std::move(areas);
  changed->hasPattern = true;
  return changed;
}

std::shared_ptr<const ClothModel> withMeshSizes(const ClothModel& model) {
  auto changed = std::make_shared<ClothModel>(model);
  if (!model.hasPattern) {
    return changed;
  }
  for (Spring& spring : changed->springs) {
    spring.restLength = (model.restPositions[spring.b] - model.restPositions[spring.a]).norm();
  }
  changed->vertexArea = vertexAreasOf({model.restPositions, model.triangles});
  changed->hasPattern = false;
  return changed;
}

std::shared_ptr<const ClothModel> withSprings(const ClothModel& model) {
  auto changed = std::make_shared<ClothModel>(*withMeshSizes(model));
  changed->fabric.reset();
  changed->fabricStiffness.clear();
  findRates(*changed);
  return changed;
}

std::shared_ptr<const ClothModel> withCloths(const ClothModel& model, std::vector<int> clothOf) {
  requireSize(clothOf.size(), model.restPositions.size(), Fault::ClothCount);
  auto changed = std::make_shared<ClothModel>(model);
  changed->clothOf = std::move(clothOf);
  return changed;
}

std::shared_ptr<const ClothModel> withPins(const ClothModel& model, std::vector<bool> pinned) {
  requireSize(pinned.size(), model.restPositions.size(), Fault::PinCount);
  auto changed = std::make_shared<ClothModel>(model);
  changed->pinned = std::move(pinned);
  findRates(*changed);
  return changed;
}

}  // namespace drape::sim
