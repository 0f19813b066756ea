#include "report/hardcases/cases.hpp"

#include "report/hardcases/case_trial.hpp"
#include "report/hardcases/hard_case.hpp"
#include "sim/error.hpp"

#include <algorithm>
#include <array>

namespace drape {
namespace {

// clang-format off
constexpr std::array table{
    HardCase{1, "random_start", "All free vertices start at random places in a unit cube, with damping.",
        "kinetic and elastic energy after 5 s under 1e-3 of the start's; strain under 0.3", hardcases::randomStart},
    HardCase{2, "flattened", "A tube starts flattened to a plane, and to a line.",
        "every spring within 1 % of its rest length afterwards", hardcases::flattened},
    HardCase{3, "one_point", "All vertices start at one point.",
        "it unfolds, the same at every run: springs are 10 % short of their rest lengths in the mean at most", hardcases::onePoint},
    HardCase{4, "crushed", "A free sheet starts pressed to 1 % in its plane.",
        "only what every case is measured by", hardcases::crushed},
    HardCase{5, "uneven_springs", "Half of the springs are 1e5 times as stiff as the others.",
        "only what every case is measured by", hardcases::unevenSprings},
    HardCase{6, "uneven_masses", "A tenth of the vertices is 1e5 times as heavy as the others.",
        "largest elongation on the way at most twice the converged solve's", hardcases::unevenMasses},
    HardCase{7, "free_fall", "A sheet with damped springs falls freely.",
        "no vertex moves against the others by more than 1e-6 m", hardcases::freeFall},
    HardCase{8, "spinning", "A free sheet spins and drifts without gravity.",
        "linear and angular momentum stay within 1e-6 of themselves", hardcases::spinning},
    HardCase{9, "one_corner", "A damped sheet hangs from one corner for 60 s.",
        "it does not turn about its pin (0.01 1/s) and rests (root mean square of 1 mm/s)", hardcases::oneCorner},
    HardCase{10, "large_at_rest", "A damped sheet of 100 x 100 vertices hangs from its top edge for 60 s.",
        "no vertex is faster than 1 mm/s or goes to and fro by more than 1e-4 of an edge", hardcases::largeAtRest},
    HardCase{11, "random_frames", "Frames take from 1 to 100 ms at random.",
        "after as many steps the same bits as with even frames", hardcases::randomFrames},
    HardCase{12, "changed_running", "Stiffness is changed by 100 and the time step by 2.5 and 5 while it runs.",
        "in the next step no vertex leaves its way by more than an edge", hardcases::changedWhileRunning},
    HardCase{13, "scales", "The same cloth at sizes of 1 mm, 1 m and 1 km.",
        "without dimension the motion is the same to 1 % of the diagonal", hardcases::scales},
    HardCase{14, "degenerate_triangles", "A mesh with slivers, triangles without area and vertices that come twice.",
        "what is wrong is told", hardcases::degenerateTriangles},
    HardCase{15, "loose_mesh", "A mesh with vertices of no face, an edge of four faces and separate pieces.",
        "what is wrong is told", hardcases::looseMesh},
    HardCase{16, "long_steps", "Steps of 1/30, 1/24 and 1/15 s.",
        "only what every case is measured by", hardcases::longSteps},
    HardCase{17, "pins_teleport", "The pins of a hanging sheet are moved by 10 m within one frame.",
        "no spring longer than 5 % beyond its rest length 2 s later", hardcases::pinsTeleport},
    HardCase{18, "storm", "Wind of 1e3 m/s, on free cloth and on held cloth.",
        "the free cloth's mean velocity against the air is not reversed (1 % of the wind)", hardcases::storm},
    HardCase{19, "fine_and_stiff", "Sheets of 129 x 129 and 257 x 257 vertices with 1e5 N/m.",
        "only what every case is measured by", hardcases::fineAndStiff},
    HardCase{20, "thrown", "A hand holds a vertex and goes off at 100 m/s, then lets go.",
        "only what every case is measured by", hardcases::thrown},
    HardCase{21, "heavy_gravity", "Gravity is 100 times what it is here.",
        "only what every case is measured by", hardcases::heavyGravity},
    HardCase{22, "nothing_there", "No stiffness, no mass, springs without length.",
        "refused in words, or handled: without stiffness a vertex falls freely (5 %)", hardcases::nothingThere},
};
// clang-format on

CaseOutcome outcomeOf(const CaseTrial& trial) {
  const auto& figures = trial.figures();
  const bool passed =
      std::all_of(figures.begin(), figures.end(), [](const CaseFigure& figure) { return figure.passes(); });
  return passed ? CaseOutcome::Passed : CaseOutcome::Failed;
}

/// What failed, before what the case had to say.
std::string wordsOf(const CaseTrial& trial, const std::string& ended) {
  std::string words = ended;
  for (const CaseFigure& figure : trial.figures()) {
    if (!figure.passes()) {
      words += (words.empty() ? "" : "; ") + figure.text();
    }
  }
  return words + (words.empty() || trial.words().empty() ? "" : ". ") + trial.words();
}

}  // namespace

std::string_view wordFor(CaseOutcome outcome) {
  switch (outcome) {
    case CaseOutcome::Passed:
      return "passed";
    case CaseOutcome::Failed:
      return "failed";
    case CaseOutcome::GivenUp:
      break;
  }
  return "given up";
}

std::span<const HardCase> hardCaseTable() {
  return table;
}

const HardCase& requireHardCase(std::string_view numberOrName) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const HardCase& one) {
    return one.name == numberOrName || std::to_string(one.number) == numberOrName;
  });
  if (found == table.end()) {
    throw UsageError("there is no hard case '" + std::string(numberOrName) + "'; give a number from 1 to " +
                     std::to_string(table.size()) + " or a name as the table shows them");
  }
  return *found;
}

CaseResult runHardCase(const HardCase& hardCase, const CaseOptions& options) {
  CaseTrial trial(options);
  CaseResult result;
  std::string ended;
  try {
    hardCase.run(trial);
    result.outcome = outcomeOf(trial);
  } catch (const CaseEnded& end) {
    ended = end.why;
  } catch (const CaseTooSlow&) {
    result.outcome = CaseOutcome::GivenUp;
    ended = "It took longer than it may.";
  }
  result.figures = trial.figures();
  result.words = wordsOf(trial, ended);
  result.seconds = trial.seconds();
  return result;
}

}  // namespace drape
