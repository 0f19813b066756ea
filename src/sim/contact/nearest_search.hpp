#pragma once

#include "sim/contact/mesh_in_step.hpp"

#include <span>
#include <vector>

namespace drape {

/// Finds the point of a mesh that is nearest to a point of the cloth, at its base.
class NearestSearch {
 public:
  explicit NearestSearch(const MeshInStep& mesh) : mesh_(mesh) {}

  /// Looks at some triangles of the mesh.
  /// @param boxes around each of them  @param radius nothing farther counts [m]
  [[nodiscard]] NearVertex among(std::span<const int> triangles, const BoxList& boxes, const Vec3& point,
                                 double radius);

  /// Looks into the whole mesh.
  [[nodiscard]] NearVertex anywhere(const Vec3& point, double radius);

 private:
  void lookAt(int triangle, const Vec3& point);
  [[nodiscard]] NearVertex result(const Vec3& point);

  const MeshInStep& mesh_;
  std::vector<double> toBox_;  // [m^2]
  NearVertex best_;
  double least_ = 0.0;  // [m^2]
};

}  // namespace drape
