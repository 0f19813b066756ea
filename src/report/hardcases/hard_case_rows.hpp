#pragma once

#include "report/hardcases/hard_case.hpp"
#include "report/section.hpp"

#include <string>

namespace drape {

/// A result as a row of `hard_cases`: `case` (its number), `name`, `method`, `form` ("full" or "short"), `outcome`,
/// `passed`, `figures` (`name`, `unit`, `value`, `limit` where there is one, `passes`), `words`, `seconds`.
[[nodiscard]] ReportRow hardCaseRow(const HardCase& hardCase, const CaseOptions& options, const CaseResult& result);

/// A result as a line for a terminal, with its figures beside their limits or why it failed.
[[nodiscard]] std::string hardCaseLine(const HardCase& hardCase, const CaseResult& result);

/// All figures in one sentence: "energy gained 0.1 % (at most 1), strain left 0.2 % (at most 1)". How far the cloth
/// went is left out where that is no fault.
[[nodiscard]] std::string figuresInWords(const CaseResult& result);

/// Rows as a Markdown table: a line a case, a column a method, in each cell "passed" or what went wrong.
[[nodiscard]] std::string hardCaseMarkdown(const ReportRows& rows);

/// The table of the cases themselves: number, name, what is asked and what is measured.
[[nodiscard]] std::string hardCaseListMarkdown();

}  // namespace drape
