#pragma once

#include "report/section.hpp"

#include <vector>

namespace drape::report::sections {

/// The largest eps that the paper prints in its Table 2 [-].
inline constexpr double paperLargestEps = 0.000485;

/// The tables, the plots over the checkpoints, and the start that comes closest to the paper.
[[nodiscard]] std::vector<Block> showTable2(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
