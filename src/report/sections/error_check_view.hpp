#pragma once

#include "report/section.hpp"

#include <string>

namespace drape::report::sections {

/// The judgement of a row of error_check: "" if the check was right, otherwise what was wrong.
[[nodiscard]] std::string checkNote(const ReportRow& row);

/// Shows the rows of error_check.
[[nodiscard]] std::vector<Block> showErrorCheck(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
