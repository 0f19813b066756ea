#include "io/mesh_summary.hpp"

#include "io/topology_counts.hpp"
#include "sim/model/bounds.hpp"

#include <fmt/core.h>
#include <algorithm>

namespace drape::io {
namespace {

std::string counted(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void warnAboutFaces(MeshSummary& summary) {
  if (summary.degenerateFaces > 0) {
    summary.warnings.push_back(counted(summary.degenerateFaces, "face has", "faces have") + " no area: left out.");
  }
  if (summary.duplicateFaces > 0) {
    summary.warnings.push_back(counted(summary.duplicateFaces, "face repeats", "faces repeat") +
                               " the vertices of another: left out.");
  }
  if (summary.facesSkipped > 0) {
    summary.warnings.push_back(counted(summary.facesSkipped, "point or line", "points and lines") +
                               " in the file: left out.");
  }
  if (summary.isolatedVertices > 0) {
    summary.warnings.push_back(counted(summary.isolatedVertices, "vertex belongs", "vertices belong") +
                               " to no face: left out.");
  }
  if (summary.outliers > 0) {
    summary.warnings.push_back(counted(summary.outliers, "vertex lies", "vertices lie") +
                               " far from all others: left out, with the faces that use it.");
  }
}

void warnAboutShortEdges(MeshSummary& summary) {
  const auto& [x, y, z] = summary.shortEdge;
  const std::string place = fmt::format("({:.6g}, {:.6g}, {:.6g})", x, y, z);
  if (summary.shortEdges > 0) {
    summary.warnings.push_back(counted(summary.shortEdges, "edge was", "edges were") +
                               " less than a thousandth of the median edge long (slivers): merged to one vertex each. "
                               "The shortest is at " +
                               place + " in the file.");
  }
  if (summary.shortEdgesKept > 0) {
    summary.warnings.push_back(counted(summary.shortEdgesKept, "edge is", "edges are") +
                               " less than a thousandth of the median edge long and cannot be merged; they need small "
                               "time steps. Repair the mesh near " +
                               place + " (in the file's coordinates).");
  }
}

void warnAboutTopology(MeshUse use, MeshSummary& summary) {
  if (summary.nonManifoldEdges > 0) {
    summary.warnings.push_back(counted(summary.nonManifoldEdges, "edge has", "edges have") +
                               " more than two faces (layers sewn together?): simulated as it is.");
  }
  if (summary.misorientedEdges > 0) {
    summary.warnings.push_back("Across " + counted(summary.misorientedEdges, "edge", "edges") +
                               " the faces point to opposite sides: " +
                               (use == MeshUse::Body ? "the mesh counts as open, so cloth inside it stays there."
                                                     : "shading and wind may look wrong there."));
  }
  if (use == MeshUse::Cloth && summary.components > 1) {
    summary.warnings.push_back("It has " + std::to_string(summary.components) + std::string(piecesNeedPins));
  }
}

}  // namespace

void summarise(const sim::ClothMesh& cloth, MeshUse use, MeshSummary& summary) {
  const TopologyCounts topology = countTopology(cloth.positions.size(), cloth.triangles);
  summary.vertices = static_cast<int>(cloth.positions.size());
  summary.triangles = static_cast<int>(cloth.triangles.size());
  summary.springs = topology.edges;
  summary.components = topology.components;
  summary.boundaryLoops = topology.boundaryLoops;
  summary.nonManifoldEdges = topology.nonManifoldEdges;
  summary.misorientedEdges = topology.misorientedEdges;
  const Vec3 size = sim::boundsOf(cloth.positions).sizes();
  summary.size = {size.x(), size.y(), size.z()};
  warnAboutFaces(summary);
  warnAboutShortEdges(summary);
  warnAboutTopology(use, summary);
}

std::vector<MeshFact> factsOf(const MeshSummary& summary) {
  using text::Sentence;
  const Sentence borders(text::plural(summary.boundaryLoops, "{} open border", "{} open borders"),
                         summary.boundaryLoops);
  const Sentence vertices = summary.vertices == summary.verticesInFile
                                ? Sentence::verbatim(std::to_string(summary.vertices))
                                : Sentence("{} ({} as read from the file)", summary.vertices, summary.verticesInFile);
  return {{"mesh", Sentence::verbatim(summary.source)},
          {"vertices", vertices},
          {"triangles", Sentence::verbatim(std::to_string(summary.triangles))},
          {"springs", Sentence::verbatim(std::to_string(summary.springs))},
          {"pieces", Sentence("{}, with {}", summary.components, borders)},
          {"size", Sentence("{} m (width x height x depth)", fmt::format("{:.3g} x {:.3g} x {:.3g}", summary.size[0],
                                                                         summary.size[1], summary.size[2]))}};
}

std::vector<std::string> describe(const MeshSummary& summary) {
  std::vector<std::string> lines;
  for (const MeshFact& fact : factsOf(summary)) {
    lines.push_back(fmt::format("{:<13}{}", std::string(fact.title) + ':', fact.value.english()));
  }
  return lines;
}

}  // namespace drape::io
