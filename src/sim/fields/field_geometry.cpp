#include "sim/fields/field_geometry.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/model/mesh_topology.hpp"

namespace drape::sim::fields {

FieldGeometry fieldGeometryOf(const ClothModel& model, std::span<const Vec3> warp) {
  FieldGeometry geometry;
  geometry.rest = model.fabric ? model.fabric->shape.triangles
                               : fabric::restTrianglesOf(model.restPositions, model.triangles, warp);
  geometry.onBorder.assign(static_cast<std::size_t>(model.vertexCount()), false);
  for (const MeshEdge& edge : boundaryEdges(edgesOf(model.triangles, geometry.onBorder.size()))) {
    geometry.onBorder[edge.a] = true;
    geometry.onBorder[edge.b] = true;
  }
  return geometry;
}

}  // namespace drape::sim::fields
