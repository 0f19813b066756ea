#pragma once

#include "figure/proportions.hpp"
#include "io/garments/garments.hpp"

namespace drape::figure {

/// The figure as it is built, with its weights.
struct BuiltFigure {
  FigureShape shape;
  std::vector<Triangle> triangles;
  std::vector<SkinWeights> weights;
};

inline const BuiltFigure& builtFigure() {
  static const BuiltFigure figure = [] {
    const sim::ClothMesh mesh = io::weldMesh(io::makeFigure(), "figure", {}).cloth;
    return BuiltFigure{{restPlaces(), mesh.positions}, mesh.triangles, smoothWeights(mesh.positions, mesh.triangles)};
  }();
  return figure;
}

}  // namespace drape::figure
