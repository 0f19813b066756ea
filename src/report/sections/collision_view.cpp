#include "report/sections/collision_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/self_collision_view.hpp"

#include <algorithm>
#include <string>

namespace drape::report::sections {
namespace {

bool hasHash(const ReportRow& row) {
  const std::string mode = row.value("mode", "");
  return mode.size() >= 4 && mode.ends_with("hash");
}

bool hasBodies(const ReportRow& row) {
  return row.value("mode", "").starts_with("bodies");
}

/// The duration of contact relative to the rest of the step [-].
double ratioOf(const ReportRow& row) {
  const double contact = numberIn(row, "contact_us_per_step");
  return contact / (numberIn(row, "us_per_step") - contact);
}

/// A time of a row in ms.
std::string milliseconds(const ReportRow& row, const char* key) {
  return text::figure(1e-3 * numberIn(row, key));
}

TextTable costs(const ReportRows& rows) {
  TextTable table{"Cost of contact",
                  {"scene", "grid", "triangles", "mode", "method", "step [ms]", "contact [ms]", "99 % [ms]",
                   "contact / rest", "bodies [us per 1,000 triangles]"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), sizeText(resolutionIn(row)), figure(row, "triangles", 7),
                          row.value("mode", ""), row.value("method", ""), milliseconds(row, "us_per_step"),
                          milliseconds(row, "contact_us_per_step"), milliseconds(row, "contact_us_p99"),
                          text::figure(ratioOf(row), 2),
                          hasBodies(row) ? figure(row, "bodies_us_per_1000_triangles") : "-"});
  }
  return table;
}

TextTable leaks(const ReportRows& rows) {
  TextTable table{"Remaining intersections",
                  {"scene", "grid", "mode", "seconds", "max contacts", "pairs with bodies", "infeasible vertices",
                   "pairs with itself", "counts with any"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), sizeText(resolutionIn(row)), row.value("mode", ""),
                          figure(row, "seconds"), figure(row, "contacts_max", 5),
                          figure(row, "intersecting_pairs_bodies_max", 5), figure(row, "infeasible_max", 5),
                          figure(row, "intersecting_pairs_self_max", 5), figure(row, "intersecting_share", 2)});
  }
  return table;
}

/// The rows that satisfy the predicate, in descending order of a value.
template <typename Predicate>
ReportRows worstFirst(const ReportRows& rows, const char* key, const Predicate& isMeant) {
  ReportRows chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), isMeant);
  std::stable_sort(chosen.begin(), chosen.end(), [key](const ReportRow& left, const ReportRow& right) {
    return numberIn(left, key) > numberIn(right, key);
  });
  return chosen;
}

/// "sphere (33x33) 4, cape (mesh) 2": the scenes with more than `minimum`.
std::string listOf(const ReportRows& rows, const char* key, double minimum) {
  std::string text;
  for (const ReportRow& row : rows) {
    if (numberIn(row, key) > minimum) {
      text += (text.empty() ? "" : ", ") + sceneText(row) + " " + figure(row, key);
    }
  }
  return text;
}

std::string aboutBodies(const ReportRows& rows) {
  const char* const pairsKey = "intersecting_pairs_bodies_max";
  const std::string through = listOf(worstFirst(rows, pairsKey, hasBodies), pairsKey, 0.0);
  std::string text = through.empty()
                         ? "No cloth triangle ever intersected a body triangle. "
                         : "The cloth intersected a body; the maximum number of pairs at once was: " + through + ". ";
  const char* const costKey = "bodies_us_per_1000_triangles";
  const std::string dear = listOf(worstFirst(rows, costKey, hasBodies), costKey, targetOfBodyContact);
  text += "The target is at most " + text::figure(targetOfBodyContact) + " us for 1,000 triangles in a step; ";
  return text + (dear.empty() ? "all scenes meet it." : "these are above it: " + dear + ".");
}

/// The remaining intersections, "fold (65x65) 27 of 893": the second number is without the method, where it was
/// measured.
std::string leaksOf(const ReportRows& rows) {
  const char* const key = "intersecting_pairs_self_max";
  std::string text;
  for (const ReportRow& row : worstFirst(rows, key, hasHash)) {
    if (!(numberIn(row, key) > 0.0)) {
      continue;
    }
    text += (text.empty() ? "" : ", ") + sceneText(row) + " " + figure(row, key, 5);
    for (const ReportRow& other : rows) {
      const std::string mode = other.value("mode", "");
      if (sceneText(other) == sceneText(row) && (mode == "off" || mode == "bodies")) {
        text += " of " + figure(other, key, 5);
      }
    }
  }
  return text;
}

std::string aboutHash(const ReportRows& rows) {
  const std::string through = leaksOf(rows);
  return std::string(
             "The paper's scheme (hash) compares vertices with vertices. It detects edges that cross between their "
             "ends, and a "
             "vertex over the middle of a triangle, only through nearby vertices. With a thickness of "
             "three quarters of the mean edge a resting layer cannot pass. In a sharp fold the triangles are closer "
             "to each other than the vertices, and ends of one edge never count. Motion that exceeds the "
             "thickness and the search margin between two searches is not detected. When two layers have "
             "crossed, the scheme keeps them crossed. ") +
         (through.empty()
              ? "In these runs nothing passed through."
              : "Remaining pairs of triangles at once, and their number without the scheme: " + through + ".");
}

}  // namespace

std::string sceneText(const ReportRow& row) {
  return row.value("scene", "") + " (" + sizeText(resolutionIn(row)) + ")";
}

std::vector<Block> showCollision(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  std::vector<Block> blocks{
      Paragraph{
          "Scenes with contact, with their own settings. Times are means over all steps of a run of some "
          "seconds, including the first contact, since the search for close pairs does not run in every step. The 99th "
          "percentile is the cost of a step with a search. Intersecting pairs are the maximum that the exact "
          "intersection test found, at every 5th or 10th step."},
      costs(rows), Paragraph{aboutBodies(rows)}, leaks(rows), Paragraph{aboutHash(rows)}};
  if (const std::string exact = aboutExact(rows); !exact.empty()) {
    blocks.emplace_back(selfCollisionTable(rows));
    blocks.emplace_back(Paragraph{exact});
  }
  return blocks;
}

}  // namespace drape::report::sections
