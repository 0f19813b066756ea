#pragma once

#include "io/mesh_import.hpp"

namespace drape::io {

/// Fills in the measures of a finished cloth mesh: counts, topology, size, and the resulting warnings. The counts of
/// dropped and repaired parts must be set before. For a body there are no warnings about size and separate pieces.
void summarise(const sim::ClothMesh& cloth, MeshUse use, MeshSummary& summary);

}  // namespace drape::io
