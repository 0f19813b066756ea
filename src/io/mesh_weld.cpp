#include "io/chained_index.hpp"
#include "io/mesh_import.hpp"
#include "io/mesh_summary.hpp"
#include "io/mesh_topology.hpp"
#include "io/planar_uvs.hpp"
#include "sim/error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace drape {
namespace {

/// No coordinate may be larger, so that squares and products of lengths stay finite.
constexpr double largestCoordinate = 1e30;

/// A triangle lower than this part of the bounding box's diagonal has no area that float coordinates could tell from 0.
constexpr double flatHeight = 1e-7;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

void requireUsable(const RawMesh& raw, const std::string& name, const ImportOptions& options) {
  if (!(options.metresPerUnit > 0.0) || !std::isfinite(options.metresPerUnit)) {
    throw InputError(name + ": the size of the mesh's unit must be a positive number of metres.");
  }
  if (!(options.weldTolerance >= 0.0) || options.weldTolerance > 0.1) {
    throw InputError(name + ": the weld tolerance must be between 0 and 0.1 of the mesh's diagonal.");
  }
  if (!raw.uvs.empty() && raw.uvs.size() != raw.positions.size()) {
    throw InputError(name + ": there are " + std::to_string(raw.uvs.size()) + " texture coordinates for " +
                     std::to_string(raw.positions.size()) + " vertices. Export the mesh again.");
  }
  const int count = static_cast<int>(raw.positions.size());
  for (const Triangle& triangle : raw.triangles) {
    for (const int vertex : triangle) {
      if (vertex < 0 || vertex >= count) {
        throw InputError(name + ": a face uses vertex " + std::to_string(vertex) + ", but there are only " +
                         std::to_string(count) + ". Export the mesh again.");
      }
    }
  }
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (!(raw.positions[i].cwiseAbs().maxCoeff() <= largestCoordinate) || !raw.positions[i].allFinite()) {
      throw InputError(name + ": the position of vertex " + std::to_string(i) +
                       " is not a finite number or far too large. Repair or export the mesh again.");
    }
  }
}

/// The box around the vertices that faces use.
struct Bounds {
  Vec3 min = Vec3::Constant(HUGE_VAL);
  Vec3 max = Vec3::Constant(-HUGE_VAL);

  [[nodiscard]] double diagonal() const { return (max - min).norm(); }
};

Bounds boundsOf(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  Bounds bounds;
  for (const Triangle& triangle : triangles) {
    for (const int vertex : triangle) {
      bounds.min = bounds.min.cwiseMin(positions[at(vertex)]);
      bounds.max = bounds.max.cwiseMax(positions[at(vertex)]);
    }
  }
  return bounds;
}

/// Points filed in the cells of a grid, in the order in which they were first seen.
class PointWelder {
 public:
  /// Points nearer than `distance` are one; `origin` is the corner of a box of that `diagonal` that holds them all.
  PointWelder(Vec3 origin, double diagonal, double distance, std::size_t capacity)
      // Cells much wider than the distance: most points then have all their candidates in their own cell.
      : origin_(std::move(origin)),
        distance_(distance),
        cell_(diagonal > 0.0 ? std::max(16.0 * distance, 1e-7 * diagonal) : 1.0),
        index_(capacity) {}

  /// The number of the first point within the distance of this one, which is added when there is none.
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
      hash = mixHash(hash, static_cast<std::uint64_t>(coordinate));
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

  /// The smaller of `best` and the first point of this cell that is near enough.
  [[nodiscard]] int findInCell(const Cell& cell, const Vec3& point, int best) const {
    for (int i = index_.first(cellHash(cell)); i != ChainedIndex::none; i = index_.next(i)) {
      if ((best == ChainedIndex::none || i < best) && (points_[at(i)] - point).norm() <= distance_) {
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

/// Which raw vertices are one particle.
struct Weld {
  std::vector<Vec3> positions;  ///< one a particle, in the file's unit
  std::vector<int> particle;    ///< one a raw vertex; -1 for a vertex that no face uses
};

Weld weldPositions(const RawMesh& raw, const Bounds& bounds, double tolerance) {
  std::vector<bool> used(raw.positions.size(), false);
  for (const Triangle& triangle : raw.triangles) {
    for (const int vertex : triangle) {
      used[at(vertex)] = true;
    }
  }
  const double diagonal = bounds.diagonal();
  PointWelder welder(bounds.min, diagonal, tolerance * diagonal, raw.positions.size());
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

/// The faces that are kept: as particles, and as the raw vertices they come from.
struct Faces {
  std::vector<Triangle> particles;
  std::vector<Triangle> rawVertices;
};

bool isDegenerate(const Triangle& face, const std::vector<Vec3>& positions, double flat) {
  if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
    return true;
  }
  const Vec3 ab = positions[at(face[1])] - positions[at(face[0])];
  const Vec3 bc = positions[at(face[2])] - positions[at(face[1])];
  const Vec3 ca = positions[at(face[0])] - positions[at(face[2])];
  const double longest = std::sqrt(std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()}));
  return ab.cross(bc).norm() <= flat * longest;
}

Triangle sorted(Triangle face) {
  std::sort(face.begin(), face.end());
  return face;
}

Faces cleanFaces(const RawMesh& raw, const Weld& weld, double diagonal, MeshSummary& summary) {
  Faces kept;
  ChainedIndex index(raw.triangles.size());
  for (const Triangle& source : raw.triangles) {
    const Triangle face{weld.particle[at(source[0])], weld.particle[at(source[1])], weld.particle[at(source[2])]};
    if (isDegenerate(face, weld.positions, flatHeight * diagonal)) {
      ++summary.degenerateFaces;
      continue;
    }
    const Triangle key = sorted(face);
    std::uint64_t hash = 0;
    for (const int vertex : key) {
      hash = mixHash(hash, static_cast<std::uint64_t>(vertex));
    }
    int same = index.first(hash);
    while (same != ChainedIndex::none && sorted(kept.particles[at(same)]) != key) {
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

/// Leaves out the particles that lost all their faces and numbers the others anew, in the same order.
void dropIsolated(Weld& weld, Faces& faces, MeshSummary& summary) {
  std::vector<int> newNumber(weld.positions.size(), -1);
  for (const Triangle& face : faces.particles) {
    for (const int particle : face) {
      newNumber[at(particle)] = 0;
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
    // A raw vertex without a face counts as isolated too.
    summary.isolatedVertices += particle < 0 ? 1 : 0;
    particle = particle < 0 ? -1 : newNumber[at(particle)];
  }
  for (Triangle& face : faces.particles) {
    for (int& particle : face) {
      particle = newNumber[at(particle)];
    }
  }
}

/// Render vertices of a mesh with texture coordinates: one for each pair of particle and coordinates.
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
    std::uint64_t hash = mixHash(0, static_cast<std::uint64_t>(particle));
    hash = mixHash(hash, std::bit_cast<std::uint64_t>(uv.x()));
    hash = mixHash(hash, std::bit_cast<std::uint64_t>(uv.y()));
    int same = index.first(hash);
    while (same != ChainedIndex::none && (render.particle[at(same)] != particle || render.uvs[at(same)] != uv)) {
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
    render.triangles.push_back({renderVertex[at(source[0])], renderVertex[at(source[1])], renderVertex[at(source[2])]});
  }
  return render;
}

}  // namespace

ImportedMesh weldMesh(const RawMesh& raw, std::string_view nameView, const ImportOptions& options) {
  const std::string name(nameView);
  requireUsable(raw, name, options);
  if (raw.triangles.empty()) {
    throw InputError(name + ": there are no faces in it" + (raw.facesSkipped > 0 ? " but lines and points. " : ". ") +
                     "A cloth needs a mesh of triangles or polygons.");
  }
  ImportedMesh mesh;
  mesh.summary.source = name;
  mesh.summary.verticesInFile = static_cast<int>(raw.positions.size());
  mesh.summary.facesSkipped = raw.facesSkipped;
  const Bounds bounds = boundsOf(raw.positions, raw.triangles);
  Weld weld = weldPositions(raw, bounds, options.weldTolerance);
  Faces faces = cleanFaces(raw, weld, bounds.diagonal(), mesh.summary);
  if (faces.particles.empty()) {
    throw InputError(name + ": none of its " + std::to_string(raw.triangles.size()) +
                     " faces has an area. Repair or export the mesh again.");
  }
  dropIsolated(weld, faces, mesh.summary);
  for (Vec3& position : weld.positions) {
    position *= options.metresPerUnit;
  }
  mesh.cloth.positions = weld.positions;
  mesh.cloth.triangles = faces.particles;
  mesh.render = raw.uvs.empty() ? renderMeshFromPlanes(mesh.cloth) : renderMeshFromUvs(raw, weld, faces);
  summarise(mesh.cloth, mesh.summary);
  return mesh;
}

}  // namespace drape
