#include "io/chained_index.hpp"
#include "io/mesh_import.hpp"
#include "io/mesh_outliers.hpp"
#include "io/mesh_summary.hpp"
#include "io/planar_uvs.hpp"
#include "io/short_edges.hpp"
#include "messages/error.hpp"
#include "sim/model/fingerprint.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace drape::io {
namespace {

/// Largest coordinate, so that squares and products of lengths stay finite.
constexpr double largestCoordinate = 1e30;

/// A triangle with a height below this share of the bounding box's diagonal has no reliable area in float coordinates.
constexpr double flatHeight = 1e-7;

/// In meshes of very many triangles, or of distant parts, only triangles below this share of the median edge are flat.
constexpr double flatHeightOfEdge = 1e-4;

/// Maximum welding distance as a share of the median edge.
constexpr double longestWeldOfEdge = 0.5;

/// Shorter edges, as a share of the median edge, are merged: such short springs need tiny time steps, and they are
/// modelling errors.
constexpr double shortestEdge = 1e-3;

/// Minimum size of cloth [m]; smaller files certainly use another unit.
constexpr double smallestCloth = 1e-3;

/// Larger meshes are not simulated [m]: no unit makes a garment or a body of them.
constexpr double largestMesh = 1e9;

/// The coordinate that is farthest from 0.
double largestOf(const Vec3& position) {
  Eigen::Index axis = 0;
  position.cwiseAbs().maxCoeff(&axis);
  return position[axis];
}

void requireUsable(const RawMesh& raw, const std::string& name, const ImportOptions& options) {
  if (!(options.metresPerUnit > 0.0) || !std::isfinite(options.metresPerUnit)) {
    throw messages::InputError(name + ": the unit of the mesh must be a positive number of metres.");
  }
  if (!(options.weldTolerance >= 0.0) || options.weldTolerance > 0.1) {
    throw messages::InputError(name + ": the weld tolerance must be between 0 and 0.1 of the mesh's diagonal.");
  }
  if (!raw.uvs.empty() && raw.uvs.size() != raw.positions.size()) {
    throw messages::InputError(name + ": there are " + std::to_string(raw.uvs.size()) + " texture coordinates for " +
                               std::to_string(raw.positions.size()) + " vertices. Export the mesh again.");
  }
  const int count = static_cast<int>(raw.positions.size());
  for (const Triangle& triangle : raw.triangles) {
    for (const int vertex : triangle) {
      if (vertex < 0 || vertex >= count) {
        throw messages::InputError(name + ": a face uses vertex " + std::to_string(vertex) + ", but there are only " +
                                   std::to_string(count) + ". Export the mesh again.");
      }
    }
  }
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (!raw.positions[i].allFinite()) {
      throw messages::InputError(name + ": the position of vertex " + std::to_string(i) +
                                 " is not a finite number. Repair or export the mesh again.");
    }
    if (raw.positions[i].cwiseAbs().maxCoeff() > largestCoordinate) {
      throw messages::InputError(name + ": a vertex has the coordinate " +
                                 fmt::format("{:.6g}", largestOf(raw.positions[i])) +
                                 ", which is far too large. Repair or export the mesh again.");
    }
  }
}

/// The bounding box of the vertices with faces.
struct Bounds {
  Vec3 min = Vec3::Constant(HUGE_VAL);
  Vec3 max = Vec3::Constant(-HUGE_VAL);

  [[nodiscard]] double diagonal() const { return (max - min).norm(); }
};

Bounds boundsOf(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  Bounds bounds;
  for (const Triangle& triangle : triangles) {
    for (const int vertex : triangle) {
      bounds.min = bounds.min.cwiseMin(positions[vertex]);
      bounds.max = bounds.max.cwiseMax(positions[vertex]);
    }
  }
  return bounds;
}

/// Points in the cells of a grid, in the order in which they were added.
class PointWelder {
 public:
  /// Merges points closer than `distance`. `origin` is a corner of the bounding box with that `diagonal`.
  PointWelder(Vec3 origin, double diagonal, double distance, std::size_t capacity)
      // Cells are much wider than the distance, so that most points find all candidates in their own cell.
      : origin_(std::move(origin)),
        distance_(distance),
        cell_(diagonal > 0.0 ? std::max(16.0 * distance, 1e-7 * diagonal) : 1.0),
        index_(capacity) {}

  /// The index of the first point within the distance, which is added when there is none.
  int weld(const Vec3& point) {
    const int found = find(point);
    if (found != ChainedIndex::none) {
      return found;
    }
    const int added = static_cast<int>(points_.size());
    points_.push_back(point);
    index_.insert(cellHash(cellOf(point)), added);
    return added;
  }

  std::vector<Vec3> takePoints() { return std::move(points_); }

 private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  [[nodiscard]] Cell cellOf(const Vec3& point) const {
    return ((point - origin_) / cell_).array().floor().cast<std::int64_t>();
  }

  static std::uint64_t cellHash(const Cell& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t coordinate : cell) {
      hash = sim::mixHash(hash, static_cast<std::uint64_t>(coordinate));
    }
    return hash;
  }

  [[nodiscard]] int find(const Vec3& point) const {
    const Cell low = cellOf(point - Vec3::Constant(distance_));
    const Cell high = cellOf(point + Vec3::Constant(distance_));
    int best = ChainedIndex::none;
    Cell cell;
    for (cell.z() = low.z(); cell.z() <= high.z(); ++cell.z()) {
      for (cell.y() = low.y(); cell.y() <= high.y(); ++cell.y()) {
        for (cell.x() = low.x(); cell.x() <= high.x(); ++cell.x()) {
          best = findInCell(cell, point, best);
        }
      }
    }
    return best;
  }

  /// The minimum of `best` and the first point of this cell that is close enough.
  [[nodiscard]] int findInCell(const Cell& cell, const Vec3& point, int best) const {
    for (int i = index_.first(cellHash(cell)); i != ChainedIndex::none; i = index_.next(i)) {
      if ((best == ChainedIndex::none || i < best) && (points_[i] - point).norm() <= distance_) {
        best = i;
      }
    }
    return best;
  }

  Vec3 origin_;
  double distance_;
  double cell_;
  ChainedIndex index_;
  std::vector<Vec3> points_;
};

/// The particle of each raw vertex.
struct Weld {
  std::vector<Vec3> positions;  ///< one per particle, in the file's unit
  std::vector<int> particle;    ///< one per raw vertex; -1 for a vertex without faces
};

/// Reference lengths of the tolerances, in the file's unit.
struct Scale {
  Bounds bounds;
  double medianEdge = 0.0;

  [[nodiscard]] double weldDistance(double tolerance) const {
    return std::min(tolerance * bounds.diagonal(), longestWeldOfEdge * medianEdge);
  }
  [[nodiscard]] double flat() const { return std::min(flatHeight * bounds.diagonal(), flatHeightOfEdge * medianEdge); }
};

Weld weldPositions(const RawMesh& raw, const Scale& scale, double tolerance) {
  std::vector<bool> used(raw.positions.size(), false);
  for (const Triangle& triangle : raw.triangles) {
    for (const int vertex : triangle) {
      used[vertex] = true;
    }
  }
  const double diagonal = scale.bounds.diagonal();
  PointWelder welder(scale.bounds.min, diagonal, scale.weldDistance(tolerance), raw.positions.size());
  Weld weld;
  weld.particle.assign(raw.positions.size(), -1);
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (used[i]) {
      weld.particle[i] = welder.weld(raw.positions[i]);
    }
  }
  weld.positions = welder.takePoints();
  return weld;
}

/// The remaining faces, with particle indices and with raw vertex indices.
struct Faces {
  std::vector<Triangle> particles;
  std::vector<Triangle> rawVertices;
};

bool isDegenerate(const Triangle& face, const std::vector<Vec3>& positions, double flat) {
  if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
    return true;
  }
  const Vec3 ab = positions[face[1]] - positions[face[0]];
  const Vec3 bc = positions[face[2]] - positions[face[1]];
  const Vec3 ca = positions[face[0]] - positions[face[2]];
  const double longest = std::sqrt(std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()}));
  return ab.cross(bc).norm() <= flat * longest;
}

Triangle sorted(Triangle face) {
  std::sort(face.begin(), face.end());
  return face;
}

Faces cleanFaces(const RawMesh& raw, const Weld& weld, double flat, MeshSummary& summary) {
  Faces kept;
  ChainedIndex index(raw.triangles.size());
  for (const Triangle& source : raw.triangles) {
    const Triangle face{weld.particle[source[0]], weld.particle[source[1]], weld.particle[source[2]]};
    if (isDegenerate(face, weld.positions, flat)) {
      ++summary.degenerateFaces;
      continue;
    }
    const Triangle key = sorted(face);
    std::uint64_t hash = 0;
    for (const int vertex : key) {
      hash = sim::mixHash(hash, static_cast<std::uint64_t>(vertex));
    }
    int same = index.first(hash);
    while (same != ChainedIndex::none && sorted(kept.particles[same]) != key) {
      same = index.next(same);
    }
    if (same != ChainedIndex::none) {
      ++summary.duplicateFaces;
      continue;
    }
    index.insert(hash, static_cast<int>(kept.particles.size()));
    kept.particles.push_back(face);
    kept.rawVertices.push_back(source);
  }
  return kept;
}

/// Drops particles without faces and renumbers the others in the same order.
void dropIsolated(Weld& weld, Faces& faces, MeshSummary& summary) {
  std::vector<int> newNumber(weld.positions.size(), -1);
  for (const Triangle& face : faces.particles) {
    for (const int particle : face) {
      newNumber[particle] = 0;
    }
  }
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < newNumber.size(); ++i) {
    if (newNumber[i] == 0) {
      newNumber[i] = static_cast<int>(positions.size());
      positions.push_back(weld.positions[i]);
    } else {
      ++summary.isolatedVertices;
    }
  }
  weld.positions = std::move(positions);
  for (int& particle : weld.particle) {
    // A raw vertex without a face also counts as isolated.
    summary.isolatedVertices += particle < 0 ? 1 : 0;
    particle = particle < 0 ? -1 : newNumber[particle];
  }
  for (Triangle& face : faces.particles) {
    for (int& particle : face) {
      particle = newNumber[particle];
    }
  }
}

/// The render vertices of a mesh with texture coordinates: one per pair of particle and coordinates.
RenderMesh renderMeshFromUvs(const RawMesh& raw, const Weld& weld, const Faces& faces) {
  RenderMesh render;
  ChainedIndex index(raw.positions.size());
  std::vector<int> renderVertex(raw.positions.size(), -1);
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    const int particle = weld.particle[i];
    if (particle < 0) {
      continue;
    }
    const Vec2 uv = raw.uvs[i].allFinite() ? raw.uvs[i] : Vec2(0.0, 0.0);
    std::uint64_t hash = sim::mixHash(0, static_cast<std::uint64_t>(particle));
    hash = sim::mixHash(hash, std::bit_cast<std::uint64_t>(uv.x()));
    hash = sim::mixHash(hash, std::bit_cast<std::uint64_t>(uv.y()));
    int same = index.first(hash);
    while (same != ChainedIndex::none && (render.particle[same] != particle || render.uvs[same] != uv)) {
      same = index.next(same);
    }
    if (same == ChainedIndex::none) {
      same = static_cast<int>(render.particle.size());
      index.insert(hash, same);
      render.particle.push_back(particle);
      render.uvs.push_back(uv);
    }
    renderVertex[i] = same;
  }
  for (const Triangle& source : faces.rawVertices) {
    render.triangles.push_back({renderVertex[source[0]], renderVertex[source[1]], renderVertex[source[2]]});
  }
  return render;
}

/// Removes the faces of outliers from the mesh, or throws when outliers are refused.
RawMesh withoutOutliers(const RawMesh& raw, const std::vector<int>& outliers, const std::string& name,
                        const ImportOptions& options) {
  std::vector<bool> isOutlier(raw.positions.size(), false);
  for (const int vertex : outliers) {
    isOutlier[vertex] = true;
  }
  RawMesh rest = raw;
  std::erase_if(rest.triangles, [&isOutlier](const Triangle& face) {
    return std::any_of(face.begin(), face.end(), [&isOutlier](int vertex) { return isOutlier[vertex]; });
  });
  if (options.outliers == OutlierRule::Refuse) {
    const Bounds bounds = boundsOf(rest.positions, rest.triangles);
    const Vec3& place = raw.positions[outliers.front()];
    const double away = (place - place.cwiseMax(bounds.min).cwiseMin(bounds.max)).norm() * options.metresPerUnit;
    const std::string others =
        outliers.size() == 1 ? "" : " (and " + std::to_string(outliers.size() - 1) + " more like it)";
    throw OutlierError("lies " + text::formatLength(away) + " from the rest of the mesh" + others +
                           ". Repair the mesh, or leave such vertices out with --set outliers=leave_out.",
                       outliers.front());
  }
  if (rest.triangles.size() * 2 < raw.triangles.size()) {
    throw messages::InputError(name + ": " + std::to_string(raw.triangles.size() - rest.triangles.size()) + " of its " +
                               std::to_string(raw.triangles.size()) +
                               " faces use a vertex that lies far from all others, so "
                               "most of the mesh would be left out. Repair the mesh.");
  }
  return rest;
}

/// Merges the ends of very short edges. Renumbers faces and particles; positions stay.
void repairShortEdges(double limit, Weld& weld, Faces& faces, MeshSummary& summary) {
  const ShortEdges edges = collapseShortEdges(weld.positions, faces.particles, limit);
  if (!edges.where) {
    return;
  }
  summary.shortEdges = edges.collapsed;
  summary.shortEdgesKept = edges.kept;
  summary.shortEdge = {edges.where->x(), edges.where->y(), edges.where->z()};
  for (int& particle : weld.particle) {
    particle = particle < 0 ? -1 : edges.replacement[particle];
  }
  Faces kept;
  for (std::size_t i = 0; i < faces.particles.size(); ++i) {
    Triangle face = faces.particles[i];
    for (int& particle : face) {
      particle = edges.replacement[particle];
    }
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) {
      kept.particles.push_back(face);
      kept.rawVertices.push_back(faces.rawVertices[i]);
    }
  }
  faces = std::move(kept);
}

void requireMostFaces(const RawMesh& raw, const MeshSummary& summary) {
  const auto dropped = static_cast<std::size_t>(summary.degenerateFaces);
  if (2 * dropped > raw.triangles.size()) {
    const std::string all = std::to_string(raw.triangles.size());
    throw messages::InputError(
        summary.source + ": " +
        (dropped == raw.triangles.size()
             ? "none of its " + all + " faces has an area."
             : std::to_string(dropped) + " of its " + all + " faces have no area, so most of the mesh would be lost.") +
        " Repair or export the mesh again, or lower weld_tolerance if it is not the default.");
  }
}

void requireVisibleSize(const MeshSummary& summary, const ImportOptions& options) {
  const double largest = *std::max_element(summary.size.begin(), summary.size.end());
  if (options.use == MeshUse::Cloth && largest < smallestCloth) {
    throw messages::InputError(summary.source + ": it is " + text::formatLength(largest) +
                               " large, and the minimum is 1 mm. Set the unit of the file (--set unit=...), or "
                               "scale the mesh to metres.");
  }
  if (largest > largestMesh) {
    throw messages::InputError(
        summary.source + ": it is " + text::formatLength(largest) +
        " large, and meshes above 1e+06 km are not simulated. Its coordinates are damaged, or it is in "
        "another unit (--set unit=...). Repair or export the mesh again.");
  }
}

/// The mesh as a file: the one that was read, or the raw mesh itself.
FileMesh fileMeshOf(const RawMesh& raw) {
  if (!raw.file.positions.empty()) {
    return raw.file;
  }
  FileMesh file;
  file.positions = raw.positions;
  file.uvs = raw.uvs;
  for (const Triangle& triangle : raw.triangles) {
    file.corners.insert(file.corners.end(), triangle.begin(), triangle.end());
    file.endFace();
  }
  if (!file.uvs.empty()) {
    file.uvCorners = file.corners;
  }
  return file;
}

/// The mesh of the file with the particle of each of its vertices.
std::shared_ptr<const FileMesh> fileMeshFor(const RawMesh& raw, const Weld& weld) {
  auto file = std::make_shared<FileMesh>(fileMeshOf(raw));
  if (raw.file.positions.empty()) {
    file->particle = weld.particle;
    return file;
  }
  for (const int vertex : verticesInLibrary(*file, raw.positions)) {
    file->particle.push_back(vertex < 0 ? -1 : weld.particle[vertex]);
  }
  return file;
}

}  // namespace

ImportedMesh weldMesh(const RawMesh& source, std::string_view nameView, const ImportOptions& options) {
  const std::string name(nameView);
  requireUsable(source, name, options);
  if (source.triangles.empty()) {
    throw messages::InputError(name + ": there are no faces in it" +
                               (source.facesSkipped > 0 ? " but lines and points. " : ". ") +
                               "A cloth needs a mesh of triangles or polygons.");
  }
  ImportedMesh mesh;
  mesh.summary.source = name;
  mesh.summary.verticesInFile = static_cast<int>(source.positions.size());
  mesh.summary.facesSkipped = source.facesSkipped;
  const std::vector<int> outliers = findOutliers(source.positions, source.triangles);
  mesh.summary.outliers = static_cast<int>(outliers.size());
  const RawMesh cleaned = outliers.empty() ? RawMesh{} : withoutOutliers(source, outliers, name, options);
  const RawMesh& raw = outliers.empty() ? source : cleaned;
  const Scale scale{boundsOf(raw.positions, raw.triangles), medianEdge(raw.positions, raw.triangles)};
  options.watch.tell(0.3, "Joining vertices");
  Weld weld = weldPositions(raw, scale, options.weldTolerance);
  options.watch.tell(0.5, "Joining vertices");
  Faces faces = cleanFaces(raw, weld, scale.flat(), mesh.summary);
  requireMostFaces(raw, mesh.summary);
  if (options.use == MeshUse::Cloth) {  // a body has no edges that need short time steps
    repairShortEdges(shortestEdge * scale.medianEdge, weld, faces, mesh.summary);
  }
  dropIsolated(weld, faces, mesh.summary);
  mesh.summary.isolatedVertices += raw.unusedVertices - mesh.summary.outliers - mesh.summary.shortEdges;
  for (Vec3& position : weld.positions) {
    position *= options.metresPerUnit;
  }
  mesh.cloth.positions = weld.positions;
  mesh.cloth.triangles = faces.particles;
  options.watch.tell(0.7, "Joining vertices");
  mesh.render = raw.uvs.empty() ? renderMeshFromPlanes(mesh.cloth) : renderMeshFromUvs(raw, weld, faces);
  if (options.use == MeshUse::Cloth || options.keepsFile) {
    mesh.file = fileMeshFor(source, weld);
  }
  options.watch.tell(0.8, "Measuring");
  summarise(mesh.cloth, options.use, mesh.summary);
  requireVisibleSize(mesh.summary, options);
  return mesh;
}

}  // namespace drape::io
