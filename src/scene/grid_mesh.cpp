#include "scene/grid_mesh.hpp"

#include "messages/error.hpp"
#include "scene/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::scene {
namespace {

/// One fold of a pleat: a sine of the given amplitude over `length` along x, sampled by arc length.
class Fold {
 public:
  Fold(double length, double amplitude) : length_(length), amplitude_(amplitude), arc_(samples + 1, 0.0) {
    for (int i = 1; i <= samples; ++i) {
      const double dz = offsetAt(i) - offsetAt(i - 1);
      arc_[i] = arc_[i - 1] + std::hypot(length_ / samples, dz);
    }
  }

  [[nodiscard]] double arcLength() const { return arc_.back(); }

  /// Position along x and across it at arc length `arc`.
  [[nodiscard]] Vec2 at(double arc) const {
    const auto after = std::upper_bound(arc_.begin(), arc_.end() - 1, arc);
    const auto i = std::max<std::ptrdiff_t>(1, after - arc_.begin());
    const double share = (arc - arc_[i - 1]) / (arc_[i] - arc_[i - 1]);
    const double place = (static_cast<double>(i - 1) + share) / samples;
    return {length_ * place, amplitude_ * std::sin(2.0 * std::numbers::pi * place)};
  }

 private:
  static constexpr int samples = 256;

  [[nodiscard]] double offsetAt(int i) const {
    return amplitude_ * std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / samples);
  }

  double length_;
  double amplitude_;
  std::vector<double> arc_;
};

/// The fold with this length along x and this arc length.
Fold foldOfArc(double length, double arc) {
  double low = 0.0;
  double high = arc;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (Fold(length, middle).arcLength() < arc ? low : high) = middle;
  }
  return {length, 0.5 * (low + high)};
}

std::vector<int> edgeOf(const std::string& name, const GridLayout& layout) {
  const bool vertical = name == "left" || name == "right";
  if (!vertical && name != "top" && name != "bottom") {
    throw messages::InputError("a grid has no edge '" + name + "'; its edges are top, bottom, left and right");
  }
  std::vector<int> vertices;
  for (int i = 0; i < (vertical ? layout.rows : layout.columns); ++i) {
    vertices.push_back(vertical ? layout.index(i, name == "left" ? 0 : layout.columns - 1)
                                : layout.index(name == "top" ? 0 : layout.rows - 1, i));
  }
  return vertices;
}

int cornerOf(const std::string& name, const GridLayout& layout) {
  const bool top = name.starts_with("top_");
  const bool left = name.ends_with("_left");
  if ((!top && !name.starts_with("bottom_")) || (!left && !name.ends_with("_right"))) {
    throw messages::InputError("a grid has no corner '" + name +
                               "'; its corners are top_left, top_right, bottom_left and bottom_right");
  }
  return layout.index(top ? 0 : layout.rows - 1, left ? 0 : layout.columns - 1);
}

void measure(const GridLayout& layout, GridSource::Plane plane, io::MeshSummary& summary) {
  summary.source = "grid";
  summary.verticesInFile = layout.columns * layout.rows;
  summary.vertices = summary.verticesInFile;
  const int quads = (layout.columns - 1) * (layout.rows - 1);
  summary.triangles = 2 * quads;
  summary.springs = layout.rows * (layout.columns - 1) + layout.columns * (layout.rows - 1) + quads;
  summary.components = 1;
  summary.boundaryLoops = 1;
  const bool flat = plane == GridSource::Plane::Horizontal;
  summary.size = {layout.width, flat ? 0.0 : layout.height, flat ? layout.height : 0.0};
}

}  // namespace

GridLayout layoutOf(const settings::Settings::Grid& grid) {
  constexpr double maxVertices = 4e6;
  const double cell = std::min(grid.width, grid.height) / (grid.resolution - 1);
  const double vertices = (grid.width / cell + 1.0) * (grid.height / cell + 1.0);
  if (vertices > maxVertices) {
    throw messages::InputError(
        "a grid of " + std::to_string(static_cast<long long>(vertices)) +
        " vertices is too large (4000000 at most): lower grid.resolution, or bring grid.width and "
        "grid.height closer to each other");
  }
  const auto along = [&](double length) { return static_cast<int>(std::lround(length / cell)) + 1; };
  return {along(grid.width), along(grid.height), grid.width, grid.height};
}

io::ImportedMesh makeGrid(const GridLayout& layout, GridSource::Plane plane) {
  io::ImportedMesh mesh;
  for (int row = 0; row < layout.rows; ++row) {
    const double v = layout.height * row / (layout.rows - 1);
    for (int column = 0; column < layout.columns; ++column) {
      const double u = layout.width * column / (layout.columns - 1);
      const double x = u - 0.5 * layout.width;
      const double across = v - 0.5 * layout.height;
      mesh.cloth.positions.push_back(plane == GridSource::Plane::Horizontal ? Vec3(x, 0.0, across)
                                                                            : Vec3(x, -across, 0.0));
      mesh.render.particle.push_back(layout.index(row, column));
      mesh.render.uvs.emplace_back(u, layout.height - v);
    }
  }
  for (int row = 0; row + 1 < layout.rows; ++row) {
    for (int column = 0; column + 1 < layout.columns; ++column) {
      const int corner = layout.index(row, column);
      const int opposite = layout.index(row + 1, column + 1);
      mesh.cloth.triangles.push_back({corner, layout.index(row + 1, column), opposite});
      mesh.cloth.triangles.push_back({corner, opposite, layout.index(row, column + 1)});
    }
  }
  mesh.render.triangles = mesh.cloth.triangles;
  mesh.file = fileMeshOf(mesh);  // a grid has no file: its mesh stands for it
  measure(layout, plane, mesh.summary);
  return mesh;
}

void applyPleats(const Pleats& pleats, double width, std::vector<Vec3>& positions) {
  const double arc = width / pleats.count;
  const Fold fold = foldOfArc(arc * pleats.gather, arc);
  for (Vec3& position : positions) {
    const double along = std::clamp(position.x() + 0.5 * width, 0.0, width);
    const double index = std::min(std::floor(along / arc), static_cast<double>(pleats.count - 1));
    const Vec2 place = fold.at(along - index * arc);
    position.x() = (index * arc - 0.5 * width) * pleats.gather + place.x();
    position.z() += place.y();
  }
}

std::vector<int> gridPins(const PinSelection& pins, const GridLayout& layout) {
  std::vector<int> selected;
  for (const std::string& name : pins.corners) {
    selected.push_back(cornerOf(name, layout));
  }
  for (const std::string& name : pins.edges) {
    const std::vector<int> edge = edgeOf(name, layout);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      if (i % static_cast<std::size_t>(pins.every) == 0 || i + 1 == edge.size()) {
        selected.push_back(edge[i]);
      }
    }
  }
  return selected;
}

}  // namespace drape::scene
