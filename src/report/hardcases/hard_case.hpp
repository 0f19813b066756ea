#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// A figure that a case found, beside the most that it may be.
struct CaseFigure {
  std::string name;  ///< "energy gained"
  std::string unit;  ///< "%"; empty for a plain number
  double value = 0.0;
  double limit = std::numeric_limits<double>::infinity();  ///< infinite: shown only

  /// What is not a number does not pass.
  [[nodiscard]] bool passes() const { return value <= limit; }
  /// "energy gained 3.2 % (at most 1)".
  [[nodiscard]] std::string text() const;
};

enum class CaseOutcome {
  Passed,
  Failed,
  GivenUp  ///< it took longer than it may; nothing is known
};

/// "passed", "failed" or "given up".
[[nodiscard]] std::string_view wordFor(CaseOutcome outcome);

/// How a solver did in a case.
struct CaseResult {
  CaseOutcome outcome = CaseOutcome::Failed;
  std::vector<CaseFigure> figures;
  std::string words;     ///< why it failed, and what else is to be said; may be empty
  double seconds = 0.0;  ///< of the clock
};

/// How cases are run.
struct CaseOptions {
  std::string solver = "one_iteration";
  bool shortForm = false;                   ///< smaller cloths and shorter times: seconds for all of them together
  std::vector<std::string> settings;        ///< "key=value" over the cases' own, as the solver's iterations
  double mostSeconds = 60.0;                ///< a case that takes longer is given up
  std::function<void()> checkStop = [] {};  ///< called now and then; may throw
};

class CaseTrial;

/// A case that is hard for cloth solvers. It is declared once, in the table of cases.cpp.
struct HardCase {
  int number = 0;
  std::string_view name;       ///< "random_start"
  std::string_view statement;  ///< what is asked, in one sentence
  std::string_view rule;       ///< what is measured beside what every case is (docs/guide/hardcases.md)
  void (*run)(CaseTrial&) = nullptr;
};

/// Every case, by number.
[[nodiscard]] std::span<const HardCase> hardCaseTable();

/// The case of that number or name. Throws UsageError when there is none.
[[nodiscard]] const HardCase& requireHardCase(std::string_view numberOrName);

/// Runs a case. Throws UsageError for a solver or setting that does not exist.
[[nodiscard]] CaseResult runHardCase(const HardCase& hardCase, const CaseOptions& options);

}  // namespace drape
