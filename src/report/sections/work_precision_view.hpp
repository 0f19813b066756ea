#pragma once

#include "report/error_report.hpp"
#include "report/section.hpp"

#include <string>
#include <vector>

namespace drape::report::sections {

/// The state of a run: "exploded" when it was not finite, moved more than twice as much as the reference, or is farther
/// from it than the length of the cloth; "frozen" when it moved less than half as much as the reference; otherwise
/// "calm".
[[nodiscard]] std::string stateOf(bool finite, const ErrorSummary& summary, double diagonal);

/// The diagrams with their Pareto fronts and tables.
[[nodiscard]] std::vector<Block> showWorkPrecision(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
