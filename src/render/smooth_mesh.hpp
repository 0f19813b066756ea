#pragma once

#include "render/gl_objects.hpp"
#include "render/surface_shapes.hpp"
#include "render/wrinkles.hpp"
#include "sim/model/vector.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace drape::render {

/// The constant data of a moving mesh. The views are only read during setTopology().
struct MeshTopology {
  std::span<const Triangle> particleTriangles;  ///< indices of particles; normals are smooth over these
  std::span<const Triangle> drawnTriangles;     ///< indices of drawn vertices
  std::span<const int> particleOfVertex;        ///< the particle of each drawn vertex; empty: the same index
  std::span<const Vec2> surfaceCoordinates;     ///< one per drawn vertex [m]; empty: all zero
  std::span<const Vec2> yarnCoordinates = {};   ///< one per drawn vertex [m]; empty: all zero
};

/// A moving triangle mesh on the graphics card. Positions and smooth normals are uploaded when they change, indices and
/// surface coordinates once. Vertex attributes: 0 position, 1 normal, 2 surface coordinates, 3 curvature, 4 yarn
/// coordinates, 5 a value, such as a place in a range of colours, 6 to 8 wrinkles.
class SmoothMesh {
 public:
  SmoothMesh();

  void setTopology(const MeshTopology& topology);

  /// Uploads positions (one per particle [m]) and their normals. Allocates no memory while the number stays the same.
  void setPositions(std::span<const Vec3> positions);

  /// Uploads one value a particle.
  void setValues(std::span<const float> values);

  /// Uploads the wrinkles at each particle.
  void setWrinkles(std::span<const Wrinkles> wrinkles);

  /// Draws the triangles with the current program.
  void draw() const;
  /// Draws some of them. @param first the first triangle
  void draw(int first, int count) const;

  /// The box around the last positions.
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return bounds_; }

 private:
  struct MovingVertex {
    Eigen::Vector3f position;
    SurfaceShape shape;
  };

  struct FixedVertex {
    Eigen::Vector2f surface = Eigen::Vector2f::Zero();  // [m]
    Eigen::Vector2f yarns = Eigen::Vector2f::Zero();    // [m]
  };

  static std::vector<FixedVertex> fixedVertices(const MeshTopology& topology, std::size_t count);

  GlVertexArray vertexArray_;
  GlBuffer moving_;
  GlBuffer fixed_;
  GlBuffer values_;    // empty until setValues
  GlBuffer wrinkles_;  // empty until setWrinkles
  GlBuffer indices_;
  GLsizei indexCount_ = 0;
  std::vector<Triangle> particleTriangles_;
  std::vector<int> particleOfVertex_;
  std::vector<float> valueOfVertex_;
  std::vector<Wrinkles> wrinklesOfVertex_;
  SurfaceShapes shapes_;
  Eigen::AlignedBox3d bounds_;
};

}  // namespace drape::render
