#include "report/number_text.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/validation_picture.hpp"
#include "report/validation/validation_rows.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace drape::report::sections {
namespace {

using validation::MeshKind;
using validation::ValidationCase;

ReportRows measureSeries(const ValidationCase& one, MeshKind kind, bool quick, const CellContext& context) {
  context.checkStop();
  return {validation::validationRow(validation::runValidation(one, kind, validation::resolutionsOf(one, quick)))};
}

SectionPlan planOfValidation(const ReportOptions& options) {
  SectionPlan plan;
  for (const ValidationCase& one : validation::validationTable()) {
    for (const MeshKind kind : validation::kindsOf(one, options.quick)) {
      plan.cells.push_back({one.name + " " + std::string(nameOf(kind)), options.quick ? 0.1 : 1.0,
                            [&one, kind, quick = options.quick](const CellContext& context) {
                              return measureSeries(one, kind, quick, context);
                            }});
    }
  }
  return plan;
}

ReportRows rowsOfGroup(const ReportRows& rows, std::string_view group) {
  ReportRows own;
  std::ranges::copy_if(rows, std::back_inserter(own),
                       [&](const ReportRow& row) { return row.value("group", "") == group; });
  return own;
}

/// The largest error of a case over the kinds of mesh, at one resolution.
struct LargestError {
  double error = 0.0;  // [-]
  double aim = 0.0;    // [-]
  std::string mesh;
};

/// By resolution. A missing equilibrium counts as an infinite error.
using ErrorsByResolution = std::map<int, LargestError>;

void addErrors(const ReportRow& row, ErrorsByResolution& errors) {
  for (const ReportRow& result : row["results"]) {
    LargestError& largest = errors[result.value("resolution", 0)];
    const double error = result["error"].is_number() ? std::abs(result.value("error", 0.0)) : HUGE_VAL;
    if (largest.mesh.empty() || error > largest.error) {
      largest = {error, row.value("aim", 0.0), row.value("mesh", "")};
    }
  }
}

/// One curve for each case: the largest error over the kinds of mesh. A cross and the word "off" mark a case whose
/// error at the finest resolution exceeds the aim.
Plot plotOf(const std::string& group, const ReportRows& rows) {
  Plot plot{"validation-" + group,
            "Errors of the cases: " + group,
            {"cells", Scale::Linear},
            {"largest error of the three kinds of mesh [%]", Scale::Logarithmic},
            {}};
  std::map<std::string, ErrorsByResolution> errors;
  std::vector<std::string> names;  // in the order of the rows
  for (const ReportRow& row : rows) {
    const std::string name = row.value("name", "");
    if (!errors.contains(name)) {
      names.push_back(name);
    }
    addErrors(row, errors[name]);
  }
  for (const std::string& name : names) {
    Curve curve{name, {}};
    for (const auto& [resolution, largest] : errors[name]) {
      curve.points.push_back({.x = static_cast<double>(resolution), .y = 100.0 * largest.error, .note = largest.mesh});
    }
    const LargestError& finest = errors[name].rbegin()->second;
    curve.importance = finest.error / finest.aim;
    if (finest.error > finest.aim) {
      curve.points.back().mark = Mark::Cross;
      curve.label += " (off)";
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

/// One row for each case: the test, the quantity, its exact value and its unit.
TextTable casesOf(const std::string& group, const ReportRows& rows) {
  TextTable table{"The cases: " + group, {"case", "test", "quantity", "exact", "unit"}, {}};
  std::string last;
  for (const ReportRow& row : rows) {
    if (row.value("name", "") != last) {
      last = row.value("name", "");
      const bool range = row["upper"].is_number();
      table.rows.push_back({last, row.value("title", ""), row.value("compared", ""),
                            range ? validation::aimOf(row) : fmt::format("{:.6g}", row.value("exact", 0.0)),
                            row.value("unit", "")});
    }
  }
  return table;
}

TextTable resultsOf(const std::string& group, const ReportRows& rows) {
  TextTable table{"Results: " + group,
                  {"case", "mesh", "cells", "coarse", "middle", "fine", "order", "aim", "time [s]", "result", "remark"},
                  {}};
  for (const ReportRow& row : rows) {
    std::vector<std::string> figures(3, "");
    for (std::size_t i = 0; i < row["results"].size() && i < figures.size(); ++i) {
      figures[i] = validation::figureOf(row, row["results"][i]);
    }
    const bool passed = row.value("passed", false);
    table.rows.push_back({row.value("name", ""), row.value("mesh", ""), validation::cellsOf(row), figures[0],
                          figures[1], figures[2], validation::orderOf(row), validation::aimOf(row),
                          fmt::format("{:.2f}", validation::secondsOf(row)), passed ? "within the aim" : "off",
                          row["results"].empty() ? "" : row["results"].back().value("note", "")});
    table.tones.push_back(passed ? Tone::None : Tone::Bad);
  }
  return table;
}

/// The results whose error exceeds the aim, each with the known reason.
TextTable offOf(const ReportRows& rows) {
  TextTable table{"Beyond the aim", {"case", "mesh", "error", "aim", "known reason"}, {}};
  for (const ReportRow& row : rows) {
    if (!row.value("passed", false) && !row["results"].empty()) {
      const std::string reason = row.value("reason", "");
      table.rows.push_back({row.value("name", ""), row.value("mesh", ""),
                            validation::figureOf(row, row["results"].back()), validation::aimOf(row),
                            reason.empty() ? "Unknown." : reason});
      table.tones.push_back(Tone::Bad);
    }
  }
  return table;
}

std::vector<Block> showValidation(const ReportOptions& options, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  const TextTable off = offOf(rows);
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "Fabric against closed forms of mechanics (docs/guide/validation.md), on three kinds of mesh: grid (parallel "
      "diagonals), alternating (diagonals of alternating direction) and irregular (displaced vertices, random "
      "diagonals). Errors are relative to the closed form. Where the source is a usual range, the table shows the "
      "quantity itself. The aim holds for the finest resolution; a larger error is 'off' and red. These are the "
      "numbers of 'drape-headless validate'" +
      std::string(options.quick ? " --short." : ".")});
  blocks.emplace_back(Paragraph{off.rows.empty()
                                    ? std::string("All results are within their aims.")
                                    : fmt::format("{} of {} results are off.", off.rows.size(), rows.size())});
  if (!off.rows.empty()) {
    blocks.emplace_back(off);
  }
  for (const validation::CaseGroup group : validation::caseGroups) {
    const std::string name(nameOf(group));
    const ReportRows own = rowsOfGroup(rows, name);
    if (!own.empty()) {
      blocks.emplace_back(plotOf(name, own));
      blocks.emplace_back(resultsOf(name, own));
      blocks.emplace_back(casesOf(name, own));
    }
  }
  if (const Drawing picture = pictureOf(rows); !picture.panels.empty()) {
    blocks.emplace_back(picture);
  }
  return blocks;
}

}  // namespace

Section validation() {
  return {"validation", "Validation", planOfValidation, showValidation};
}

}  // namespace drape::report::sections
