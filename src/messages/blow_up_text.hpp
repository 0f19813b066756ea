#pragma once

#include "sim/model/cloth_model.hpp"

#include <string>

namespace drape::messages {

/// What helps against a cloth that blew up: "Use a smaller time step or a softer fabric."
[[nodiscard]] std::string remedyForBlowUp(const sim::ClothModel& model);

}  // namespace drape::messages
