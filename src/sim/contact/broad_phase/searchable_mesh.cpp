#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/model/enclosed_volume.hpp"
#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr double sharpAngle = 0.02;  // an edge is sharp if the sine of its convex angle is above this [-]

std::vector<std::array<bool, 3>> sharpSides(const MeshShape& mesh) {
  std::vector<std::array<bool, 3>> sharp(mesh.triangles.size(), {true, true, true});
  if (mesh.deforms()) {
    return sharp;  // any edge of a deforming mesh may become sharp
  }
  const MeshEdges topology = edgesOf(mesh.triangles, mesh.positions.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.onBoundary(e)) {
      continue;
    }
    // Of the triangles of a non-manifold edge, the last two count.
    const std::span<const TriangleSide> sides = topology.sides[e].last(2);
    const Triangle& other = mesh.triangles[sides[1].triangle];
    const Corners first = cornersOf(mesh.positions, mesh.triangles[sides[0].triangle]);
    const Vec3 apex = mesh.positions[other[(sides[1].corner + 2) % 3]] - mesh.positions[topology.edges[e].a];
    const double rise = faceNormal(first).dot(apex);
    const bool flat = rise > -sharpAngle * apex.norm();
    sharp[sides[0].triangle][sides[0].corner] = !flat;
    sharp[sides[1].triangle][sides[1].corner] = !flat;
  }
  return sharp;
}

bool isClosed(const MeshShape& mesh) {
  const MeshEdges topology = edgesOf(mesh.triangles, mesh.positions.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const TriangleSide> sides = topology.sides[e];
    const auto ascending = std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.ascending; });
    if (2 * static_cast<std::size_t>(ascending) != sides.size()) {
      return false;
    }
  }
  return !topology.edges.empty();
}

/// Flips the triangles of a closed mesh if they face inwards.
MeshShape facingOutwards(MeshShape mesh) {
  const double volume =
      mesh.positions.empty() ? 0.0 : enclosedVolume(mesh.positions, mesh.triangles, mesh.positions.front());
  if (volume < 0.0 && isClosed(mesh)) {
    for (Triangle& t : mesh.triangles) {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

/// @param vertexOf the vertex of a lane, or -1 for one at infinity
template <typename VertexOf>
void fill(LeafLanes& lanes, std::size_t count, VertexOf&& vertexOf, std::span<const Vec3> positions) {
  lanes.x.resize(count);
  lanes.y.resize(count);
  lanes.z.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int vertex = vertexOf(i);
    const Vec3 position =
        vertex >= 0 ? vectorAt(positions, vertex) : Vec3(Vec3::Constant(std::numeric_limits<double>::infinity()));
    lanes.x[i] = position.x();
    lanes.y[i] = position.y();
    lanes.z[i] = position.z();
  }
}

}  // namespace

SearchableMesh::SearchableMesh(MeshShape mesh)
    : shape(facingOutwards(std::move(mesh))),
      closed(isClosed(shape)),
      tree(shape.positions, shape.triangles, trianglesPerLeaf),
      owned(ownedFeatures(shape.triangles, shape.positions.size())),
      sharp(sharpSides(shape)) {
  gatherLeaves();
  fill(shape.positions, start_);
}

void SearchableMesh::fill(std::span<const Vec3> positions, Geometry& geometry) const {
  contact::fill(
      geometry.points, leafVertices_.size(), [&](std::size_t i) { return leafVertices_[i]; }, positions);
  fillEdges(positions, geometry.edges);
  fillBoxes(positions, geometry.boxes);
}

void SearchableMesh::fillBoxes(std::span<const Vec3> positions, std::vector<TriangleBoxes>& boxes) const {
  boxes.resize(tree.leafCount());
  for (std::size_t leaf = 0; leaf < boxes.size(); ++leaf) {
    const std::span<const int> triangles = tree.leaf(leaf);
    for (std::size_t k = 0; k < trianglesPerLeaf; ++k) {
      Eigen::AlignedBox3d box;
      if (k < triangles.size()) {
        for (const int v : shape.triangles[triangles[k]]) {
          box.extend(vectorAt(positions, v));
        }
      } else {
        box.min().setConstant(std::numeric_limits<double>::infinity());
        box.max() = -box.min();
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes[leaf].low[axis][k] = box.min()[static_cast<Eigen::Index>(axis)];
        boxes[leaf].high[axis][k] = box.max()[static_cast<Eigen::Index>(axis)];
      }
    }
  }
}

void SearchableMesh::fillEdges(std::span<const Vec3> positions, EdgeLanes& edges) const {
  contact::fill(
      edges.from, leafEdges_.size(), [&](std::size_t i) { return leafEdges_[i][0]; }, positions);
  contact::fill(
      edges.to, leafEdges_.size(), [&](std::size_t i) { return leafEdges_[i][1]; }, positions);
}

void SearchableMesh::gatherLeaves() {
  vertexBegin_.push_back(0);
  edgeBegin_.push_back(0);
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    gatherPoints(tree.leaf(leaf));
    gatherEdges(tree.leaf(leaf));
    vertexBegin_.push_back(leafVertices_.size());
    edgeBegin_.push_back(leafEdges_.size());
  }
  vertexFeatures_.resize(leafVertices_.size());
}

/// Adds the vertices of a leaf, those that it owns first.
void SearchableMesh::gatherPoints(std::span<const int> triangles) {
  const std::size_t begin = leafVertices_.size();
  vertexFeatures_.resize(begin);
  for (const bool own : {true, false}) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const int t = triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = shape.triangles[t][k];
        const auto first = leafVertices_.begin() + static_cast<std::ptrdiff_t>(begin);
        if (owned[t].corners[k] == own && (own || std::find(first, leafVertices_.end(), v) == leafVertices_.end())) {
          leafVertices_.push_back(v);
          if (own) {
            vertexFeatures_.push_back({triangles[i], k, static_cast<int>(i)});
          }
        }
      }
    }
  }
  ownPoints_.push_back(static_cast<std::uint32_t>(vertexFeatures_.size() - begin));
  while ((leafVertices_.size() - begin) % maxDoubles != 0) {
    leafVertices_.push_back(leafVertices_.back());
  }
}

/// Adds the sharp edges that a leaf owns.
void SearchableMesh::gatherEdges(std::span<const int> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int t = triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (owned[t].sides[k] && sharp[t][k]) {
        leafEdges_.push_back({shape.triangles[t][k], shape.triangles[t][(k + 1) % 3]});
        edgeFeatures_.push_back({triangles[i], k, static_cast<int>(i)});
      }
    }
  }
  while (leafEdges_.size() % maxDoubles != 0) {
    leafEdges_.push_back({-1, -1});
    edgeFeatures_.emplace_back();
  }
}

void SearchableMesh::follow(std::span<const Vec3> before, std::span<const Vec3> after) {
  if (std::ranges::equal(after, after_) && std::ranges::equal(before, before_)) {
    return;
  }
  ++version_;
  if (std::ranges::equal(before, after_)) {
    std::swap(start_, end_);
  } else {
    fill(before, start_);
  }
  fill(after, end_);
  before_.assign(before.begin(), before.end());
  after_.assign(after.begin(), after.end());
  tree.refit(before, after, shape.triangles);
  measureMoves();
}

void SearchableMesh::measureMoves() {
  moves_.assign(tree.leafCount(), 0.0);
  for (std::size_t leaf = 0; leaf < moves_.size(); ++leaf) {
    double largest = 0.0;  // squared
    for (std::size_t i = vertexBegin_[leaf]; i < vertexBegin_[leaf + 1]; ++i) {
      const int v = leafVertices_[i];
      largest = std::max(largest, (after_[v] - before_[v]).squaredNorm());
    }
    moves_[leaf] = std::sqrt(largest);
  }
}

int SearchableMesh::supportVertex(const Vec3& direction, std::size_t leaf, bool atEnd) const {
  const LeafLanes& at = geometry(atEnd).points;
  double maxHeight = -std::numeric_limits<double>::infinity();
  std::size_t index = vertexBegin_[leaf];
  for (std::size_t i = vertexBegin_[leaf]; i < vertexBegin_[leaf + 1]; ++i) {
    const double along = direction.x() * at.x[i] + direction.y() * at.y[i] + direction.z() * at.z[i];
    if (along > maxHeight) {
      maxHeight = along;
      index = i;
    }
  }
  return leafVertices_[index];
}

}  // namespace drape::sim::contact
