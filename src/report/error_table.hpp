#pragma once

#include "report/measurement.hpp"

#include <string>

namespace drape::report {

/// A measurement as a plain text table: a line per checkpoint, with the reference's check above and the summaries
/// below.
[[nodiscard]] std::string errorTable(const Measurement& measurement);

}  // namespace drape::report
