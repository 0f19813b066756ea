#include "report/sections/collision_view.hpp"

#include "report/number_text.hpp"

#include <algorithm>
#include <string>

namespace drape {
namespace {

/// What body contact may take for 1,000 triangles in a step, on one core [us].
constexpr double target = 300.0;

bool hasHash(const ReportRow& row) {
  const std::string mode = row.value("mode", "");
  return mode.size() >= 4 && mode.ends_with("hash");
}

bool hasBodies(const ReportRow& row) {
  return row.value("mode", "").starts_with("bodies");
}

std::string sizeText(const ReportRow& row) {
  return row["resolution"].is_number() ? gridText(row["resolution"].get<int>()) : "mesh";
}

std::string nameOf(const ReportRow& row) {
  return row.value("scene", "") + " (" + sizeText(row) + ")";
}

/// How many times as long contact takes as the rest of the step [-].
double ratioOf(const ReportRow& row) {
  const double contact = numberIn(row, "contact_us_per_step");
  return contact / (numberIn(row, "us_per_step") - contact);
}

TextTable costs(const ReportRows& rows) {
  TextTable table{"What contact costs",
                  {"scene", "grid", "triangles", "mode", "method", "step [us]", "of that contact [us]", "99 % [us]",
                   "contact / rest", "bodies [us a 1,000 triangles]"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), sizeText(row), figure(row, "triangles", 7), row.value("mode", ""),
                          row.value("method", ""), figure(row, "us_per_step"), figure(row, "contact_us_per_step"),
                          figure(row, "contact_us_p99"), figure(ratioOf(row), 2),
                          hasBodies(row) ? figure(row, "bodies_us_per_1000_triangles") : "-"});
  }
  return table;
}

TextTable leaks(const ReportRows& rows) {
  TextTable table{"What it lets through",
                  {"scene", "grid", "mode", "seconds", "most contacts", "pairs with bodies", "vertices squeezed",
                   "pairs with itself", "looks with any"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), sizeText(row), row.value("mode", ""), figure(row, "seconds"),
                          figure(row, "contacts_max", 5), figure(row, "intersecting_pairs_bodies_max", 5),
                          figure(row, "infeasible_max", 5), figure(row, "intersecting_pairs_self_max", 5),
                          figure(row, "intersecting_share", 2)});
  }
  return table;
}

/// The rows for which that holds, by a figure, the largest first.
template <typename Predicate>
ReportRows worstFirst(const ReportRows& rows, const char* key, const Predicate& isMeant) {
  ReportRows chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), isMeant);
  std::stable_sort(chosen.begin(), chosen.end(), [key](const ReportRow& left, const ReportRow& right) {
    return numberIn(left, key) > numberIn(right, key);
  });
  return chosen;
}

/// "sphere (33x33) 4, cape (mesh) 2": those with more than `least`.
std::string listOf(const ReportRows& rows, const char* key, double least) {
  std::string text;
  for (const ReportRow& row : rows) {
    if (numberIn(row, key) > least) {
      text += (text.empty() ? "" : ", ") + nameOf(row) + " " + figure(row, key);
    }
  }
  return text;
}

std::string aboutBodies(const ReportRows& rows) {
  const char* const pairsKey = "intersecting_pairs_bodies_max";
  const std::string through = listOf(worstFirst(rows, pairsKey, hasBodies), pairsKey, 0.0);
  std::string text = through.empty() ? "No triangle of the cloth ever intersected one of a body. "
                                     : "The cloth intersected a body, at most so many pairs at once: " + through + ". ";
  const char* const costKey = "bodies_us_per_1000_triangles";
  const std::string dear = listOf(worstFirst(rows, costKey, hasBodies), costKey, target);
  text += "The aim is at most " + figure(target) + " us for 1,000 triangles in a step; ";
  return text + (dear.empty() ? "all scenes keep it." : "above it are " + dear + ".");
}

/// What the scheme let through, "fold (65x65) 27 of 893": of those that there are without it, where that was measured.
std::string leaksOf(const ReportRows& rows) {
  const char* const key = "intersecting_pairs_self_max";
  std::string text;
  for (const ReportRow& row : worstFirst(rows, key, hasHash)) {
    if (!(numberIn(row, key) > 0.0)) {
      continue;
    }
    text += (text.empty() ? "" : ", ") + nameOf(row) + " " + figure(row, key, 5);
    for (const ReportRow& other : rows) {
      if (nameOf(other) == nameOf(row) && !hasHash(other)) {
        text += " of " + figure(other, key, 5);
      }
    }
  }
  return text;
}

std::string aboutHash(const ReportRows& rows) {
  const std::string through = leaksOf(rows);
  return std::string(
             "The paper's scheme (hash) compares vertices with vertices. Edges that cross between their ends, and a "
             "vertex over the middle of a triangle, are seen only through the vertices near them: with a thickness of "
             "three quarters of the mean edge a resting layer cannot pass, but a sharp fold has its triangles nearer "
             "to each other than its vertices are, where ends of one edge never count. What moves farther than the "
             "thickness and the margin of the search between two looks passes unseen, and once two layers have "
             "crossed, the scheme holds them where they are. ") +
         (through.empty() ? "In these runs it let nothing through."
                          : "Here it let through, in pairs of triangles at once, of those that there are without it: " +
                                through + ".");
}

}  // namespace

std::vector<Block> showCollision(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  return {Paragraph{"Scenes with contact, under their own settings. Times are means over all steps of a run of some "
                    "seconds, first contact included, since a search for near pairs comes only now and then; the 99th "
                    "percentile tells what a step with a search takes. Intersecting pairs are the most that an exact "
                    "judge found whenever it looked, every 5th or 10th step."},
          costs(rows), Paragraph{aboutBodies(rows)}, leaks(rows), Paragraph{aboutHash(rows)}};
}

}  // namespace drape
