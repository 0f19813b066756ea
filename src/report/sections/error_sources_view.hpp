#pragma once

#include "report/section.hpp"

#include <vector>

namespace drape::report::sections {

/// Shows the rows of error_sources.
[[nodiscard]] std::vector<Block> showErrorSources(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
