#pragma once

#include "report/section.hpp"

#include <vector>

namespace drape::report::sections {

/// Shows the rows of pace.
[[nodiscard]] std::vector<Block> showPace(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
