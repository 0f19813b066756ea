#pragma once

#include "report/section.hpp"

#include <string>
#include <vector>

namespace drape::report::sections {

/// The time budgets of the answer [ms per frame]; the last one is the whole frame.
[[nodiscard]] std::vector<double> frameBudgets();

/// The level below which the errors of a cloth cannot be told apart [m]: the parting of two starts that differ by a
/// micrometre, or the last change of the reference. Not a number when neither is known.
[[nodiscard]] double errorFloor(const ReportRows& rows);

/// The calm setting of a cloth with the smallest error that costs at most `msPerFrame`; among errors below the floor
/// the cheapest. Null when none is that cheap.
[[nodiscard]] const ReportRow* bestForBudget(const ReportRows& rows, double msPerFrame);

/// The cheapest calm setting; null when there is none.
[[nodiscard]] const ReportRow* cheapestCalm(const ReportRows& rows);

/// "0.43 mm", or "less than 1 um".
[[nodiscard]] std::string distanceText(double metres);

/// The error of a row: "0.43 mm", or "less than 0.02 mm" below the floor.
[[nodiscard]] std::string errorText(const ReportRow& row, double floor);

/// "xpbd substeps=4 iterations=1": what to set.
[[nodiscard]] std::string takeText(const ReportRow& row);

}  // namespace drape::report::sections
