#pragma once

#include "report/measurement.hpp"

#include <string>

namespace drape {

/// A measurement as a table in plain text, a line a checkpoint, with the reference's check above and the summaries
/// below it.
[[nodiscard]] std::string errorTable(const Measurement& measurement);

}  // namespace drape
