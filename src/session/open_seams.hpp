#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/seams.hpp"
#include "text/sentence.hpp"

#include <span>

namespace drape::session {

/// Says that the sewn cloth is stretched so much that its pieces are too small. Empty if it is not.
[[nodiscard]] text::Sentence tightSewingInWords(const sim::ClothModel& model, const sim::ClothState& state);

/// Says how many seams should be closed by now but are open, and where the widest pair of them is. Empty if none is
/// late. A seam is late after twice its duration.
/// @param open the seams that are not welded
[[nodiscard]] text::Sentence lateSeamsInWords(std::span<const sim::Seam> open, const sim::ClothState& state);

}  // namespace drape::session
