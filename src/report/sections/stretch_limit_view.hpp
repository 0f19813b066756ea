#pragma once

#include "report/section.hpp"

#include <string>
#include <vector>

namespace drape::report::sections {

/// The table and the plot of each cloth.
[[nodiscard]] std::vector<Block> showStretchLimit(const ReportOptions& options, const ReportRows& rows);

/// What is wrong with a row: a lowered stiffness strains the cloth by more than the limit and by more than full
/// stiffness does. Empty if nothing is.
[[nodiscard]] std::string limitNote(const ReportRow& row);

}  // namespace drape::report::sections
