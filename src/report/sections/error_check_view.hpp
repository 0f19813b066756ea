#pragma once

#include "report/section.hpp"

#include <string>

namespace drape::report::sections {

/// The judgement of a row of error_check: "" if the check was right or has no result, otherwise what was wrong. The
/// error that it gives must be right within a factor of five, and so must the spread where it says that the error
/// cannot be known.
[[nodiscard]] std::string checkNote(const ReportRow& row);

/// Numbers of rows of error_check. Each row counts once.
struct CheckCounts {
  int right = 0;     ///< give an error that is right
  int notKnown = 0;  ///< say that the error cannot be known, with the right spread
  int wrong = 0;     ///< have a note (checkNote)
  int noResult = 0;  ///< without a reference, or the check had no result

  [[nodiscard]] int all() const { return right + notKnown + wrong + noResult; }
};

[[nodiscard]] CheckCounts countChecks(const ReportRows& rows);

/// Shows the rows of error_check.
[[nodiscard]] std::vector<Block> showErrorCheck(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
