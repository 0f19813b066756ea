#include "scene/pattern_uvs.hpp"

#include "sim/model/mesh_topology.hpp"

#include <fmt/core.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drape::scene {
namespace {

/// A texture triangle whose height is below this share of its longest side has no direction: files have 6 digits.
constexpr double minTextureHeight = 1e-5;
/// The same at rest.
constexpr double minRestHeight = 1e-9;

/// Two sides of a triangle at rest, in its own plane.
Eigen::Matrix2d sidesInPlane(const Vec3& first, const Vec3& second) {
  const double length = first.norm();
  const double along = second.dot(first) / length;
  Eigen::Matrix2d sides;
  sides << length, along, 0.0, first.cross(second).norm() / length;
  return sides;
}

/// How much longer the texture is in one direction than across, at least 1 [-].
double stretchOf(const std::array<Vec2, 3>& corners, const Eigen::Matrix2d& atRest) {
  Eigen::Matrix2d inTexture;
  inTexture << corners[1] - corners[0], corners[2] - corners[0];
  const Eigen::Matrix2d map = inTexture * atRest.inverse();
  const double squares = map.squaredNorm();
  const double area = std::abs(map.determinant());
  const double larger = 0.5 * (squares + std::sqrt(std::max(0.0, squares * squares - 4.0 * area * area)));
  return larger / area;
}

/// The triangles that are turned over against the larger part of their piece of the texture.
std::vector<int> mirroredTriangles(const io::RenderMesh& mesh, const PatternUvs& uvs) {
  const sim::ConnectedComponents pieces = sim::componentsOf(mesh.triangles, mesh.uvs.size());
  const auto pieceOf = [&](std::size_t t) { return pieces.componentOf[mesh.triangles[t][0]]; };
  std::vector<double> areas(pieces.count(), 0.0);
  for (std::size_t t = 0; t < uvs.corners.size(); ++t) {
    areas[pieceOf(t)] += twiceArea(uvs.corners[t]);
  }
  std::vector<int> mirrored;
  for (std::size_t t = 0; t < uvs.corners.size(); ++t) {
    if (twiceArea(uvs.corners[t]) * areas[pieceOf(t)] < 0.0) {
      mirrored.push_back(static_cast<int>(t));
    }
  }
  return mirrored;
}

/// "12 triangles (the first are 3, 4, 5)".
text::Sentence countAndFirst(const std::vector<int>& triangles) {
  constexpr std::size_t shown = 3;
  if (triangles.size() == 1) {
    return text::Sentence("1 triangle (number {})", triangles[0]);
  }
  std::string first;
  for (std::size_t i = 0; i < std::min(shown, triangles.size()); ++i) {
    first += (i == 0 ? "" : ", ") + std::to_string(triangles[i]);
  }
  return text::Sentence("{} triangles (numbers {}{})", triangles.size(), first,
                        triangles.size() > shown ? ", ..." : "");
}

}  // namespace

double twiceArea(const std::array<Vec2, 3>& corners) {
  const Vec2 first = corners[1] - corners[0];
  const Vec2 second = corners[2] - corners[0];
  const double longest = std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()});
  const double twice = first.x() * second.y() - first.y() * second.x();
  return std::abs(twice) > minTextureHeight * longest ? twice : 0.0;
}

bool PatternUvs::isPattern() const {
  constexpr double maxDistorted = 0.1;  // a pattern is eased into a sleeve, but not stretched everywhere
  return usable() && distorted <= maxDistorted;
}

PatternUvs patternUvsOf(const io::RenderMesh& mesh, std::span<const Vec3> rest) {
  PatternUvs uvs;
  if (mesh.uvsInMetres || mesh.uvs.size() != mesh.particle.size()) {
    return uvs;
  }
  double area = 0.0;
  double distorted = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle;
    uvs.corners.push_back({mesh.uvs[a], mesh.uvs[b], mesh.uvs[c]});
    const Vec3 first = rest[mesh.particle[b]] - rest[mesh.particle[a]];
    const Vec3 second = rest[mesh.particle[c]] - rest[mesh.particle[a]];
    const double own = 0.5 * first.cross(second).norm();
    uvs.area += 0.5 * std::abs(twiceArea(uvs.corners.back()));
    uvs.meshArea += own;
    if (twiceArea(uvs.corners.back()) == 0.0) {
      uvs.degenerate.push_back(static_cast<int>(uvs.corners.size()) - 1);
    } else if (own > minRestHeight * std::max(first.squaredNorm(), second.squaredNorm())) {
      area += own;
      distorted += stretchOf(uvs.corners.back(), sidesInPlane(first, second)) > maxPatternStretch ? own : 0.0;
    }
  }
  uvs.mirrored = mirroredTriangles(mesh, uvs);
  uvs.distorted = area > 0.0 ? distorted / area : 0.0;
  return uvs;
}

std::vector<Vec3> warpAlongV(const PatternUvs& uvs, std::span<const Vec3> rest, std::span<const Triangle> triangles) {
  std::vector<Vec3> warp;
  warp.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Vec3 first = rest[b] - rest[a];
    const Vec3 second = rest[c] - rest[a];
    const double twice = twiceArea(uvs.corners[t]);
    const bool flat = first.cross(second).norm() > minRestHeight * std::max(first.squaredNorm(), second.squaredNorm());
    if (twice == 0.0 || !flat) {
      warp.emplace_back(Vec3::Zero());
      continue;
    }
    // The combination of two sides along which U does not change.
    const double ofFirst = uvs.corners[t][2].x() - uvs.corners[t][0].x();
    const double ofSecond = uvs.corners[t][1].x() - uvs.corners[t][0].x();
    const Vec3 direction = ofSecond * second - ofFirst * first;
    warp.emplace_back((twice > 0.0 ? 1.0 : -1.0) * direction.normalized());
  }
  return warp;
}

text::Sentence problemOf(const PatternUvs& uvs) {
  if (!uvs.present()) {
    return text::Sentence(uvs.ofGrid ? "a grid has no texture coordinates (UVs) of a pattern"
                                     : "the mesh has no texture coordinates (UVs)");
  }
  if (!uvs.degenerate.empty()) {
    return text::Sentence("the texture coordinates (UVs) give no area to {}", countAndFirst(uvs.degenerate));
  }
  if (!uvs.mirrored.empty()) {
    return text::Sentence("the texture coordinates (UVs) mirror {} against the rest of the piece",
                          countAndFirst(uvs.mirrored));
  }
  return {};
}

std::string refusalOf(const PatternUvs& uvs, std::string_view setting, std::string_view otherwise) {
  const std::string instead = std::string(setting) + " = " + std::string(otherwise);
  return std::string(setting) + " = uv cannot be used: " + problemOf(uvs).english() +
         (uvs.ofGrid ? ". Use " + instead + ", or open a mesh file that has them"
                     : ". Correct the UVs in the file, or use " + instead);
}

}  // namespace drape::scene
