#include "report/hardcases/attach_to.hpp"

#include <algorithm>

namespace drape::report::hardcases {

session::AttachCommand attachTo(const sim::ClothModel& model, int vertex, const Vec3& target) {
  const int triangle = model.vertexTriangles[vertex].front();
  const Triangle& corners = model.triangles[triangle];
  Vec3 weights = Vec3::Zero();
  weights[std::find(corners.begin(), corners.end(), vertex) - corners.begin()] = 1.0;
  return {{triangle, weights, target}};
}

}  // namespace drape::report::hardcases
