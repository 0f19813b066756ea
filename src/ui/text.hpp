#pragma once

#include "io/clip_facts.hpp"
#include "session/snapshot.hpp"
#include "text/catalogue.hpp"
#include "text/number_text.hpp"

#include <string>
#include <string_view>

namespace drape::ui {

/// The speed of the simulation: "real time", "0.4 x real time: too slow", "paused".
[[nodiscard]] std::string describePace(const session::Snapshot& snapshot,
                                       const text::Catalogue& texts = text::Catalogue());

/// Whether the simulation is slower than the chosen speed.
[[nodiscard]] bool isTooSlow(const session::Snapshot& snapshot);

/// Why the simulation is slow and what helps, in words. Names contact if it takes more than half of the last step.
[[nodiscard]] text::Sentence slownessInWords(const session::Snapshot& snapshot);

/// A clip of an animation: "Walk (1.2 s)".
[[nodiscard]] std::string clipName(const io::ClipFacts& clip, const text::Catalogue& texts = text::Catalogue());

/// The number of pinned vertices.
[[nodiscard]] int countPins(const sim::ClothModel& model);

/// The text, cut to at most that many characters with an ellipsis, never inside a UTF-8 character.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t limit);

}  // namespace drape::ui
