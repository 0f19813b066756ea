#include "fabrics/presets.hpp"
#include "io/garments/garments.hpp"
#include "report/validation/cases.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/measures/equilibrium.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace drape::report::validation {
namespace {

/// The skirt of the built-in scenes, hung by its waist.
struct HungSkirt {
  std::vector<Vec3> positions;  // [m]
  std::vector<Triangle> triangles;
  std::vector<int> hem;  // vertices
  bool converged = false;
};

/// The triangles of the skirt's pattern, with warp along V.
std::vector<sim::fabric::RestTriangle> patternOf(const io::RenderMesh& render) {
  std::vector<sim::fabric::RestTriangle> pattern;
  for (const Triangle& triangle : render.triangles) {
    std::array<Vec2, 3> corners;
    std::ranges::transform(triangle, corners.begin(),
                           [&](int corner) { return Vec2(render.uvs[corner].y(), render.uvs[corner].x()); });
    pattern.push_back(sim::fabric::restTriangleOf(corners));
  }
  return pattern;
}

/// @param cells from waist to hem
HungSkirt hungSkirt(int cells, const CaseMesh& mesh) {
  constexpr double gravity = 9.81;  // [m/s^2]
  constexpr double length = 0.695;  // from waist to hem [m]
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  const io::ImportedMesh skirt = io::weldMesh(io::makeSkirtOfEdges(length / cells), "skirt", {});
  std::vector<int> waist;
  HungSkirt hung{.positions = {}, .triangles = skirt.cloth.triangles, .hem = {}};
  for (int vertex = 0; vertex < static_cast<int>(skirt.cloth.positions.size()); ++vertex) {
    const double height = skirt.cloth.positions[vertex].y();
    constexpr double rounding = 1e-6;  // [m]
    if (height > io::garment::waistHeight - rounding) {
      waist.push_back(vertex);
    }
    if (height < io::garment::hemHeight + rounding) {
      hung.hem.push_back(vertex);
    }
  }
  const auto springs =
      sim::buildClothModel(skirt.cloth, preset.density * sim::restAreaOf(skirt.cloth), sim::MassLumping::Area, waist);
  const auto model = sim::fabric::withPatternFabric(*springs, preset.material, patternOf(skirt.render));
  // The height needs no better equilibrium: the search takes minutes to settle the last folds.
  constexpr sim::EquilibriumOptions options{.tolerance = 1e-3, .maxIterations = 800};
  sim::Equilibrium found =
      sim::equilibriumUnder(*model, sim::weightsOf(*model, gravity), model->restPositions, options, mesh.stop);
  hung.positions = std::move(found.positions);
  hung.converged = found.converged;
  return hung;
}

/// The mean height of the skirt, from waist to hem [m].
double heightOf(const HungSkirt& hung) {
  double height = hung.converged ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (const int vertex : hung.hem) {
    height += (io::garment::waistHeight - hung.positions[vertex].y()) / static_cast<double>(hung.hem.size());
  }
  return height;
}

}  // namespace

Comparison remeshedSkirt(const CaseMesh& mesh) {
  constexpr int once = 10;
  return {.measured = heightOf(hungSkirt(mesh.resolution, mesh)), .exact = heightOf(hungSkirt(once, mesh))};
}

}  // namespace drape::report::validation
