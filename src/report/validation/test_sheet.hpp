#pragma once

#include "sim/fabric/material.hpp"
#include "sim/model/cloth_model.hpp"

#include <array>
#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

namespace drape::report::validation {

/// The triangulation of a rectangular sheet.
enum class MeshKind {
  Grid,         ///< rectangular cells with parallel diagonals
  Alternating,  ///< rectangular cells with diagonals of alternating direction
  Irregular     ///< vertices inside are displaced by up to 30 % of a cell, diagonals are random
};

inline constexpr std::array meshKinds{MeshKind::Grid, MeshKind::Alternating, MeshKind::Irregular};

/// "grid", "alternating" or "irregular".
[[nodiscard]] std::string_view nameOf(MeshKind kind);

/// A mesh that a case runs on.
struct CaseMesh {
  int resolution = 0;  ///< cells along the sheet
  MeshKind kind = MeshKind::Grid;
  std::string_view subject = {};  ///< of the case: the name of a solver or of a preset; empty if it has none
  std::stop_token stop = {};      ///< ends a search or a run by sim::StepStopped
};

/// A flat rectangular sheet in the xz plane. It has columns of vertices along z, in the order of their x, and rows
/// along x.
struct TestSheet {
  sim::ClothMesh mesh;
  int columns = 0;  ///< of vertices
  int rows = 0;     ///< of vertices

  [[nodiscard]] int vertex(int column, int row) const { return row * columns + column; }
  /// The vertices of the columns from `first` to `last`.
  [[nodiscard]] std::vector<int> verticesOf(int first, int last) const;
};

/// Size and cells of a sheet.
struct SheetForm {
  double start = 0.0;   ///< x of the first column [m]
  double length = 0.0;  ///< along x [m]
  double width = 0.0;   ///< along z [m]
  int along = 0;        ///< cells along x
  int across = 0;       ///< cells along z
  int straight = 1;     ///< this number of columns at the start is not displaced, for a straight clamp
};

/// Makes a sheet. The irregular kind is the same at every call.
[[nodiscard]] TestSheet testSheet(const SheetForm& form, MeshKind kind);

/// The sheet as a cloth of fabric. @param density [kg/m^2]  @param pins vertex indices  @param warp its direction
[[nodiscard]] std::shared_ptr<const sim::ClothModel> clothOf(const TestSheet& sheet,
                                                             const sim::fabric::Material& material, double density,
                                                             const std::vector<int>& pins,
                                                             const Vec3& warp = Vec3::UnitX());

/// A fabric of one bending stiffness [N m] that hardly stretches.
[[nodiscard]] sim::fabric::Material stiffSheet(double bending);

/// A strip of this free length [m] that is clamped at x = 0, with a width of a fourth. Pin its first two columns.
///
/// The hinge at the second column bends. Curvature is a mean over the hinges of a triangle, so half of that bend counts
/// as curvature of the pinned triangles beside it. The strip bends as if it began in the middle of the pinned cell. So
/// the free length counts from there.
[[nodiscard]] TestSheet cantilever(double freeLength, const CaseMesh& mesh);

}  // namespace drape::report::validation
