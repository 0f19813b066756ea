#pragma once

#include "io/mesh_import.hpp"
#include "sim/model/vector.hpp"
#include "text/sentence.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// The texture coordinates (UVs) of a cloth as a sewing pattern, and what is wrong with them. Triangles are those of
/// the cloth.
struct PatternUvs {
  std::vector<std::array<Vec2, 3>> corners;  ///< of each triangle; empty without texture coordinates in the file
  std::vector<int> degenerate;               ///< triangles without area in the texture
  std::vector<int> mirrored;  ///< triangles that are turned over against the larger part of their piece of the texture
  double area = 0.0;          ///< of the texture, in UV units [-]
  double meshArea = 0.0;      ///< of the cloth [m^2]
  bool ofGrid = false;        ///< the cloth is a grid, whose texture is made for the checker
  double distorted = 0.0;     ///< share of the area whose texture is stretched by more than maxPatternStretch [-]

  [[nodiscard]] bool present() const { return !corners.empty(); }
  /// Whether every triangle has a direction in the texture, and all of a piece are on the same side.
  [[nodiscard]] bool usable() const { return present() && degenerate.empty() && mirrored.empty(); }
  /// Whether they are usable and nearly a flat pattern, not a projection or a wrapping.
  [[nodiscard]] bool isPattern() const;
};

/// A triangle is distorted where its texture is this much longer in one direction than across [-]. Patterns that are
/// cut stay below 1.25 in nine of ten triangles (three shirts), and texture that is wrapped around a garment does not.
inline constexpr double maxPatternStretch = 1.5;

/// Twice the signed area of a texture triangle [-]; 0 if it is degenerate.
[[nodiscard]] double twiceArea(const std::array<Vec2, 3>& corners);

/// Measures texture coordinates. A mirrored piece as a whole is allowed: pieces are cut from folded cloth.
/// @param rest positions of the cloth's vertices [m]
[[nodiscard]] PatternUvs patternUvsOf(const io::RenderMesh& mesh, std::span<const Vec3> rest);

/// The direction of V in each triangle, a unit vector in its plane: along it U is constant and V grows. Zero for a
/// triangle that is degenerate at rest or in the texture. @param triangles of the cloth
[[nodiscard]] std::vector<Vec3> warpAlongV(const PatternUvs& uvs, std::span<const Vec3> rest,
                                           std::span<const Triangle> triangles);

/// Why the texture coordinates cannot give the warp: how many triangles, and the first of them. Empty if they can.
[[nodiscard]] text::Sentence problemOf(const PatternUvs& uvs);

/// The message for a setting that needs such texture coordinates: the problem and the remedy.
/// @param setting "fabric.warp_from"  @param otherwise the value that needs none
[[nodiscard]] std::string refusalOf(const PatternUvs& uvs, std::string_view setting, std::string_view otherwise);

}  // namespace drape::scene
