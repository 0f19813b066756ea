#include "report/number_text.hpp"
#include "report/sections/budget_choice.hpp"
#include "report/sections/budget_cloth.hpp"
#include "report/sections/budget_curves.hpp"
#include "report/sections/cloth_with_reference.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/work_rows.hpp"
#include "settings/settings_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace drape::report::sections {
namespace {

constexpr double millimetres = 1e3;

/// The largest budget of the report's own cloth with contact, which no setting simulates in real time [ms per frame].
constexpr double largestBudget = 100.0;

/// The T-shirt of the scene mannequin in cotton, on the mannequin.
BudgetCloth garmentOnBody(const ReportOptions& options) {
  scene::SceneDescription description = scene::openScene("mannequin");
  for (const char* setting : {"material.model=fabric", "material.preset=cotton", "fabric.own_density=on",
                              "time_step=1/150", "substeps=1", "solver=auto", "self_collision=exact"}) {
    settings::assignSettingExpression(description.settings, setting);
  }
  BudgetCloth cloth;
  cloth.kind = "garment on a body";
  cloth.name = description.name;
  cloth.scene = scene::buildScene(description, description.settings);
  cloth.checkpoints = options.quick ? checkpointsIn(0.1) : measuredCheckpoints;
  cloth.maxCost = options.quick ? 1000.0 : largestBudget;
  cloth.referenceSeconds = options.quick ? 1.5 : 20.0;
  return cloth;
}

BudgetCloth ownCloth(const ReportOptions& options) {
  BudgetCloth cloth;
  cloth.kind = "own";
  cloth.name = options.own->scene->description.name;
  cloth.scene = options.own->scene;
  cloth.checkpoints = checkpointsIn(options.own->seconds);
  cloth.maxCost = options.own->budget;
  cloth.referenceSeconds = options.quick ? 5.0 : 60.0;
  return cloth;
}

SectionPlan plan(const ReportOptions& options) {
  const auto cloth = std::make_shared<BudgetCloth>(options.own ? ownCloth(options) : garmentOnBody(options));
  cloth->scene = withSettledContact(*cloth->scene, {"threads=" + std::to_string(options.own ? options.threads : 1)});
  const bool few = options.quick && !options.own;
  SectionPlan plan;
  for (const MethodCurve& curve : budgetCurves(*cloth->scene)) {
    for (const std::string& value : few ? curve.quick : curve.values) {
      plan.cells.push_back({cloth->kind + ", " + cloth->name + ": " + curve.label + " " + value, few ? 1.0 : 1.5,
                            [=](const CellContext& context) -> ReportRows {
                              return {measureBudgetSetting(*cloth, curve, value, context)};
                            }});
    }
  }
  return plan;
}

std::string titleOfCloth(const ReportRow& row) {
  return row.value("scene", "") + " (" + figure(row, "vertices", 7) +
         " vertices, contact: " + row.value("contact", "") + ")";
}

Plot plotOf(const ReportRows& rows) {
  Plot plot{"budget-" + std::string(rows.front().value("kind", "") == "own" ? "own" : "garment"),
            titleOfCloth(rows.front()) + ", after " + figure(rows.front(), "time") + " s",
            {"time per frame of 1/60 s, with contact [ms]", Scale::Logarithmic},
            {"mean error [mm]", Scale::Logarithmic},
            {}};
  for (const ReportRow& row : rows) {
    PlotPoint point{msPerFrame(numberIn(row, "us_per_simulated_second")), millimetres * numberIn(row, "error_mean")};
    const std::string state = row.value("state", "");
    point.note = takeText(row) + ": " + state;
    if (state == "exploded") {
      point.y = std::numeric_limits<double>::infinity();
      point.mark = Mark::Cross;
    } else if (state == "frozen") {
      point.mark = Mark::Hollow;
    }
    curveLabelled(row.value("curve", ""), plot).points.push_back(point);
  }
  for (Curve& curve : plot.curves) {
    for (const PlotPoint& point : curve.points) {
      curve.importance = point.y > 0.0 ? std::max(curve.importance, 1.0 / point.y) : curve.importance;
    }
  }
  plot.curves.push_back({"two starts part by", {}, CurveStyle::Level});
  for (const ReportRow& row : rows) {
    plot.curves.back().points.push_back(
        {plot.curves.front().points.front().x, millimetres * numberIn(row, "noise_floor")});
  }
  return plot;
}

TextTable tableOf(const ReportRows& rows) {
  TextTable table{"All settings",
                  {"method", "setting", "ms a frame", "mean error [mm]", "largest error [mm]", "% of the diagonal",
                   "motion kept", "state"},
                  {}};
  for (const ReportRow& row : rows) {
    constexpr double percent = 100.0;
    table.rows.push_back({row.value("method", ""), row.value("setting", ""), frameCost(row),
                          text::figure(millimetres * numberIn(row, "error_mean")),
                          text::figure(millimetres * numberIn(row, "error_max")),
                          text::figure(percent * numberIn(row, "error_of_diagonal"), 2), figure(row, "motion_kept"),
                          row.value("state", "")});
  }
  return table;
}

/// A row whose reference is known; the end if there is none.
ReportRows::const_iterator rowWithReference(const ReportRows& rows) {
  return std::find_if(rows.begin(), rows.end(),
                      [](const ReportRow& row) { return row["reference_difference"].is_number(); });
}

/// How well the true motion is known, in words.
std::string referenceText(const ReportRows& rows) {
  const auto found = rowWithReference(rows);
  if (found == rows.end()) {
    return "Small steps blew up on this cloth, or would take too long, so there is no reference. No error is known, "
           "and no method can be recommended; the table has the costs.";
  }
  const ReportRow& row = *found;
  std::string text =
      "Errors are distances of the vertices from a converged run with the same contact, Verlet in steps of " +
      stepText(numberIn(row, "reference_step")) + "; the last halving of its step moved the cloth by " +
      distanceText(numberIn(row, "reference_difference")) + " (mean). ";
  text += row["noise_floor"].is_number()
              ? "Two starts that differ by a micrometre part by " + distanceText(numberIn(row, "noise_floor")) +
                    " in " + figure(row, "time") + " s: smaller errors cannot be told apart."
              : "Two starts that differ by a micrometre do not both arrive.";
  return text;
}

bool anyErrorIsKnown(const ReportRows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ReportRow& row) { return row["error_mean"].is_number(); });
}

/// A warning if the choice hardly moves, which cloth that hardly moves in the measured time does not show.
std::string motionText(const ReportRow& best) {
  constexpr double enough = 0.5;
  constexpr double percent = 100.0;
  const double kept = numberIn(best, "motion_kept");
  return kept < enough ? " It moved only " + text::figure(percent * kept, 2) +
                             " % as far as the converged run, which moved too little to choose by. Measure a longer "
                             "motion (--seconds)."
                       : "";
}

/// The setting to take for a budget, in words.
std::string choiceText(const ReportRows& rows, double budget) {
  const std::string within = text::figure(budget) + " ms a frame";
  const ReportRow* best = bestForBudget(rows, budget);
  if (best == nullptr) {
    const ReportRow* cheapest = cheapestCalm(rows);
    return "No setting with a known error keeps within " + within +
           (cheapest == nullptr
                ? ". Give a larger budget, a coarser mesh or a softer material."
                : "; the cheapest, " + takeText(*cheapest) + ", takes " + frameCost(*cheapest) + " ms.");
  }
  constexpr double percent = 100.0;
  return "For " + within + " take " + takeText(*best) + ". It costs " + frameCost(*best) + " ms a frame, and after " +
         figure(*best, "time") + " s of motion it is off by " + errorText(*best, errorFloor(rows)) +
         " (mean; largest " + distanceText(numberIn(*best, "error_max")) + "), " +
         text::figure(percent * numberIn(*best, "error_of_diagonal"), 2) + " % of the cloth's diagonal." +
         motionText(*best);
}

/// The budgets in ascending order [ms per frame].
std::vector<double> budgetsOf(const ReportOptions& options) {
  if (options.own) {
    return {options.own->budget};
  }
  std::vector<double> budgets = frameBudgets();
  budgets.push_back(largestBudget);
  return budgets;
}

/// Leaves out budgets that no setting keeps, except the largest one.
std::vector<Block> show(const ReportOptions& options, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  std::vector<Block> blocks;
  const std::vector<double> budgets = budgetsOf(options);
  for (const double budget : budgets) {
    const bool says = bestForBudget(rows, budget) != nullptr || budget == budgets.back();
    if (says && rowWithReference(rows) != rows.end()) {
      blocks.emplace_back(Paragraph{choiceText(rows, budget)});
    }
  }
  blocks.emplace_back(Paragraph{referenceText(rows)});
  blocks.emplace_back(Paragraph{
      "The cloth is " + titleOfCloth(rows.front()) +
      ". Costs are computing times of whole steps, contact included, without the first step. A setting that exceeds "
      "the largest budget is stopped (too slow). Exploded: not finite, or farther from the reference than the diagonal "
      "of the cloth. Frozen: less than half of the reference's motion."});
  Plot plot = plotOf(rows);
  if (anyErrorIsKnown(rows)) {
    blocks.emplace_back(std::move(plot));
  }
  blocks.emplace_back(tableOf(rows));
  return blocks;
}

}  // namespace

Section budget() {
  return {budgetSection, "Cloth with contact: errors for a time budget", plan, show};
}

}  // namespace drape::report::sections
