#pragma once

#include "session/user_state.hpp"

#include "text/sentence.hpp"

namespace drape::ui {

/// The change from one state of the user to another, in a few words: "Stiffness 150 to 300 N/m", "1 pin set", "Static
/// friction of the ball 0.5 to 0.8". Several changes are counted after the first one. @param scene names the bodies
[[nodiscard]] text::Sentence changeInWords(const session::UserState& from, const session::UserState& to,
                                           const scene::Scene& scene);

}  // namespace drape::ui
