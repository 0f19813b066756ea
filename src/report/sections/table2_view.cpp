#include "report/sections/table2_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/table2_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace drape::report::sections {
namespace {

/// The contents of one plot: the runs of a method on one mesh.
struct Pane {
  std::string method;
  int resolution;
  std::string mode;
};

bool isIn(const ReportRow& row, const Pane& pane) {
  return row.value("method", "") == pane.method && row.value("resolution", 0) == pane.resolution &&
         row.value("mode", "") == pane.mode;
}

/// Rows with the default conditions: 0.1 kg, 10 N/m, neither damping nor air.
bool isPlain(const ReportRow& row) {
  return row.value("losses", "") == "none" && numberIn(row, "stiffness") == 10.0 && numberIn(row, "mass") > 0.075;
}

std::string polygons(int resolution) {
  return std::to_string(2 * (resolution - 1) * (resolution - 1)) + " polygons";
}

Plot plotOf(const ReportRows& rows, const Pane& pane, bool isEps) {
  Plot plot{"table2-" + std::string(isEps ? "eps-" : "S-") + pane.method + "-" + std::to_string(pane.resolution) + "-" +
                pane.mode,
            std::string(isEps ? "eps" : "S") + ", " + polygons(pane.resolution) + ", " + pane.method + ", " + pane.mode,
            {"checkpoint (1/30 s)"},
            {isEps ? "eps" : "S", isEps ? Scale::Logarithmic : Scale::Linear},
            {}};
  for (const ReportRow& row : rows) {
    if (!isIn(row, pane) || !isPlain(row)) {
      continue;
    }
    Curve curve{row.value("start", ""), {}};
    const ReportRow& values = row[isEps ? "eps" : "S"];
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double value = values[k].is_number() ? values[k].get<double>() : std::numeric_limits<double>::quiet_NaN();
      curve.points.push_back({static_cast<double>(k + 1), value});
    }
    plot.curves.push_back(curve);
  }
  if (isEps) {
    plot.curves.push_back({"paper's largest", {{1.0, paperLargestEps}}, CurveStyle::Level});
  }
  return plot;
}

/// @param isPlainOnly all rows share mass, stiffness and losses, so these columns are omitted
TextTable tableOf(const std::string& title, const ReportRows& rows, bool isPlainOnly) {
  TextTable table{title,
                  {"start", "polygons", "method", "mode", "largest eps", "mean eps", "smallest S", "mean S",
                   "within the paper's", "reference off [mm]"},
                  {}};
  if (!isPlainOnly) {
    table.header.insert(table.header.end(), {"losses", "kg", "N/m", "checkpoints"});
  }
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("start", ""), figure(row, "polygons", 6), row.value("method", ""),
                          row.value("mode", ""), figure(row, "eps_max"), figure(row, "eps_mean"), figure(row, "S_min"),
                          figure(row, "S_mean"), figure(row, "checkpoints_within_paper"),
                          text::figure(1e3 * numberIn(row, "reference_error_mean"))});
    if (!isPlainOnly) {
      for (const std::string& field :
           {row.value("losses", ""), figure(row, "mass"), figure(row, "stiffness", 6), figure(row, "checkpoints")}) {
        table.rows.back().push_back(field);
      }
    }
  }
  return table;
}

/// The row of the method and mode with the smallest maximum of eps, among those that reached the last checkpoint.
const ReportRow* nearest(const ReportRows& rows, const std::string& method, const std::string& mode) {
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    const bool counts = row.value("start", "") != "free fall" && row.value("method", "") == method &&
                        row.value("mode", "") == mode && row.value("checkpoints", 0) == 25 &&
                        row["eps_max"].is_number();
    if (counts && (best == nullptr || numberIn(row, "eps_max") < numberIn(*best, "eps_max"))) {
      best = &row;
    }
  }
  return best;
}

std::string nearestText(const ReportRows& rows, const std::string& method, const std::string& mode) {
  const ReportRow* row = nearest(rows, method, mode);
  if (row == nullptr) {
    return "";
  }
  return "Of the " + mode + " runs of " + method + ", '" + row->value("start", "") + "' with " + figure(*row, "mass") +
         " kg, " + figure(*row, "stiffness", 6) + " N/m, losses: " + row->value("losses", "") + ", " +
         figure(*row, "polygons", 6) + " polygons comes closest, with eps of at most " + figure(*row, "eps_max") +
         ", " + text::figure(numberIn(*row, "eps_max") / paperLargestEps) + " times the paper's; " +
         figure(*row, "checkpoints_within_paper") + " of its 25 checkpoints are within it. ";
}

std::string inPlainWords(const ReportRows& rows) {
  std::string text =
      "The paper prints eps of at most 0.000485. Its stiffness is k = 10 (N/m), its mass once 0.05 and once 0.1 kg. It "
      "does not give the start, the pins and the damping of its cloth. ";
  for (const char* method : {"one_iteration", "pcg"}) {
    for (const char* mode : {"free-running", "restarted"}) {
      text += nearestText(rows, method, mode);
    }
  }
  const bool any = std::any_of(rows.begin(), rows.end(), [](const ReportRow& row) {
    return row.value("start", "") != "free fall" && row.value("checkpoints", 0) == 25 && row["eps_max"].is_number() &&
           numberIn(row, "eps_max") <= paperLargestEps;
  });
  text += any ? "So its values are possible, under the conditions where eps is at most that. "
              : "So none of these conditions gives its values. ";
  return text +
         "From rest they are impossible: in the first interval the cloth falls freely, and backward Euler with five "
         "steps falls (5 + 1) / 5 as far as the true motion. This is an eps of 0.04 for any cloth. pcg solves the "
         "system of each step, so its error is that of backward Euler. One sweep is slower still "
         "(docs/theory/method.md, Limits).";
}

std::string referenceText(const ReportRows& rows) {
  std::set<std::string> lost;
  for (const ReportRow& row : rows) {
    if (row.value("reference_checkpoints", 0) < 25) {
      lost.insert(figure(row, "stiffness", 6) + " N/m, " + figure(row, "mass") + " kg, " + figure(row, "polygons", 6) +
                  " polygons, losses: " + row.value("losses", ""));
    }
  }
  std::string text =
      "The reference is the paper's, explicit Euler with 1/30000 s. It gains energy at every step of an undamped cloth "
      "(docs/theory/method.md). The last column is its distance, at its last checkpoint, from Verlet with the same "
      "step, "
      "which is nearly exact.";
  if (!lost.empty()) {
    text += " It blew up before the last checkpoint with";
    for (const std::string& one : lost) {
      text += (one == *lost.begin() ? " " : "; ") + one;
    }
    text += ".";
  }
  return text;
}

}  // namespace

std::vector<Block> showTable2(const ReportOptions&, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "eps (relative squared displacement error) and S (squared cosine) from checkpoint to checkpoint, 25 of them 1/30 "
      "s "
      "apart, steps of 1/150 s, in double (docs/theory/measures.md). Free-running is one continuous run; restarted "
      "begins each "
      "interval where the reference is. Damping is 0.01 N s/m, air a drag of 0.5 and a lift of 0.3."});
  std::string starts = "The starts:";
  for (const Table2Start& start : table2Starts()) {
    starts += (starts.ends_with(':') ? " '" : "; '") + start.name + "' " + start.help;
  }
  blocks.emplace_back(Paragraph{starts + "."});
  blocks.emplace_back(Paragraph{inPlainWords(rows)});
  blocks.emplace_back(Paragraph{referenceText(rows)});
  for (const int resolution : {17, 33}) {
    for (const char* method : {"one_iteration", "pcg"}) {
      for (const char* mode : {"free-running", "restarted"}) {
        const Pane pane{method, resolution, mode};
        for (const bool isEps : {true, false}) {
          Plot plot = plotOf(rows, pane, isEps);
          if (plot.curves.size() > (isEps ? 1U : 0U)) {
            blocks.emplace_back(std::move(plot));
          }
        }
      }
    }
  }
  ReportRows plain;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(plain), isPlain);
  blocks.emplace_back(tableOf("0.1 kg, 10 N/m, neither damping nor air", plain, true));
  TextTable all = tableOf("All runs", rows, false);
  all.folded = true;
  blocks.emplace_back(std::move(all));
  return blocks;
}

}  // namespace drape::report::sections
