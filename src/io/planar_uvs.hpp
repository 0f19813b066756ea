#pragma once

#include "io/mesh_import.hpp"

namespace drape::io {

/// A render mesh for a cloth without texture coordinates. Each face is projected along the axis closest to its normal,
/// in metres, so that a pattern has its true size and little distortion. Faces with different axes do not share render
/// vertices.
[[nodiscard]] RenderMesh renderMeshFromPlanes(const sim::ClothMesh& cloth);

}  // namespace drape::io
