#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::report::hardcases {

/// A value of a case, with its limit.
struct CaseFigure {
  std::string name;  ///< "energy gained"
  std::string unit;  ///< "%"; empty for a plain number
  double value = 0.0;
  double limit = std::numeric_limits<double>::infinity();  ///< infinite: shown only

  /// A NaN does not pass.
  [[nodiscard]] bool passes() const { return value <= limit; }
  /// "energy gained 3.2 % (at most 1)".
  [[nodiscard]] std::string text() const;
};

enum class CaseOutcome {
  Passed,
  Failed,
  GivenUp,  ///< it exceeded the time limit; the result is unknown
  Refused   ///< the case has a fabric, and the solver takes springs only
};

/// "passed", "failed", "given up" or "refused".
[[nodiscard]] std::string_view wordFor(CaseOutcome outcome);

/// The result of a solver in a case.
struct CaseResult {
  CaseOutcome outcome = CaseOutcome::Failed;
  int start = 0;  ///< CaseOptions::start
  std::vector<CaseFigure> figures;
  std::string words;     ///< the reason of a failure, and remarks; may be empty
  std::string warning;   ///< what the solver warned of before a case that it failed; may be empty
  double seconds = 0.0;  ///< wall clock time
};

/// Options of the cases.
struct CaseOptions {
  std::string solver = "one_iteration";
  bool shortForm = false;                   ///< smaller cloths and shorter times: seconds for all of them
  int start = 0;                            ///< 0: that of the case; n: the n-th jittered start, in cases of contact
  std::vector<std::string> settings;        ///< "key=value", added to the settings of the cases
  double maxSeconds = 60.0;                 ///< time limit of a case
  std::function<void()> checkStop = [] {};  ///< called regularly; may throw
};

class CaseTrial;

/// A case that is hard for cloth solvers, declared in the table of cases.cpp.
struct HardCase {
  int number = 0;
  std::string_view name;       ///< "random_start"
  std::string_view statement;  ///< description, in one sentence
  std::string_view rule;       ///< criteria besides the general ones (docs/guide/hardcases.md)
  void (*run)(CaseTrial&) = nullptr;
  bool contact = false;  ///< whether it has jittered starts
};

/// All cases, by number.
[[nodiscard]] std::span<const HardCase> hardCaseTable();

/// The case of that number or name. Throws UsageError when there is none.
[[nodiscard]] const HardCase& requireHardCase(std::string_view numberOrName);

/// Runs a case. Throws UsageError for a solver or setting that does not exist.
[[nodiscard]] CaseResult runHardCase(const HardCase& hardCase, const CaseOptions& options);

}  // namespace drape::report::hardcases
