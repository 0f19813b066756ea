#pragma once

#include "io/mesh_import.hpp"

#include <string_view>

namespace drape::io {

/// The end of the warning about a cloth of several pieces, for scenes that sew them together.
inline constexpr std::string_view piecesNeedPins = " separate pieces: each needs its own pins to stay up.";

/// Fills in the measures of a finished cloth mesh: counts, topology, size, and the resulting warnings. The counts of
/// dropped and repaired parts must be set before. For a body there are no warnings about size and separate pieces.
void summarise(const sim::ClothMesh& cloth, MeshUse use, MeshSummary& summary);

}  // namespace drape::io
