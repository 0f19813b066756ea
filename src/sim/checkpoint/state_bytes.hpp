#pragma once

#include "sim/model/cloth_state.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace drape::sim {

/// A state as bytes, with everything that later steps depend on: also the contacts that self-collision remembers, and
/// the memory of `auto`. A simulation that continues from them takes the same steps to the last bit. The numbers have
/// the form of this machine.
[[nodiscard]] std::string bytesOf(const ClothState& state);

/// The state of such bytes. Empty if they are not exactly one state, whose vectors all have one entry per vertex.
[[nodiscard]] std::optional<ClothState> stateFromBytes(std::string_view bytes);

}  // namespace drape::sim
