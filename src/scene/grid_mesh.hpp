#pragma once

#include "scene/scene.hpp"

namespace drape {

/// Vertices of a grid: row-major, row 0 is the top (vertical) or the back (horizontal) edge, column 0 the left one.
struct GridLayout {
  int columns = 0;
  int rows = 0;
  double width = 0.0;   ///< along a row [m]
  double height = 0.0;  ///< across the rows [m]

  [[nodiscard]] int index(int row, int column) const { return row * columns + column; }
};

/// `resolution` vertices along the shorter side, and as many along the longer one as make the cells nearly square.
/// Throws InputError for more than four million vertices.
[[nodiscard]] GridLayout layoutOf(const Settings::Grid& grid);

/// A flat sheet centred on the origin, one diagonal a quad (from row r, column c to row r + 1, column c + 1), texture
/// coordinates in metres. Its front looks up (horizontal) or towards +z (vertical).
[[nodiscard]] ImportedMesh makeGrid(const GridLayout& layout, GridSource::Plane plane);

/// Presses a sheet together along x into sine-shaped folds, so that lengths along its rows stay what they were. The
/// positions' x run from -width/2 to width/2.
void applyPleats(const Pleats& pleats, double width, std::vector<Vec3>& positions);

/// The vertices of named corners and edges. Throws InputError for a name that is none.
[[nodiscard]] std::vector<int> gridPins(const PinSelection& pins, const GridLayout& layout);

}  // namespace drape
