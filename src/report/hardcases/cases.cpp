#include "report/hardcases/cases.hpp"

#include "messages/error.hpp"
#include "messages/solver_warning_text.hpp"
#include "report/hardcases/case_trial.hpp"
#include "report/hardcases/hard_case.hpp"

#include <algorithm>
#include <array>

namespace drape::report::hardcases {
namespace {

// clang-format off
constexpr std::array table{
    HardCase{1, "random_start", "All free vertices start at random positions in a unit cube, with damping.",
        "kinetic and elastic energy after 5 s below 1e-3 of the start; strain below 0.3", hardcases::randomStart},
    HardCase{2, "flattened", "A tube starts flattened to a plane, and to a line.",
        "every spring within 1 % of its rest length afterwards", hardcases::flattened},
    HardCase{3, "one_point", "All vertices start at one point.",
        "it unfolds, identically in every run; the mean length of the springs is at most 10 % below the rest length", hardcases::onePoint},
    HardCase{4, "crushed", "A free sheet starts compressed to 1 % in its plane.",
        "the general criteria only", hardcases::crushed},
    HardCase{5, "uneven_springs", "Half of the springs are 1e5 times as stiff as the others.",
        "the general criteria only", hardcases::unevenSprings},
    HardCase{6, "uneven_masses", "One tenth of the vertices is 1e5 times as heavy as the others.",
        "largest elongation during the run at most twice that of the converged solve", hardcases::unevenMasses},
    HardCase{7, "free_fall", "A sheet with damped springs falls freely.",
        "no vertex moves relative to the others by more than 1e-6 m", hardcases::freeFall},
    HardCase{8, "spinning", "A free sheet spins and drifts without gravity.",
        "linear and angular momentum change by at most 1e-6 of their value", hardcases::spinning},
    HardCase{9, "one_corner", "A damped sheet hangs from one corner for 60 s.",
        "it does not rotate about its pin (0.01 1/s) and rests (root mean square speed of 1 mm/s)", hardcases::oneCorner},
    HardCase{10, "large_at_rest", "A damped sheet of 100 x 100 vertices hangs from its top edge for 60 s.",
        "no vertex is faster than 1 mm/s or oscillates by more than 1e-4 of an edge", hardcases::largeAtRest},
    HardCase{11, "random_frames", "Frames have random durations from 1 to 100 ms.",
        "after the same number of steps the same bits as with equal frames", hardcases::randomFrames},
    HardCase{12, "changed_running", "The stiffness changes by a factor of 100 and the time step by 2.5 and 5 during the run.",
        "in the next step no vertex leaves its path by more than an edge", hardcases::changedWhileRunning},
    HardCase{13, "scales", "The same cloth at sizes of 1 mm, 1 m and 1 km.",
        "the dimensionless motion is the same to 1 % of the diagonal", hardcases::scales},
    HardCase{14, "degenerate_triangles", "A mesh with slivers, triangles without area and duplicate vertices.",
        "every defect is reported", hardcases::degenerateTriangles},
    HardCase{15, "loose_mesh", "A mesh with vertices without a face, an edge of four faces and separate pieces.",
        "every defect is reported", hardcases::looseMesh},
    HardCase{16, "long_steps", "Steps of 1/30, 1/24 and 1/15 s.",
        "the general criteria only", hardcases::longSteps},
    HardCase{17, "pins_teleport", "The pins of a hanging sheet move by 10 m within one frame.",
        "no spring is stretched by more than 5 % 2 s later", hardcases::pinsTeleport},
    HardCase{18, "storm", "Wind of 1e3 m/s, on free cloth and on pinned cloth.",
        "the mean velocity of the free cloth relative to the air is not reversed (1 % of the wind)", hardcases::storm},
    HardCase{19, "fine_and_stiff", "Sheets of 129 x 129 and 257 x 257 vertices with 1e5 N/m.",
        "the general criteria only", hardcases::fineAndStiff},
    HardCase{20, "thrown", "An attachment pulls a vertex at 100 m/s, then releases it.",
        "the general criteria only", hardcases::thrown},
    HardCase{21, "heavy_gravity", "Gravity is 100 times that of the Earth.",
        "the general criteria only", hardcases::heavyGravity},
    HardCase{22, "nothing_there", "No stiffness, no mass, springs without length.",
        "refused with a message, or handled: without stiffness a vertex falls freely (5 %)", hardcases::nothingThere},
    HardCase{23, "fabric_long_steps", "Denim and cotton with steps of 1/60 and 1/30 s.",
        "the general criteria only", hardcases::fabricLongSteps},
    HardCase{24, "fabric_folded", "A cotton sheet starts folded flat onto itself and hangs from two corners.",
        "the general criteria only", hardcases::fabricFolded},
    HardCase{25, "fabric_turned_over", "One tenth of the vertices of a free cotton sheet starts beyond their neighbours, so triangles are turned over.",
        "kinetic and elastic energy after 3 s below 1e-3 of the start", hardcases::fabricTurnedOver},
    HardCase{26, "fabric_slivers", "Cotton on a mesh with slivers and with triangles that are 1e4 times smaller than the others.",
        "the clamped triangles are counted", hardcases::fabricSlivers},
    HardCase{27, "fabric_uneven_moduli", "The stretch modulus is 1e5 N/m along warp and 10 N/m along weft.",
        "largest elongation during the run at most twice that of the converged solve", hardcases::fabricUnevenModuli},
    HardCase{28, "fabric_compressed", "Canvas starts between two pinned edges at 0.3 of its width.",
        "the general criteria only", hardcases::fabricCompressed},
    HardCase{29, "fabric_damped", "Free denim with damping times of 1 s spins and drifts without gravity.",
        "linear and angular momentum change by at most 1e-6 of their value", hardcases::fabricDamped},
    HardCase{30, "fabric_thin_cells", "A sheet of 1 cm whose cells are 50 times longer than wide, in denim and in jersey.",
        "the general criteria only", hardcases::fabricThinCells},
    HardCase{31, "fabric_violent_start", "Every vertex of a denim sheet starts with a random velocity of up to 50 m/s.",
        "kinetic and elastic energy after 3 s below 1e-2 of the start; strain below 0.3", hardcases::fabricViolentStart},
    HardCase{32, "fabric_pins_teleport", "The pins of hanging cotton move by 1 m within one frame.",
        "kinetic and elastic energy after 2 s below 1e-3 of the value after the move; strain below 0.3", hardcases::fabricPinsTeleport},
    HardCase{33, "fabric_overstretched", "Jersey under 30 times the gravity of the Earth, which stretches it twofold.",
        "largest elongation during the run at most 1.5 times that of the converged solve", hardcases::fabricOverstretched},
    HardCase{34, "contact_twisted", "Two bars twist a sheet by ten turns.",
        "no intersecting pairs", hardcases::contactTwisted, true},
    HardCase{35, "contact_ring", "A sheet is pulled through a ring by its centre.",
        "no intersecting pairs", hardcases::contactRing, true},
    HardCase{36, "contact_sharp", "A sheet falls on a spike, and on a blade.",
        "no intersecting pairs", hardcases::contactSharp, true},
    HardCase{37, "contact_vice", "A vice closes on a folded sheet to its thickness, and opens.",
        "no intersecting pairs, except while the vice is closed; at rest 10 s after the start (10 mm/s)", hardcases::contactVice, true},
    HardCase{38, "contact_five_sheets", "Five sheets fall on each other.",
        "no intersecting pairs; at rest after 9 s (10 mm/s)", hardcases::contactFiveSheets, true},
    HardCase{39, "contact_sofa", "A dress falls on a sofa.",
        "no intersecting pairs; at rest after 11 s (10 mm/s)", hardcases::contactSofa, true},
    HardCase{40, "contact_two_layers", "A garment of two layers hangs on a torso that turns, tilts and moves.",
        "no intersecting pairs", hardcases::contactTwoLayers, true},
    HardCase{41, "contact_dragged", "The mouse drags a sheet violently for 60 s, over a sphere on the ground.",
        "no intersecting pairs", hardcases::contactDragged, true},
    HardCase{42, "contact_crumpled", "A shrinking hollow sphere crumples a sheet into a ball.",
        "no intersecting pairs", hardcases::contactCrumpled, true},
    HardCase{43, "contact_long_steps", "The scenes fold and edge_drop with steps of 1/60 s and 10, 1e3 and 1e5 N/m.",
        "no intersecting pairs", hardcases::contactLongSteps, true},
};
// clang-format on

CaseOutcome outcomeOf(const CaseTrial& trial) {
  const auto& figures = trial.figures();
  const bool passed =
      std::all_of(figures.begin(), figures.end(), [](const CaseFigure& figure) { return figure.passes(); });
  return passed ? CaseOutcome::Passed : CaseOutcome::Failed;
}

/// The failure, followed by the remarks of the case.
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
    case CaseOutcome::Refused:
      return "refused";
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
    throw messages::UsageError("there is no hard case '" + std::string(numberOrName) + "'; give a number from 1 to " +
                               std::to_string(table.size()) + " or a name from the table");
  }
  return *found;
}

CaseResult runHardCase(const HardCase& hardCase, const CaseOptions& options) {
  CaseTrial trial(options);
  CaseResult result;
  result.start = options.start;
  std::string ended;
  try {
    hardCase.run(trial);
    result.outcome = outcomeOf(trial);
  } catch (const CaseEnded& end) {
    ended = end.why;
  } catch (const CaseRefused&) {
    result.outcome = CaseOutcome::Refused;
    ended = "The solver takes springs only.";
  } catch (const CaseTooSlow&) {
    result.outcome = CaseOutcome::GivenUp;
    ended = "It exceeded the time limit.";
  }
  result.figures = trial.figures();
  result.words = wordsOf(trial, ended);
  if (result.outcome == CaseOutcome::Failed && trial.warning()) {
    result.warning = messages::inWords(*trial.warning()).english();
  }
  result.seconds = trial.seconds();
  return result;
}

}  // namespace drape::report::hardcases
