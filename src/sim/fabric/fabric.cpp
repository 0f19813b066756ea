#include "sim/fabric/fabric.hpp"

#include "sim/fabric/highest_frequency.hpp"
#include "sim/fabric/rate_limit.hpp"
#include "sim/model/fingerprint.hpp"
#include "sim/model/quantile.hpp"
#include "sim/model/sim_error.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace drape::sim::fabric {
namespace {

/// The factor on the moduli of a triangle: below 1 for slivers.
double stiffnessScaleOf(const RestTriangle& triangle) {
  return std::min(1.0, qualityOf(triangle) / sliverQuality);
}

/// The materials with the slopes that they have beyond the strain at which they stiffen.
TriangleMaterials stiffened(const TriangleMaterials& materials) {
  return materials.with([](Material& material) {
    material.stretchWarp += material.stiffeningWarp;
    material.stretchWeft += material.stiffeningWeft;
    material.stiffeningWarp = material.stiffeningWeft = 0.0;
  });
}

/// The ratio of the estimated highest frequency to that of the power iteration, which comes from below [-]. Cloth in
/// motion is faster than at rest: by a tenth at a strain of 7 %.
constexpr double frequencyMargin = 1.1;

using CornerBlocks = std::array<Mat3, 3>;

/// The second derivative of the membrane's energy of each triangle at rest [N/m].
/// @param maxStretch in a mesh that differs from its pattern, see placedInSpace; 1: at rest
std::vector<Mat9> membraneAtRest(const Fabric& fabric, const TriangleMaterials& materials, const ClothModel& model,
                                 double maxStretch = 1.0) {
  const ForceDerivative variant = model.hasPattern ? ForceDerivative::Stabilised : ForceDerivative::Exact;
  std::vector<Mat9> stiffness;
  stiffness.reserve(model.triangles.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const RestTriangle& rest = fabric.shape.triangles[t];
    const Corners mesh = cornersOf(model.triangles[t], model.restPositions);
    stiffness.push_back(MembraneTriangle(rest, materials[t], fabric.membraneScales[t])
                            .derivative(model.hasPattern ? placedInSpace(rest, mesh, maxStretch) : mesh, variant));
  }
  return stiffness;
}

/// Its diagonal blocks at the corners [N/m].
std::vector<CornerBlocks> cornerBlocks(std::span<const Mat9> membrane) {
  std::vector<CornerBlocks> blocks;
  blocks.reserve(membrane.size());
  for (const Mat9& stiffness : membrane) {
    blocks.push_back({stiffness.block<3, 3>(0, 0), stiffness.block<3, 3>(3, 3), stiffness.block<3, 3>(6, 6)});
  }
  return blocks;
}

double largestEigenvalue(const Mat3& matrix) {
  return Eigen::SelfAdjointEigenSolver<Mat3>().computeDirect(matrix, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

/// The largest stiffness of the membrane at each vertex [N/m].
std::vector<double> sumAtVertices(const ClothModel& model, std::span<const CornerBlocks> blocks) {
  std::vector<Mat3> sums(model.restPositions.size(), Mat3::Zero());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      sums[model.triangles[t][corner]] += blocks[t][corner];
    }
  }
  std::vector<double> largest;
  largest.reserve(sums.size());
  std::ranges::transform(sums, std::back_inserter(largest), largestEigenvalue);
  return largest;
}

double medianEdge(const ClothModel& model) {
  std::vector<double> lengths;
  std::ranges::transform(model.springs, std::back_inserter(lengths), &Spring::restLength);
  return quantileExceededBy(lengths, 2);
}

/// Contact and mouse move a corner of a flat triangle as far as that of any other one. This stretches the triangle
/// across its longest side many times, and its stiffness goes with the square of the stretch.
/// @return that stretch [-]; 1 for triangles that are at least a fifth of the median edge high
double pulledStretch(const RestTriangle& rest, double edge) {
  constexpr double pull = 0.1;       // of a corner, in median edges [-]
  constexpr double tolerated = 0.5;  // stretch that needs no clamping [-]
  double longest = 0.0;
  for (const Vec2& side : rest.sides) {
    longest = std::max(longest, side.norm());
  }
  const double height = 2.0 * rest.area / longest;
  return height > 0.0 ? std::max(1.0, 1.0 + pull * edge / height - tolerated) : 1.0;
}

/// The triangle, stretched across its longest side.
Corners pulled(const RestTriangle& rest, double stretch) {
  const Vec2 longest = *std::ranges::max_element(rest.sides, {}, [](const Vec2& side) { return side.norm(); });
  const Vec2 across = Vec2(-longest.y(), longest.x()).normalized();
  const Eigen::Matrix2d map = Eigen::Matrix2d::Identity() + (stretch - 1.0) * across * across.transpose();
  Corners corners = Corners::Zero();
  corners.col(1).head<2>() = map * rest.sides[0];
  corners.col(2).head<2>() = map * (rest.sides[0] + rest.sides[1]);
  return corners;
}

/// Scales the stiffest triangles down to the RateLimit of the mesh, so that they keep to it while they are pulled.
void clampMembrane(const ClothModel& model, Fabric& fabric) {
  const TriangleMaterials materials = stiffened(fabric.materials);
  const std::vector<CornerBlocks> blocks = cornerBlocks(membraneAtRest(fabric, materials, model));
  const RateLimit limit(sumAtVertices(model, blocks), model.vertexArea, fabric.maxRatio, model.clothOf);
  const double edge = medianEdge(model);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const RestTriangle& rest = fabric.shape.triangles[t];
    const double stretch = pulledStretch(rest, edge);
    CornerBlocks own = blocks[t];
    if (stretch > 1.0) {
      const MembraneTriangle membrane(rest, materials[t], fabric.membraneScales[t]);
      own = cornerBlocks(std::array{membrane.derivative(pulled(rest, stretch), ForceDerivative::Stabilised)}).front();
    }
    double scale = 1.0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      scale = std::min(
          scale, limit.scaleOf(largestEigenvalue(own[corner]), static_cast<std::size_t>(model.triangles[t][corner])));
    }
    fabric.membraneScales[t] *= scale;
  }
}

/// The largest stiffness at each vertex [N/m]: the largest eigenvalue of its diagonal block of the stiffened membrane,
/// plus half the row sum of the bending matrix, which exceeds the diagonal where the matrix is far from dominant. The
/// frequency that follows from it (unitFrequencySquared) can be a third too high on garments. So all are scaled to the
/// frequency of the whole cloth. A mesh that is stretched against its pattern is stiffer than at rest, and counts as it
/// is: the cloth starts from it.
std::vector<double> stiffnessAtVertices(const Fabric& fabric, const ClothModel& model) {
  constexpr double asInMesh = std::numeric_limits<double>::infinity();
  const double maxStretch = fabric.patternMesh == PatternMesh::Strained ? asInMesh : 1.0;
  const std::vector<Mat9> membrane = membraneAtRest(fabric, stiffened(fabric.materials), model, maxStretch);
  std::vector<double> largest = sumAtVertices(model, cornerBlocks(membrane));
  if (fabric.bends()) {
    std::ranges::transform(largest, fabric.bendingHalfSums, largest.begin(), std::plus<>());
  }
  double estimate = 0.0;  // the largest unitFrequencySquared [1/s^2]
  for (std::size_t v = 0; v < largest.size(); ++v) {
    estimate = std::max(estimate, 2.0 * largest[v] / model.vertexMass[v]);
  }
  const double wanted = frequencyMargin * frequencyMargin * highestFrequencySquared(model, membrane, fabric.bending);
  if (estimate > 0.0 && wanted > 0.0) {
    std::ranges::transform(largest, largest.begin(), [&](double value) { return value * wanted / estimate; });
  }
  return largest;
}

/// Finds the pairs of vertices of edges and of the bending matrix.
void findPairs(const ClothModel& model, Fabric& fabric) {
  fabric.pairs.clear();
  fabric.pairsOfSides.clear();
  std::vector<Spring> edges;
  for (const Spring& edge : model.springs) {
    edges.push_back({.a = edge.a, .b = edge.b});
  }
  for (const RestMoment& moment : fabric.restMoments.hinges()) {
    const auto [opposite, other] = std::minmax(moment.vertices[2], moment.vertices[3]);
    edges.push_back({.a = opposite, .b = other});
  }
  for (int row = 0; row < fabric.bending.outerSize(); ++row) {
    for (VertexMatrix::InnerIterator entry(fabric.bending, row); entry; ++entry) {
      if (row < static_cast<int>(entry.col())) {
        edges.push_back({.a = row, .b = static_cast<int>(entry.col())});
      }
    }
  }
  const auto ends = [](const Spring& edge) { return std::pair(edge.a, edge.b); };
  std::ranges::sort(edges, {}, ends);
  const auto equal = [&](const Spring& one, const Spring& other) { return ends(one) == ends(other); };
  edges.erase(std::unique(edges.begin(), edges.end(), equal), edges.end());
  for (const Spring& edge : edges) {
    fabric.pairs.push_back({edge.a, edge.b, fabric.bends() ? fabric.bending.coeff(edge.a, edge.b) : 0.0});
  }
  fabric.pairEnds = springEndsOf(edges, model.restPositions.size());
  const auto between = [&](int a, int b) { return springBetween(fabric.pairEnds, a, b); };
  for (const auto& [a, b, c] : model.triangles) {
    fabric.pairsOfSides.push_back({between(a, b), between(b, c), between(c, a)});
  }
}

std::uint64_t fingerprintOf(const Fabric& fabric) {
  static_assert(sizeof(Material) % sizeof(double) == 0);
  Fingerprint fingerprint;
  const auto addMaterial = [&](const Material& material) {
    for (const double modulus : std::bit_cast<std::array<double, sizeof(Material) / sizeof(double)>>(material)) {
      fingerprint.add(modulus);
    }
  };
  std::ranges::for_each(fabric.materials.list(), addMaterial);
  for (std::size_t t = 0; t < fabric.shape.triangles.size() && fabric.materials.list().size() > 1; ++t) {
    fingerprint.add(static_cast<std::uint64_t>(fabric.materials.indexOf(t)));
  }
  for (const RestTriangle& triangle : fabric.shape.triangles) {
    for (const Vec2& side : triangle.sides) {
      fingerprint.add(side.x());
      fingerprint.add(side.y());
    }
  }
  fingerprint.add(fabric.maxRatio);
  for (const RestMoment& moment : fabric.restMoments.hinges()) {
    fingerprint.add(moment.modulus);
  }
  return fingerprint.value();
}

void buildMembrane(Fabric& fabric) {
  fabric.membrane.clear();
  for (std::size_t t = 0; t < fabric.shape.triangles.size(); ++t) {
    fabric.membrane.emplace_back(fabric.shape.triangles[t], fabric.materials[t], fabric.membraneScales[t]);
  }
}

void buildBending(const ClothModel& model, Fabric& fabric) {
  if (!resistBending(fabric.materials)) {
    return;
  }
  ClampedBending bending = clampedBendingMatrix(fabric.shape, fabric.materials, model.vertexArea,
                                                maxBendingRatio(fabric.maxRatio), model.clothOf);
  fabric.bending.swap(bending.matrix);
  fabric.bendingHalfSums = halfRowSums(fabric.bending);
  fabric.bendingScales = std::move(bending.scales);
  if (fabric.restCurvature == RestCurvature::Mesh) {
    fabric.restMoments =
        RestMoments(fabric.shape, fabric.materials, fabric.bendingScales, fabric.bending, model.restPositions);
  }
  if (!fabric.restMoments.empty()) {
    std::ranges::transform(fabric.bendingHalfSums, fabric.restMoments.halfRowSums(model.restPositions),
                           fabric.bendingHalfSums.begin(), std::plus<>());
  }
}

/// Clamps the stiffness of a fabric whose material, rest shape and membraneScales are set, and sets what follows from
/// it.
void build(const ClothModel& model, Fabric& fabric) {
  clampMembrane(model, fabric);
  buildMembrane(fabric);
  buildBending(model, fabric);
  fabric.fingerprint = fingerprintOf(fabric);
  fabric.slivers = 0;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const bool bendsLess = fabric.bends() && fabric.bendingScales[t] < 1.0;
    fabric.slivers += fabric.membraneScales[t] < 1.0 || bendsLess ? 1 : 0;
  }
  findPairs(model, fabric);
}

std::shared_ptr<const ClothModel> withBuilt(const ClothModel& model, std::shared_ptr<const Fabric> fabric) {
  std::vector<double> stiffness = stiffnessAtVertices(*fabric, model);
  return sim::withFabric(model, std::move(fabric), std::move(stiffness));
}

/// The loops over vertices take the material of one triangle for all of a vertex.
void requireOneMaterialPerVertex(const ClothModel& model, const TriangleMaterials& materials) {
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    for (const int t : model.vertexTriangles[v]) {
      if (materials.indexOf(t) != materials.indexOf(model.vertexTriangles[v].front())) {
        throw ClothModelError(ClothModelError::Fault::MaterialsMeet, {.index = static_cast<std::int64_t>(v)});
      }
    }
  }
}

/// @param model with the rest lengths and areas of the triangles at rest
std::shared_ptr<const ClothModel> withTriangles(const ClothModel& model, const TriangleMaterials& materials,
                                                std::vector<RestTriangle> rest, RestCurvature curvature,
                                                PatternMesh mesh) {
  if (!std::ranges::all_of(materials.list(), isStable)) {
    throw ClothModelError(ClothModelError::Fault::Material, {});
  }
  requireOneMaterialPerVertex(model, materials);
  auto fabric = std::make_shared<Fabric>();
  fabric->materials = materials;
  fabric->restCurvature = curvature;
  fabric->patternMesh = mesh;
  fabric->shape = restShapeOf(std::move(rest), model.triangles, edgesOf(model.triangles, model.restPositions.size()));
  if (model.hasPattern && mesh == PatternMesh::Strained) {
    fabric->meshStrain = meshStrain(model, fabric->shape.triangles);
  }
  std::ranges::transform(fabric->shape.triangles, std::back_inserter(fabric->membraneScales), stiffnessScaleOf);
  build(model, *fabric);
  return withBuilt(model, std::move(fabric));
}

}  // namespace

std::shared_ptr<const ClothModel> withFabric(const ClothModel& model, const TriangleMaterials& materials,
                                             std::span<const Vec3> warp, RestCurvature curvature) {
  if (warp.size() != model.triangles.size()) {
    throw ClothModelError(
        ClothModelError::Fault::WarpCount,
        {.found = static_cast<std::int64_t>(warp.size()), .count = static_cast<std::int64_t>(model.triangles.size())});
  }
  return withTriangles(*withMeshSizes(model), materials, restTrianglesOf(model.restPositions, model.triangles, warp),
                       curvature, PatternMesh::Strained);
}

std::shared_ptr<const ClothModel> withPatternFabric(const ClothModel& model, const TriangleMaterials& materials,
                                                    std::vector<RestTriangle> pattern, RestCurvature curvature,
                                                    PatternMesh mesh) {
  const std::shared_ptr<const ClothModel> sized = withPattern(model, pattern);
  return withTriangles(*sized, materials, std::move(pattern), curvature, mesh);
}

std::shared_ptr<const ClothModel> withStretchScales(const ClothModel& model, std::span<const double> scales) {
  auto fabric = std::make_shared<Fabric>(*model.fabric);
  auto scale = scales.begin();
  fabric->materials = fabric->materials.with([&](Material& material) {
    for (double* modulus :
         {&material.stretchWarp, &material.stretchWeft, &material.stiffeningWarp, &material.stiffeningWeft}) {
      *modulus *= *scale;
    }
    ++scale;
  });
  buildMembrane(*fabric);
  fabric->fingerprint = fingerprintOf(*fabric);
  return withBuilt(model, std::move(fabric));
}

std::shared_ptr<const ClothModel> withTighterRateLimit(const ClothModel& model, double maxRatio) {
  auto fabric = std::make_shared<Fabric>(*model.fabric);
  fabric->maxRatio = maxRatio;
  build(model, *fabric);
  const bool isEqual =
      fabric->membraneScales == model.fabric->membraneScales && fabric->bendingScales == model.fabric->bendingScales;
  return isEqual ? nullptr : withBuilt(model, std::move(fabric));
}

std::vector<double> strainsAlongYarns(const ClothModel& model, std::span<const Vec3> positions) {
  const Fabric& fabric = *model.fabric;
  std::vector<std::vector<double>> strains(fabric.materials.list().size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    if (fabric.shape.triangles[t].isBand) {
      continue;
    }
    const MembraneTriangle& membrane = fabric.membrane[t];
    const Vec3 strain = membrane.strain(membrane.excess(cornersOf(model.triangles[t], positions)));
    strains[fabric.materials.indexOf(t)].push_back(std::max({0.0, strain[0], strain[1]}));
  }
  std::vector<double> quantiles;
  std::ranges::transform(strains, std::back_inserter(quantiles),
                         [](std::vector<double>& values) { return quantileExceededBy(values, 100); });
  return quantiles;
}

std::vector<double> membraneStiffness(const ClothModel& model) {
  return sumAtVertices(model, cornerBlocks(membraneAtRest(*model.fabric, model.fabric->materials, model)));
}

std::vector<double> relativeStretchDamping(const ClothModel& model) {
  const TriangleMaterials& materials = model.fabric->materials;
  const double longest = materials.maxStretchDamping();
  std::vector<double> relative(model.restPositions.size(), 1.0);
  for (std::size_t v = 0; v < relative.size() && longest > 0.0; ++v) {
    if (!model.vertexTriangles[v].empty()) {
      relative[v] = materials[model.vertexTriangles[v].front()].stretchDamping / longest;
    }
  }
  return relative;
}

double minStretchModulus(const Material& material) {
  return std::min(material.stretchWarp, material.stretchWeft);
}

double minStretchModulus(const ClothModel& model) {
  const auto modulus = [](const Material& material) { return minStretchModulus(material); };
  return modulus(std::ranges::min(model.fabric->materials.list(), {}, modulus));
}

double elasticEnergy(const ClothModel& model, std::span<const Vec3> positions) {
  const Fabric& fabric = *model.fabric;
  double energy = 0.0;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    energy += fabric.membrane[t].energy(cornersOf(model.triangles[t], positions));
  }
  // The rows of the bending matrix sum to zero, so that differences of positions serve. They are more accurate.
  for (const VertexPair& pair : fabric.pairs) {
    energy -= 0.5 * pair.bending * (positions[pair.b] - positions[pair.a]).squaredNorm();
  }
  return fabric.restMoments.empty() ? energy : energy + fabric.restMoments.energy(positions);
}

Vec3 elasticForceOn(const ClothModel& model, std::span<const Vec3> positions, std::size_t vertex) {
  const Fabric& fabric = *model.fabric;
  Vec3 force = Vec3::Zero();
  for (const int t : model.vertexTriangles[vertex]) {
    const Triangle& triangle = model.triangles[t];
    const Vec3 tensions = fabric.membrane[t].tensions(cornersOf(triangle, positions));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3 pull = tensions[static_cast<Eigen::Index>(k)] * (positions[triangle[next]] - positions[triangle[k]]);
      force += triangle[k] == static_cast<int>(vertex) ? pull : Vec3(Vec3::Zero());
      force -= triangle[next] == static_cast<int>(vertex) ? pull : Vec3(Vec3::Zero());
    }
  }
  if (fabric.bends()) {
    for (VertexMatrix::InnerIterator entry(fabric.bending, static_cast<int>(vertex)); entry; ++entry) {
      force -= entry.value() * (positions[entry.col()] - positions[vertex]);
    }
  }
  return fabric.restMoments.empty() ? force : force + fabric.restMoments.forceOn(vertex, positions);
}

Mat3 stiffnessAt(const ClothModel& model, std::span<const Vec3> positions, std::size_t vertex,
                 ForceDerivative variant) {
  const Fabric& fabric = *model.fabric;
  Mat3 stiffness = Mat3::Zero();
  for (const int t : model.vertexTriangles[vertex]) {
    const Triangle& triangle = model.triangles[t];
    const Mat9 whole = fabric.membrane[t].derivative(cornersOf(triangle, positions), variant);
    for (Eigen::Index a = 0; a < 3; ++a) {
      for (Eigen::Index b = 0; b < 3; ++b) {
        const bool own = triangle[a] == static_cast<int>(vertex) && triangle[b] == static_cast<int>(vertex);
        stiffness += own ? Mat3(whole.block<3, 3>(3 * a, 3 * b)) : Mat3(Mat3::Zero());
      }
    }
  }
  if (fabric.bends()) {
    const int row = static_cast<int>(vertex);
    stiffness.diagonal().array() += fabric.bending.coeff(row, row);
  }
  return stiffness;
}

}  // namespace drape::sim::fabric
