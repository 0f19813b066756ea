#pragma once

#include "io/mesh_import.hpp"

namespace drape {

/// A render mesh for a cloth without texture coordinates: each face is laid flat along the axis that its normal
/// follows most, in metres, so that a fabric's pattern has its true size and is hardly stretched. Faces that follow
/// different axes do not share render vertices.
[[nodiscard]] RenderMesh renderMeshFromPlanes(const ClothMesh& cloth);

}  // namespace drape
