#include "report/number_text.hpp"
#include "report/sections/collision_run.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"

#include <array>
#include <cmath>

namespace drape {
namespace {

constexpr double microseconds = 1e6;

/// A scene whose cloth is a grid, and how long it is looked at [s].
struct Folding {
  const char* scene;
  double seconds;
};
constexpr std::array scenes{Folding{"fold", 3.0}};
constexpr std::array modes{"off", "hash"};
/// Steps between two counts of the triangles that intersect.
constexpr int lookEvery = 5;

ReportRows measureCollision(const Folding& folding, const std::string& mode, int resolution,
                            const ReportOptions& options, const CellContext& context) {
  const auto scene =
      gridScene(folding.scene, resolution, {"self_collision=" + mode, "threads=" + std::to_string(options.threads)});
  const CollisionRun run = runCollision(*scene, folding.seconds, lookEvery, context.mayStop);
  return {{{"scene", folding.scene},
           {"resolution", resolution},
           {"vertices", scene->model->vertexCount()},
           {"triangles", scene->model->triangles.size()},
           {"mode", mode},
           {"steps", run.steps},
           {"us_per_step", finiteOrNull(microseconds * run.stepSeconds)},
           {"contact_us_per_step", finiteOrNull(microseconds * run.contactSeconds)},
           {"contact_us_p99", finiteOrNull(microseconds * run.longestContact)},
           {"contacts_max", run.contacts},
           {"intersecting_pairs_max", run.intersectingPairs},
           {"intersecting_share", finiteOrNull(run.intersectingShare)},
           {"finite", run.finite}}};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  const std::vector<int> sizes = options.quick ? std::vector{17, 33} : std::vector{17, 33, 65};
  for (const Folding& folding : scenes) {
    for (const int resolution : sizes) {
      for (const std::string mode : modes) {
        plan.cells.push_back({std::string(folding.scene) + " " + gridText(resolution) + " " + mode,
                              2e-4 * resolution * resolution,
                              [&folding, mode, resolution, options](const CellContext& context) {
                                return measureCollision(folding, mode, resolution, options, context);
                              }});
      }
    }
  }
  return plan;
}

/// How much longer contact takes than the rest of the step [-].
double ratioOf(const ReportRow& row) {
  const double contact = numberIn(row, "contact_us_per_step");
  return contact / (numberIn(row, "us_per_step") - contact);
}

TextTable tableOf(const ReportRows& rows) {
  TextTable table{"Self-collision",
                  {"scene", "grid", "triangles", "mode", "step [us]", "of that contact [us]", "99 % [us]",
                   "contact / rest", "contacts", "intersecting pairs", "looks with any"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), gridText(row.value("resolution", 0)), figure(row, "triangles", 7),
                          row.value("mode", ""), figure(row, "us_per_step"), figure(row, "contact_us_per_step"),
                          figure(row, "contact_us_p99"), figure(ratioOf(row), 2), figure(row, "contacts_max", 5),
                          figure(row, "intersecting_pairs_max", 5), figure(row, "intersecting_share", 2)});
  }
  return table;
}

std::vector<Block> show(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  return {
      Paragraph{"The paper's scheme (mode hash) against none. Times are means over all steps of a run of some "
                "seconds, first contact included, since a search for near pairs comes only now and then; the 99th "
                "percentile tells what a step with a search takes. Intersecting pairs are the most triangle pairs of "
                "the cloth that an exact judge found at any " +
                std::to_string(lookEvery) + "th step, contacts the most in a step."},
      tableOf(rows),
      Paragraph{"The scheme compares vertices with vertices. Edges that cross between their ends, and a vertex over "
                "the middle of a triangle, are seen only through the vertices near them: with a thickness of three "
                "quarters of the mean edge a resting layer cannot pass, but a sharp fold has its triangles nearer to "
                "each other than its vertices are, where ends of one edge never count. What moves farther than the "
                "thickness and the margin of the search between two looks passes unseen, and once two layers have "
                "crossed, the scheme holds them where they are. The column of intersecting pairs is what it let "
                "through here."}};
}

}  // namespace

Section sections::collision() {
  return {"collision", "Collision", plan, show};
}

}  // namespace drape
