#pragma once

#include "report/section.hpp"
#include "report/validation/validation_case.hpp"

#include <string>

namespace drape::report::validation {

/// The results of a case on one kind of mesh as a row of `validation`: `group`, `name`, `title`, `compared`, `unit`,
/// `mesh`, `aim`, `exact` (for a range its lower end) and `upper` (null without a range), `results` (`resolution`,
/// `measured`, `error`, `seconds`, `note`), `order` (null where there is none), `passed`, `reason` (the known reason
/// why it is off), and `shape` if there is a picture: `positions` (x, y, z of each vertex) [0.1 mm] and `triangles`.
[[nodiscard]] ReportRow validationRow(const ValidationSeries& series);

/// The error of one of the row's results: "0.134 %", or "none" if there is no equilibrium. For a range the measured
/// quantity.
[[nodiscard]] std::string figureOf(const ReportRow& row, const ReportRow& result);

/// The resolutions of a row's results: "10, 20, 40".
[[nodiscard]] std::string cellsOf(const ReportRow& row);

/// The aim of a row: "1.0 %", or the range "20 to 40".
[[nodiscard]] std::string aimOf(const ReportRow& row);

/// The observed order of a row, or "-".
[[nodiscard]] std::string orderOf(const ReportRow& row);

/// The wall clock time of all results of a row [s].
[[nodiscard]] double secondsOf(const ReportRow& row);

/// A row as a line for a terminal: name, kind of mesh, errors by resolution, order, aim, time, and "off" where the
/// error exceeds the aim.
[[nodiscard]] std::string validationLine(const ReportRow& row);

/// The heading of these lines.
[[nodiscard]] std::string validationHeading(std::span<const int> resolutions);

/// The table of the cases for docs/guide/validation.md: name, test, quantity and closed form, aim (Markdown).
[[nodiscard]] std::string validationListMarkdown();

/// Rows as a Markdown table; a row that is off is bold.
[[nodiscard]] std::string validationMarkdown(const ReportRows& rows);

}  // namespace drape::report::validation
