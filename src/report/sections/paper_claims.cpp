#include "report/sections/paper_claims.hpp"

#include "report/number_text.hpp"
#include "report/sections/paper_times.hpp"
#include "report/sections/table2_view.hpp"
#include "report/timing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace drape::report::sections {
namespace {

/// The paper's method and stiffness.
constexpr std::string_view paperMethod = "one_iteration";
constexpr double paperStiffness = 10.0;  // [N/m]
constexpr int paperCheckpoints = 25;
/// From this time step on, a step counts as large [s].
constexpr double largeStep = 1.0 / 60.0;
/// A time that grows with a smaller power of the number of springs counts as linear; caches cause some growth.
constexpr double linearPower = 1.2;
constexpr int smallestFitted = 65;

struct Finding {
  std::string_view verdict = notMeasured;
  std::string figure;
};

ReportRows rowsIn(const SectionRows& all, std::string_view section,
                  const std::function<bool(const ReportRow&)>& isMeant) {
  ReportRows rows;
  if (const auto found = all.find(section); found != all.end()) {
    std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(rows), isMeant);
  }
  return rows;
}

std::string_view verdictOf(bool holds) {
  return holds ? confirmed : refuted;
}

bool isFloat(const ReportRow& row) {
  return row.value("precision", "") == "float";
}

Finding linearTime(const SectionRows& all) {
  const ReportRows rows = rowsIn(all, "table1", [](const ReportRow& row) {
    return isFloat(row) && row.value("resolution", 0) >= smallestFitted && numberIn(row, "update_ms") > 0.0;
  });
  std::vector<double> springs;
  std::vector<double> times;
  for (const ReportRow& row : rows) {
    springs.push_back(numberIn(row, "springs"));
    times.push_back(numberIn(row, "update_ms"));
  }
  const double power = fittedExponent(springs, times);
  if (!std::isfinite(power)) {
    return {};
  }
  return {verdictOf(power <= linearPower), "time grows with the number of springs to the power " + text::figure(power) +
                                               ", from " + gridText(rows.front().value("resolution", 0)) + " to " +
                                               gridText(rows.back().value("resolution", 0))};
}

/// The times of Table 1 are from another machine. Those of this one can at most be as short.
Finding table1Times(const SectionRows& all) {
  Finding finding;
  bool holds = true;
  for (const PaperTimes& paper : paperTimes) {
    for (const ReportRow& row : rowsIn(all, "table1", isFloat)) {
      if (row.value("resolution", 0) != paper.resolution) {
        continue;
      }
      const double update = numberIn(row, "update_ms");
      const double self = numberIn(row, "self_collision_ms");
      holds = holds && update <= paper.update && !(self > paper.selfCollision);
      finding.figure += (finding.figure.empty() ? "with " : "; ") + gridText(paper.resolution) + ": update " +
                        text::figure(update) + " ms (paper " + text::figure(paper.update) + "), self-collision " +
                        text::figure(self) + " ms (paper " + text::figure(paper.selfCollision) + ")";
    }
  }
  finding.verdict = finding.figure.empty() ? notMeasured : holds ? confirmed : notTestable;
  finding.figure += finding.verdict == notTestable ? "; slower, but on another machine" : "";
  return finding;
}

/// The free runs of the paper's method with the paper's stiffness that reached all checkpoints. Free fall has no
/// springs at work.
ReportRows paperRuns(const SectionRows& all) {
  return rowsIn(all, "table2", [](const ReportRow& row) {
    return row.value("method", "") == paperMethod && row.value("mode", "") == "free-running" &&
           row.value("start", "") != "free fall" && numberIn(row, "stiffness") == paperStiffness &&
           row.value("checkpoints", 0) == paperCheckpoints && row["eps_max"].is_number();
  });
}

Finding table2Errors(const SectionRows& all) {
  const ReportRows runs = paperRuns(all);
  if (runs.empty()) {
    return {};
  }
  const ReportRow& best = *std::min_element(runs.begin(), runs.end(), [](const ReportRow& a, const ReportRow& b) {
    return numberIn(a, "eps_max") < numberIn(b, "eps_max");
  });
  return {verdictOf(numberIn(best, "eps_max") <= paperLargestEps),
          "the best of " + std::to_string(runs.size()) + " runs with 10 N/m has eps up to " + figure(best, "eps_max") +
              ", " + text::figure(numberIn(best, "eps_max") / paperLargestEps) + " times the paper's"};
}

Finding errorsOverTime(const SectionRows& all) {
  const ReportRows runs = paperRuns(all);
  if (runs.empty()) {
    return {};
  }
  const ReportRow& best = *std::max_element(runs.begin(), runs.end(), [](const ReportRow& a, const ReportRow& b) {
    return a.value("checkpoints_within_paper", 0) < b.value("checkpoints_within_paper", 0);
  });
  const int within = best.value("checkpoints_within_paper", 0);
  return {verdictOf(within == paperCheckpoints), "at most " + std::to_string(within) +
                                                     " of the 25 checkpoints of a run are as good; its smallest S is " +
                                                     figure(best, "S_min")};
}

Finding stableAtLargeSteps(const SectionRows& all) {
  const ReportRows rows = rowsIn(all, "stability", [](const ReportRow& row) {
    return row.value("method", "") == paperMethod && numberIn(row, "step") > largeStep * (1.0 - 1e-6);
  });
  const auto inState = [&](const char* state) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const ReportRow& row) { return row.value("state", "") == state; });
  };
  if (rows.empty()) {
    return {};
  }
  const auto unstable = inState("explodes") + inState("rattles");
  return {verdictOf(unstable == 0), "of " + std::to_string(rows.size()) + " cloths with steps of 1/60 s and more " +
                                        std::to_string(inState("explodes")) + " explode and " +
                                        std::to_string(inState("rattles")) + " rattle"};
}

/// The scene `crush` compresses its springs. Runs with another integration are not the paper's method. Runs without an
/// end or a reference show nothing.
Finding stableUnderCompression(const SectionRows& all) {
  const ReportRows rows = rowsIn(all, "work_precision", [](const ReportRow& row) {
    const std::string state = row.value("state", "");
    return row.value("scene", "") == "crush" && row.value("method", "") == paperMethod &&
           row.value("setting", "").find("integration") == std::string::npos && state != "too slow" &&
           state != "no reference";
  });
  if (rows.empty()) {
    return {};
  }
  const auto exploded = std::count_if(rows.begin(), rows.end(),
                                      [](const ReportRow& row) { return row.value("state", "") == "exploded"; });
  return {verdictOf(exploded == 0), "of " + std::to_string(rows.size()) +
                                        " runs of compressed sheets (scene 'crush') that can be judged " +
                                        std::to_string(exploded) + " explode"};
}

Finding looksOfAir(const SectionRows&) {
  return {notTestable, "the paper shows pictures and no numbers"};
}

struct Claim {
  std::string_view text;
  Finding (*find)(const SectionRows&);
};

constexpr std::array claims{Claim{"An update takes time linear in the number of springs", linearTime},
                            Claim{"Table 1: times of an update and of self-collision", table1Times},
                            Claim{"Table 2: eps of at most 0.000485 (k = 10 N/m)", table2Errors},
                            Claim{"Figs. 7 and 8: eps and S stay this good over 25 checkpoints", errorsOverTime},
                            Claim{"Sufficiently stable at large steps", stableAtLargeSteps},
                            Claim{"No instability under compression", stableUnderCompression},
                            Claim{"Drag and lift look right", looksOfAir}};

}  // namespace

ReportRows claimRows(const SectionRows& all) {
  ReportRows rows;
  for (const Claim& claim : claims) {
    const Finding finding = claim.find(all);
    rows.push_back(
        {{"question", "claim"}, {"claim", claim.text}, {"verdict", finding.verdict}, {"figure", finding.figure}});
  }
  return rows;
}

}  // namespace drape::report::sections
