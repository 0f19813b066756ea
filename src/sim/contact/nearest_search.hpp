#pragma once

#include "sim/contact/mesh_in_step.hpp"

#include <span>
#include <vector>

namespace drape {

/// Finds the point of a mesh that is nearest to a point of the cloth, at its base.
class NearestSearch {
 public:
  explicit NearestSearch(const MeshInStep& mesh) : mesh_(mesh) {}

  /// Looks into some leaves of the mesh's tree.
  /// @param boxes theirs  @param radius nothing farther counts [m]
  [[nodiscard]] NearVertex among(const std::vector<int>& patches, const BoxList& boxes, const Vec3& point,
                                 double radius);

  /// Looks into the whole mesh.
  [[nodiscard]] NearVertex anywhere(const Vec3& point, double radius);

 private:
  void lookAt(int triangle, const Vec3& point);
  [[nodiscard]] NearVertex result(const Vec3& point);

  const MeshInStep& mesh_;
  std::vector<std::int32_t> near_;  // patches
  std::vector<double> toBox_;       // of their triangles [m^2]
  NearVertex best_;
  double least_ = 0.0;  // [m^2]
};

}  // namespace drape
