#include "report/number_text.hpp"
#include "report/sections/collision_run.hpp"
#include "report/sections/collision_view.hpp"
#include "report/sections/method_curves.hpp"
#include "report/sections/pareto.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/self_collision_view.hpp"
#include "report/sections/stability_rule.hpp"
#include "report/sections/work_precision_view.hpp"
#include "report/sections/work_rows.hpp"
#include "sim/solvers/solver.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drape::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const Section& sectionOf(std::string_view name) {
  const auto table = sectionTable();
  return *std::find_if(table.begin(), table.end(), [name](const Section& section) { return section.name == name; });
}

/// The rows of the cell with that key in a quick report, after this number of rounds.
ReportRows measured(std::string_view section, const std::string& key, int rounds = 1) {
  ReportOptions options;
  options.quick = true;
  const SectionPlan plan = sectionOf(section).plan(options);
  const auto cell =
      std::find_if(plan.cells.begin(), plan.cells.end(), [&key](const Cell& one) { return one.key == key; });
  EXPECT_NE(cell, plan.cells.end()) << key;
  ReportRows rows;
  for (int round = 0; round < rounds && cell != plan.cells.end(); ++round) {
    rows = cell->measure({rows, rows});
  }
  return rows;
}

/// The first block of that type.
template <typename Kind>
const Kind* firstOf(const std::vector<Block>& blocks) {
  for (const Block& block : blocks) {
    if (const Kind* found = std::get_if<Kind>(&block)) {
      return found;
    }
  }
  return nullptr;
}

TEST(ParetoFront, hasTheEntriesThatNoOtherBeats) {
  const std::array entries{sections::CostAndError{3.0, 1.0}, sections::CostAndError{1.0, 5.0},
                           sections::CostAndError{2.0, 5.0}, sections::CostAndError{1.0, 6.0},
                           sections::CostAndError{4.0, 0.5}, sections::CostAndError{5.0, 0.7},
                           sections::CostAndError{0.5, none}};
  EXPECT_EQ(sections::paretoFront(entries), (std::vector<std::size_t>{1, 0, 4}));
  EXPECT_TRUE(sections::paretoFront({}).empty());
}

TEST(MethodCurves, haveEverySolver) {
  const auto curves = sections::methodCurves();
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    EXPECT_TRUE(std::any_of(curves.begin(), curves.end(), [&](const sections::MethodCurve& c) {
      return c.method == solver.name;
    })) << solver.name;
  }
}

TEST(MethodCurves, haveSettingsThatCanBeSet) {
  const auto scene = testing::smallGrid();
  for (const sections::MethodCurve& curve : sections::methodCurves()) {
    std::vector<std::string> values = curve.values;
    values.insert(values.end(), curve.quick.begin(), curve.quick.end());
    for (const std::string& value : values) {
      std::vector<std::string> all{"solver=" + curve.method, curve.varied + "=" + value};
      all.insert(all.end(), curve.fixed.begin(), curve.fixed.end());
      EXPECT_NO_THROW((void)sections::changedSettings(*scene, all)) << curve.label << " " << value;
    }
  }
}

TEST(WorkPrecision, distinguishesCalmFrozenAndExploded) {
  ErrorSummary summary;
  summary.motionKept = 0.9;
  summary.meanError = 0.01;
  EXPECT_EQ(sections::stateOf(true, summary, 1.4), "calm");
  EXPECT_EQ(sections::stateOf(false, summary, 1.4), "exploded");
  summary.meanError = 1.5;
  EXPECT_EQ(sections::stateOf(true, summary, 1.4), "exploded");
  summary.meanError = 0.5;
  summary.motionKept = 0.49;
  EXPECT_EQ(sections::stateOf(true, summary, 1.4), "frozen");
  summary.motionKept = none;
  EXPECT_EQ(sections::stateOf(true, summary, 1.4), "exploded");
}

TEST(WorkPrecision, findsVerletMoreExactWithMoreSubstepsAndExplodedBeyondItsLimit) {
  const ReportRows beyond = measured("work_precision", "hang 17x17 10 N/m, verlet substeps=1");
  const ReportRows two = measured("work_precision", "hang 17x17 10 N/m, verlet substeps=4");
  const ReportRows sixteen = measured("work_precision", "hang 17x17 10 N/m, verlet substeps=16");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(beyond[1]["state"], "exploded");
  EXPECT_EQ(sixteen[1]["state"], "calm");
  EXPECT_LT(10.0 * sixteen[0]["error_mean"].get<double>(), two[0]["error_mean"]);  // second order: 16 times
  EXPECT_TRUE(sixteen[1]["trusted"]);
}

TEST(WorkPrecision, findsTheOrderOfASolverOnAFabric) {
  const ReportRow coarse =
      measured("work_precision", "hang 9x9 jersey, newton substeps=1 tolerance=1e-6 derivative=exact max_iterations=50")
          .at(0);
  const ReportRow fine = measured("work_precision", "hang 9x9 jersey, verlet substeps=16").at(0);
  ASSERT_TRUE(fine["trusted"]);
  EXPECT_EQ(fine["state"], "calm");
  EXPECT_EQ(fine["material"], "jersey");
  EXPECT_TRUE(fine["stiffness"].is_null());
  // The damping acts once in a step of 1/150 s, in the reference more often.
  EXPECT_LT(fine["error_mean"].get<double>(), 1e-4);
  EXPECT_GT(coarse["error_mean"].get<double>(), 20.0 * fine["error_mean"].get<double>());
}

TEST(WorkPrecision, namesFabricsAndMeshesInItsTitles) {
  ReportRow row{
      {"scene", "tshirt"}, {"resolution", nullptr}, {"material", "cotton"}, {"stiffness", nullptr}, {"time", 0.5}};
  EXPECT_EQ(sections::clothOf(row), "tshirt, mesh, cotton, 0.5 s");
  row["resolution"] = 17;
  row["stiffness"] = 1e5;
  row["material"] = "springs";
  EXPECT_EQ(sections::clothOf(row), "tshirt, 17x17, 100000 N/m, 0.5 s");
}

TEST(WorkPrecision, addsASampleOfTimeInEachRoundAndKeepsTheError) {
  const std::string key = "hang 17x17 10 N/m, one_iteration substeps=1";
  const ReportRows once = measured("work_precision", key, 1);
  const ReportRows thrice = measured("work_precision", key, 3);
  EXPECT_EQ(once[0]["samples"].size(), 1U);
  EXPECT_EQ(thrice[0]["samples"].size(), 3U);
  EXPECT_EQ(thrice[1]["error_mean"], once[1]["error_mean"]);
  EXPECT_GT(once[1]["us_per_simulated_second"], 0.0);
  EXPECT_EQ(once[0]["time"], 0.2);
  EXPECT_EQ(once[1]["time"], 0.5);
}

TEST(WorkPrecision, drawsAndNamesItsFront) {
  ReportRows rows;
  for (const auto& [setting, cost, error, state] :
       {std::tuple("substeps=1", 1.0, 0.3, "calm"), std::tuple("substeps=2", 2.0, 0.1, "calm"),
        std::tuple("substeps=3", 0.5, 0.01, "frozen"), std::tuple("substeps=4", 3.0, 0.2, "calm")}) {
    rows.push_back({{"scene", "grid"},
                    {"resolution", 17},
                    {"material", "springs"},
                    {"stiffness", 10.0},
                    {"time", 0.2},
                    {"method", "verlet"},
                    {"curve", "Verlet"},
                    {"setting", setting},
                    {"us_per_simulated_second", cost},
                    {"error_mean", error},
                    {"state", state},
                    {"trusted", true}});
  }
  const auto blocks = sections::showWorkPrecision({}, rows);
  const auto* plot = firstOf<Plot>(blocks);
  ASSERT_NE(plot, nullptr);
  const Curve& drawn = plot->curves.at(plot->curves.size() - 2);
  EXPECT_EQ(drawn.style, CurveStyle::Front);
  EXPECT_EQ(drawn.points.size(), 2U);
  EXPECT_EQ(plot->curves.back().style, CurveStyle::Level);  // the noise floor
  const auto* front = firstOf<TextTable>(blocks);
  ASSERT_NE(front, nullptr);
  ASSERT_EQ(front->rows.size(), 2U);
  EXPECT_EQ(front->rows[1][1], "substeps=2");
}

TEST(Stability, hasFourStates) {
  EXPECT_EQ(sections::stabilityState({true, 0.0, 1.0}), "calm");
  EXPECT_EQ(sections::stabilityState({true, 0.1, 1.0}), "rattles");
  EXPECT_EQ(sections::stabilityState({true, 11.0, 1.0}), "explodes");
  EXPECT_EQ(sections::stabilityState({true, none, 1.0}), "explodes");
  EXPECT_EQ(sections::stabilityState({false, 0.0, 1.0}), "explodes");
  EXPECT_EQ(sections::stabilityState({true, 0.0, 0.4}), "frozen");
}

TEST(Stability, findsVerletCalmOrExplodedByItsLimit) {
  EXPECT_EQ(measured("stability", "verlet 17x17 1000 N/m 1/150 s").at(0)["state"], "explodes");
  const auto kang = measured("stability", "kang 17x17 1000 N/m 1/30 s").at(0);
  EXPECT_EQ(kang["state"], "frozen") << kang;
  const auto newton = measured("stability", "one_iteration 17x17 10 N/m 1/150 s").at(0);
  EXPECT_EQ(newton["state"], "calm") << newton;
}

TEST(Growth, findsTheStepsThatVerletNeeds) {
  const auto row = measured("growth", "verlet 17x17").at(0);
  EXPECT_GE(row["substeps"], 5);  // the limit is 1/240 s with 10 N/m, and sqrt(10) times less with the scene's 100
  EXPECT_LE(row["substeps"], 7);
  EXPECT_GT(row["step_us"], 0.0);
  EXPECT_EQ(row["finite"], true);
}

TEST(Growth, leavesOutGridsThatWouldTakeTooLong) {
  ReportOptions options;
  options.quick = true;
  const SectionPlan plan = sectionOf("growth").plan(options);
  const auto cell =
      std::find_if(plan.cells.begin(), plan.cells.end(), [](const Cell& one) { return one.key == "newton 33x33"; });
  const ReportRows slow{{{"method", "newton"}, {"vertices", 289}, {"seconds_at_least", 1e3}}};
  EXPECT_TRUE(cell->measure({slow, {}}).at(0).contains("skipped"));
}

TEST(Collision, reportsTheCostAndTheIntersectionsOfSelfCollision) {
  const ReportRows off = measured("collision", "fold 17x17 off");
  const ReportRows hash = measured("collision", "fold 17x17 hash");
  const ReportRows exact = measured("collision", "fold 17x17 exact");
  ASSERT_EQ(off.size(), 1U);
  ASSERT_EQ(hash.size(), 1U);
  EXPECT_EQ(off[0]["contact_us_per_step"], 0.0);
  EXPECT_GT(hash[0]["contact_us_per_step"], 0.0);
  EXPECT_GT(hash[0]["us_per_step"], hash[0]["contact_us_per_step"]);
  EXPECT_GT(off[0]["intersecting_pairs_max"], 50);
  EXPECT_LT(hash[0]["intersecting_pairs_max"], 10);
  EXPECT_GT(hash[0]["contacts_max"], 20);
  EXPECT_EQ(hash[0]["mode"], "hash");
  EXPECT_EQ(off[0]["mode"], "off");
  ASSERT_EQ(exact.size(), 1U);
  EXPECT_EQ(exact[0]["mode"], "exact");
  EXPECT_EQ(exact[0]["intersecting_pairs_self_max"], 0);
  EXPECT_GT(exact[0]["self_us_per_step"], 0.0);
  EXPECT_EQ(exact[0]["paper_self_us"], 920.0);
  EXPECT_LT(exact[0]["energy_gained"], 1e-3);
  EXPECT_GT(exact[0]["end_speed"], 0.0);
}

TEST(Collision, leavesOutTheEnergyOfSceneWithMovingBodies) {
  const auto energyOf = [](const char* name) {
    const scene::SceneDescription description = scene::openScene(name);
    return sections::runCollision(*scene::buildScene(description, description.settings), 0.02, 0, [] {}).energyGained;
  };
  EXPECT_TRUE(std::isnan(energyOf("turning_sphere")));
  EXPECT_GE(energyOf("sphere"), 0.0);
}

TEST(Collision, runsAScenesBodiesAndLooksForPairsWithThem) {
  const ReportRow sphere = measured("collision", "sphere 17x17").at(0);
  EXPECT_EQ(sphere["mode"], "bodies+hash");
  EXPECT_EQ(sphere["bodies"], 2) << "the sphere and the ground";
  EXPECT_GT(sphere["contacts_max"], 10);
  EXPECT_GT(sphere["bodies_us_per_1000_triangles"], 0.0);
  EXPECT_EQ(sphere["intersecting_pairs_bodies_max"], 0);
}

/// The texts below the tables.
std::string wordsOf(const ReportRows& rows) {
  std::string words;
  for (const Block& block : sectionOf("collision").show({}, rows)) {
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) {
      words += paragraph->text + "\n";
    }
  }
  return words;
}

TEST(Collision, namesIntersectionsAndCostsAboveTheTarget) {
  const auto row = [](const char* scene, const char* mode, int self, int bodies, double cost) {
    return ReportRow{{"scene", scene},
                     {"resolution", 17},
                     {"mode", mode},
                     {"us_per_step", 100.0},
                     {"contact_us_per_step", 50.0},
                     {"bodies_us_per_1000_triangles", cost},
                     {"intersecting_pairs_self_max", self},
                     {"intersecting_pairs_bodies_max", bodies}};
  };
  const std::string good = wordsOf({row("fold", "off", 9, 0, 0.0), row("fold", "hash", 0, 0, 0.0),
                                    row("sphere", "bodies", 7, 0, sections::targetOfBodyContact)});
  EXPECT_NE(good.find("No cloth triangle ever intersected a body triangle"), std::string::npos) << good;
  EXPECT_NE(good.find("all scenes meet it"), std::string::npos) << good;
  EXPECT_NE(good.find("nothing passed through"), std::string::npos) << good;
  const double above = sections::targetOfBodyContact + 1.0;
  const std::string bad = wordsOf({row("fold", "off", 900, 0, 0.0), row("fold", "hash", 27, 0, 0.0),
                                   row("sphere", "bodies", 0, 3, above), row("box", "bodies+hash", 0, 5, 20.0)});
  EXPECT_NE(bad.find("box (17x17) 5, sphere (17x17) 3"), std::string::npos) << bad;
  EXPECT_NE(bad.find("above it: sphere (17x17) " + text::figure(above)), std::string::npos) << bad;
  EXPECT_NE(bad.find("fold (17x17) 27 of 900"), std::string::npos) << bad;
}

TEST(Collision, comparesHashAndExactSideBySide) {
  const auto row = [](const char* scene, const char* mode, int pairs, double cost) {
    return ReportRow{{"scene", scene},           {"resolution", 17},       {"mode", mode},
                     {"self_us_per_step", cost}, {"paper_self_us", 920.0}, {"intersecting_pairs_self_max", pairs},
                     {"energy_gained", 0.01},    {"end_speed", 0.002}};
  };
  const ReportRows rows{row("fold", "off", 900, 0.0), row("fold", "hash", 27, 50.0), row("fold", "exact", 0, 200.0),
                        row("sphere", "bodies+hash", 1, 10.0)};
  const TextTable table = sections::selfCollisionTable(rows);
  ASSERT_EQ(table.rows.size(), 1U) << "the sphere ran with the hash only";
  const std::vector<std::string> begin(table.rows[0].begin(), table.rows[0].begin() + 7);
  EXPECT_EQ(begin, (std::vector<std::string>{"fold (17x17)", "900", "27", "0", "0.92", "0.05", "0.2"}));
  EXPECT_EQ(table.rows[0].size(), table.header.size());
  EXPECT_EQ(table.rows[0].back(), "2");
  const std::string words = sections::aboutExact(rows);
  EXPECT_NE(words.find("no two triangles"), std::string::npos) << words;
  EXPECT_NE(words.find("4 to 4 times"), std::string::npos) << words;
  const std::string leaky = sections::aboutExact({row("fold", "hash", 27, 50.0), row("fold", "exact", 3, 200.0)});
  EXPECT_NE(leaky.find("fold (17x17) 3"), std::string::npos) << leaky;
  EXPECT_EQ(sections::aboutExact({row("sphere", "bodies+hash", 1, 10.0)}), "");
}

}  // namespace
}  // namespace drape::report
