#pragma once

#include "report/hardcases/hard_case.hpp"
#include "report/section.hpp"

#include <string>

namespace drape::report::hardcases {

/// A result as a row of `hard_cases`: `case` (its number), `name`, `method`, `form` ("full" or "short"), `start` (0, or
/// the number of a jittered start), `outcome`, `passed`, `figures` (`name`, `unit`, `value`, `limit` if there is one,
/// `passes`), `words`, `warning`, `seconds`.
[[nodiscard]] ReportRow hardCaseRow(const HardCase& hardCase, const CaseOptions& options, const CaseResult& result);

/// A result as a line for a terminal, with values and limits, or the reason of the failure. The solver's warning takes
/// a second line.
[[nodiscard]] std::string hardCaseLine(const HardCase& hardCase, const CaseResult& result);

/// What the solver warned of: "The solver warned: 3 sweeps ..."; empty if it did not.
[[nodiscard]] std::string warningInWords(const std::string& warning);

/// All values in one sentence: "energy gained 0.1 % (at most 1), strain left 0.2 % (at most 1)". The distance of the
/// cloth appears only when it is a failure.
[[nodiscard]] std::string figuresInWords(const CaseResult& result);

/// Rows as a Markdown table: a line per case, a column per method, with "passed" or the failure in each cell. Of
/// several starts, the cell has the first failure and their number: "pairs with itself 3 (2 of 11 starts)".
[[nodiscard]] std::string hardCaseMarkdown(const ReportRows& rows);

/// The table of the cases: number, name, description and criterion.
[[nodiscard]] std::string hardCaseListMarkdown();

}  // namespace drape::report::hardcases
