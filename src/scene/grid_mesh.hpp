#pragma once

#include "scene/scene.hpp"

namespace drape::scene {

/// Vertices of a grid: row-major, row 0 is the top (vertical) or the back (horizontal) edge, column 0 the left one.
struct GridLayout {
  int columns = 0;
  int rows = 0;
  double width = 0.0;   ///< along a row [m]
  double height = 0.0;  ///< across the rows [m]

  [[nodiscard]] int index(int row, int column) const { return row * columns + column; }
};

/// `resolution` vertices along the shorter side, and a number along the longer one that makes the cells nearly square.
/// Throws InputError for more than four million vertices.
[[nodiscard]] GridLayout layoutOf(const settings::Settings::Grid& grid);

/// A flat sheet centred on the origin, with one diagonal per quad (from row r, column c to row r + 1, column c + 1) and
/// texture coordinates in metres. Its front faces up (horizontal) or towards +z (vertical).
[[nodiscard]] io::ImportedMesh makeGrid(const GridLayout& layout, GridSource::Plane plane);

/// Compresses a sheet along x into sine-shaped folds that keep the lengths along its rows. The x coordinates run from
/// -width/2 to width/2.
void applyPleats(const Pleats& pleats, double width, std::vector<Vec3>& positions);

/// The vertices of named corners and edges. Throws InputError for an unknown name.
[[nodiscard]] std::vector<int> gridPins(const PinSelection& pins, const GridLayout& layout);

}  // namespace drape::scene
