#pragma once

#include "report/section.hpp"
#include "report/validation/validation_case.hpp"

#include <string>

namespace drape::report::validation {

/// The results of a case on one kind of mesh as a row of `validation`: `name`, `title`, `compared`, `unit`, `mesh`,
/// `aim`, `exact`, `results` (`resolution`, `measured`, `error`, `seconds`), `order` (null where there is none),
/// `passed`.
[[nodiscard]] ReportRow validationRow(const ValidationSeries& series);

/// The same as a line for a terminal: name, kind of mesh, errors by resolution, order, time, and "off" where the error
/// exceeds the aim.
[[nodiscard]] std::string validationLine(const ValidationSeries& series);

/// The heading of these lines.
[[nodiscard]] std::string validationHeading(std::span<const int> resolutions);

}  // namespace drape::report::validation
