#pragma once

#include "report/error_report.hpp"
#include "report/section.hpp"

#include <string>
#include <vector>

namespace drape {

/// What became of a run: "exploded" when it was not finite up to there, moved more than twice as much as the reference,
/// or is further from it than the cloth is long; "frozen" when it kept less than half of the reference's motion; else
/// "calm".
[[nodiscard]] std::string stateOf(bool finite, const ErrorSummary& summary, double diagonal);

/// The diagrams with their Pareto fronts and tables.
[[nodiscard]] std::vector<Block> showWorkPrecision(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape
