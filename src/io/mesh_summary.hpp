#pragma once

#include "io/mesh_import.hpp"

namespace drape {

/// Fills in what can be measured on a finished cloth mesh: counts, topology, size, and the warnings that follow from
/// them and from the counts of dropped faces, which must be there already.
void summarise(const ClothMesh& cloth, MeshSummary& summary);

}  // namespace drape
