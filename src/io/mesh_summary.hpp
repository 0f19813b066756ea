#pragma once

#include "io/mesh_import.hpp"

namespace drape {

/// Fills in what can be measured on a finished cloth mesh: counts, topology, size, and the warnings that follow from
/// them and from the counts of what was dropped or repaired, which must be there already. A body is not warned of its
/// size or of being several pieces.
void summarise(const ClothMesh& cloth, MeshUse use, MeshSummary& summary);

}  // namespace drape
