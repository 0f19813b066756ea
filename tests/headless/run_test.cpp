#include "program.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace drape::app::testing {
namespace {

nlohmann::json statsOf(const std::string& arguments) {
  const auto file = testFolder() / "stats.json";
  const Outcome outcome = headless("run " + arguments + " --stats " + file.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  return nlohmann::json::parse(readFile(file));
}

TEST(Run, writesTheFiguresOfThePapersSheet) {
  const auto stats = statsOf("grid --set grid.resolution=17 --seconds 0.5");
  EXPECT_EQ(stats["vertices"], 289);
  EXPECT_EQ(stats["springs"], 800);
  EXPECT_EQ(stats["triangles"], 512);
  EXPECT_EQ(stats["steps"], 75);
  EXPECT_GT(stats["step_us"]["median"], 0.0);
  EXPECT_GE(stats["step_us"]["p99"], stats["step_us"]["median"]);
  EXPECT_GT(stats["step_us"]["mean"], 0.0);
  EXPECT_TRUE(stats["energy"].is_number());
  EXPECT_GT(stats["max_stretch"], 0.0);
  EXPECT_EQ(stats["finite"], true);
  EXPECT_EQ(stats["state_hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(stats["settings"]["grid.resolution"], 17);
}

TEST(Run, startsFromJitteredPositions) {
  const auto hashOf = [](const std::string& jitter) { return statsOf("grid --seconds 0.1" + jitter)["state_hash"]; };
  EXPECT_EQ(hashOf(" --jitter 0"), hashOf(""));
  EXPECT_EQ(hashOf(" --jitter 1"), hashOf(" --jitter 1"));
  EXPECT_NE(hashOf(" --jitter 1"), hashOf(" --jitter 2"));
  EXPECT_EQ(headless("run grid --seconds 0.1 --jitter -1").status, 2);
}

TEST(Run, addsNoEnergyToAFlagThatFoldsFastWithExactSelfCollision) {
  const auto stats = statsOf("flag --seconds 1.5 --set self_collision=exact");
  EXPECT_LT(stats["energy_elastic"], 0.5) << "about 0.06 J; contact substeps that are too long add 100 J";
  EXPECT_LT(stats["energy_kinetic"], 2.0) << "about 0.2 J";
}

TEST(Run, namesTheMethodOfSelfCollisionThatActs) {
  const auto acting = [](const std::string& settings) {
    return statsOf("grid --seconds 0.02 --set " + settings)["contact"]["self_collision"];
  };
  EXPECT_EQ(acting("self_collision=auto solver=auto"), "exact");
  EXPECT_EQ(acting("self_collision=auto solver=xpbd"), "hash");
  EXPECT_EQ(acting("self_collision=off solver=auto"), "off");
}

TEST(Run, bringsATableclothToRest) {
  const auto stats = statsOf("tablecloth --seconds 120 --set time_step=1/60 solver=auto grid.resolution=17");
  EXPECT_EQ(stats["choice"]["sleeping"], 1.0);
  EXPECT_EQ(stats["energy_kinetic"], 0.0);
  EXPECT_EQ(stats["contact"]["intersections_max"], 0);
}

TEST(Run, reportsTheChoicesOfAuto) {
  const std::string sheet = "grid --set grid.resolution=17 --seconds 0.2 --set solver=";
  EXPECT_TRUE(statsOf(sheet + "one_iteration")["choice"].is_null());
  const auto choice = statsOf(sheet + "auto")["choice"];
  EXPECT_NE(choice["words"].get<std::string>().find("substep"), std::string::npos);
  EXPECT_GE(choice["substeps"], 1.0);
  EXPECT_GE(choice["error"], 0.0);
  EXPECT_GT(choice["force_evaluations_median"], 0.0);
  EXPECT_GE(choice["force_evaluations_max"], choice["force_evaluations_median"]);
  EXPECT_GE(choice["error_max"], choice["error"]);
  EXPECT_EQ(choice["fallback_steps"], 0);
}

TEST(Run, printsTheStabilityLimitOfASolverThatHasOne) {
  EXPECT_TRUE(statsOf("grid --seconds 0.01")["stability_limit"].is_null());
  const std::string sheet = "grid --set grid.resolution=17 --set mass=0.1 --set stiffness=10 --seconds 0.01 ";
  const auto limit = statsOf(sheet + "--set solver=verlet")["stability_limit"];
  EXPECT_NEAR(limit.get<double>(), 2.0 / 480.8, 1e-5);
  EXPECT_NE(headless("run " + sheet + "--set solver=verlet").output.find("stability limit: 1/241 s"),
            std::string::npos);
  EXPECT_EQ(statsOf(sheet + "--set solver=explicit_euler")["stability_limit"], 0.0);
  EXPECT_NE(headless("run " + sheet + "--set solver=explicit_euler").output.find("no step is stable"),
            std::string::npos);
}

TEST(Run, givesTheSameHashFromRunToRunAndForAnyNumberOfThreads) {
  const std::string arguments = "grid --set grid.resolution=65 --set drag=0.5 --set wind.z=2 --seconds 0.1 --threads ";
  const auto first = statsOf(arguments + "1")["state_hash"];
  EXPECT_EQ(statsOf(arguments + "1")["state_hash"], first);
  EXPECT_EQ(statsOf(arguments + "2")["state_hash"], first);
  EXPECT_EQ(statsOf(arguments + "5")["state_hash"], first);
}

TEST(Run, reportsTheDistanceOfTheGhostAndDoesNotChangeTheCloth) {
  const std::string arguments = "grid --set grid.resolution=9 --seconds 0.3";
  const auto alone = statsOf(arguments);
  EXPECT_FALSE(alone.contains("ghost_distance_mean"));
  const auto haunted = statsOf(arguments + " --set ghost.solver=one_iteration --set ghost.substeps=10");
  EXPECT_GT(haunted["ghost_distance_mean"], 1e-3);
  EXPECT_EQ(haunted["state_hash"], alone["state_hash"]);
  EXPECT_EQ(haunted["steps"], alone["steps"]);
}

TEST(Run, continuesWhenTheGhostBlowsUp) {
  const auto file = testFolder() / "stats.json";
  const Outcome outcome = headless(
      "run grid --set grid.resolution=9 --set derivative=axial --set stiffness=1e3 --set time_step=1/30 "
      "--set substeps=20 --set ghost.solver=one_iteration --seconds 8 --stats " +
      file.string());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.errors.find("ghost"), std::string::npos) << outcome.errors;
  const auto stats = nlohmann::json::parse(readFile(file));
  EXPECT_EQ(stats["steps"], 240);
  EXPECT_EQ(stats["finite"], true);
  EXPECT_FALSE(stats.contains("ghost_distance_mean"));
}

TEST(Run, writesALineForEachVertexAndSampleWithNineDigits) {
  const auto file = testFolder() / "positions.csv";
  const Outcome outcome =
      headless("run grid --set grid.resolution=5 --seconds 0.4 --every 0.1 --positions " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  std::istringstream lines(readFile(file));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time,vertex,x,y,z");
  std::vector<double> times;
  bool manyDigits = false;
  for (int i = 0; std::getline(lines, line); ++i) {
    double time = 0.0;
    int vertex = -1;
    std::vector<double> point(3);
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%d,%lf,%lf,%lf", &time, &vertex, &point[0], &point[1], &point[2]), 5);
    EXPECT_EQ(vertex, i % 25);
    manyDigits = manyDigits || line.size() > 40;
    if (vertex == 0) {
      times.push_back(time);
    }
  }
  ASSERT_EQ(times.size(), 5U);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(times[i], 0.1 * static_cast<double>(i), 1e-6);
  }
  EXPECT_TRUE(manyDigits);
}

TEST(Run, fallsFreelyAsBackwardEulerDoes) {
  const auto file = testFolder() / "positions.csv";
  const Outcome outcome = headless(
      "run grid --set pins=none --set grid.resolution=3 --set time_step=0.01 --seconds 0.5 "
      "--every 0.5 --positions " +
      file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  std::istringstream lines(readFile(file));
  std::string line;
  std::vector<double> heights;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    double y = 0.0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%*f,%*d,%*f,%lf", &y), 1);
    heights.push_back(y);
  }
  ASSERT_EQ(heights.size(), 18U);
  EXPECT_NEAR(heights[0] - heights[9], 0.5 * 9.81 * 0.01 * 0.01 * 50 * 51, 1e-8);
}

TEST(Run, takesAFabricByName) {
  const auto stats =
      statsOf("grid --set solver=auto --set material.model=fabric --set material.preset=denim --seconds 0");
  EXPECT_EQ(stats["settings"]["material.model"], "fabric");
  EXPECT_EQ(stats["settings"]["material.preset"], "denim");
  EXPECT_EQ(stats["settings"]["fabric.stretch_weft"], 1014.0);
  const auto changed = statsOf(
      "grid --set solver=auto --set material.model=fabric --set material.preset=denim --set fabric.shear=80 --seconds "
      "0");
  EXPECT_EQ(changed["settings"]["material.preset"], "denim, changed");
  EXPECT_EQ(statsOf("grid --seconds 0")["settings"]["material.model"], "springs");
}

TEST(Run, notesAFabricThatHasNoEffectOnSprings) {
  const std::string note = "note: the setting 'material.preset' has no effect while material.model is springs";
  const Outcome springs = headless("run grid --set material.preset=denim --seconds 0");
  EXPECT_EQ(springs.status, 0) << springs.errors;
  EXPECT_NE(springs.errors.find(note), std::string::npos) << springs.errors;
  const Outcome fabric =
      headless("run grid --set material.preset=denim --set material.model=fabric --set solver=auto --seconds 0");
  EXPECT_EQ(fabric.errors.find("has no effect"), std::string::npos) << fabric.errors;
}

TEST(Run, refusesASolverThatTakesSpringsOnly) {
  const Outcome outcome = headless("run grid --seconds 0 --set solver=kang --set material.model=fabric");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("solver = kang knows springs only"), std::string::npos) << outcome.errors;
}

TEST(Run, refusesAFabricThatIsNoneWithTheNameOfTheSetting) {
  for (const char* wrong : {"fabric.shear=-1", "fabric.stretch_warp=nan", "fabric.bend_bias=0", "material.model=jelly",
                            "material.preset=cardboard"}) {
    const Outcome outcome = headless("run grid --seconds 0 --set " + std::string(wrong));
    const std::string key = std::string(wrong).substr(0, std::string(wrong).find('='));
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_NE(outcome.errors.find(key + " must be"), std::string::npos) << outcome.errors;
  }
}

TEST(Run, refusesWrongUsageWithStatusTwo) {
  for (const char* arguments :
       {"", "run grid", "run grid --seconds abc", "run grid --seconds -1", "run grid --seconds nan",
        "run grid --seconds 1 --threads 0", "run grid --seconds 1 --threads 1000", "run grid --seconds 1 --nonsense",
        "run grid --seconds 1 --set stiffness=-1", "run grid --seconds 1 --set stiffness",
        "run grid --seconds 1 --set nonsense=1", "run grid --seconds 1 --set sweeps=2",
        "run grid --seconds 1 --positions /dev/null", "run grid --seconds 1 --check-intersections 0",
        "run grid --seconds 1 --check-intersections -3", "run grid --seconds 1 --check-intersections 1.5",
        "run grid --seconds 1e5 --set time_step=1e-5", "walk grid --seconds 1"}) {
    const Outcome outcome = headless(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.errors;
    EXPECT_NE(outcome.errors.find("drape-headless: "), std::string::npos) << arguments;
  }
}

TEST(Run, refusesOptionsThatWouldHaveNoEffect) {
  for (const auto& [option, needed] : {std::pair("--every 0.01", "--positions"), std::pair("--rate 25", "--export"),
                                       std::pair("--coordinates scene", "--export")}) {
    const Outcome outcome = headless(std::string("run grid --set grid.resolution=5 --seconds 0.02 ") + option);
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_NE(outcome.errors.find(std::string("requires ") + needed), std::string::npos) << outcome.errors;
  }
}

TEST(Run, failsWithStatusOneWhenInputOrOutputCannotBeHad) {
  for (const char* arguments :
       {"run no_such_scene --seconds 1", "run / --seconds 1", "run grid --seconds 0.1 --stats /no/such/folder/s.json",
        "run grid --seconds 0.1 --every 0.1 --positions /no/such/folder/p.csv"}) {
    const Outcome outcome = headless(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.errors;
    EXPECT_NE(outcome.errors.find("drape-headless: "), std::string::npos) << arguments;
  }
}

TEST(Run, printsTheContentsOfAMeshFile) {
  const auto mesh = testFolder() / "sheet.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 100 0 0\nv 100 200 0\nv 0 200 0\nf 1 2 3 4\nf 1 2 3\n";
  const Outcome centimetres = headless("run " + mesh.string() + " --set unit=cm --set up=y --seconds 0.01");
  EXPECT_EQ(centimetres.status, 0) << centimetres.errors;
  EXPECT_EQ(centimetres.errors.find("note: read as"), std::string::npos) << centimetres.errors;
  EXPECT_NE(centimetres.output.find("triangles:   2"), std::string::npos) << centimetres.output;
  EXPECT_NE(centimetres.output.find("1 x 2 x 0 m"), std::string::npos) << centimetres.output;
}

TEST(Run, takesAFormerKeyOfASettingWithOneNote) {
  const Outcome outcome = headless("run grid --set hand.stiffness=50 --seconds 0.01");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const std::string note = "note: the setting 'hand.stiffness' is now called 'attachment.stiffness'";
  const auto first = outcome.errors.find(note);
  EXPECT_NE(first, std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.find(note, first + 1), std::string::npos) << outcome.errors;
}

TEST(Run, printsHowAMeshFileWasRead) {
  const auto folder = testFolder();
  const auto mesh = folder / "towel.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 60 0 0\nv 60 90 0\nv 0 90 0\nf 1 2 3 4\n";
  const auto stats = folder / "towel.json";
  const Outcome outcome = headless("run " + mesh.string() + " --seconds 0.01 --stats " + stats.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.errors.find("note: Read as centimetres, y up: 0.90 m tall. To change it: --set unit="),
            std::string::npos)
      << outcome.errors;
  EXPECT_NE(outcome.errors.find("--set up=z"), std::string::npos) << outcome.errors;
  const auto reading = nlohmann::json::parse(std::ifstream(stats))["reading"];
  EXPECT_EQ(reading["unit"], "cm");
  EXPECT_EQ(reading["metres_per_unit"], 0.01);
  EXPECT_EQ(reading["unit_guessed"], true);
  EXPECT_EQ(reading["up"], "y");
  EXPECT_NEAR(reading["size"][1].get<double>(), 0.9, 1e-9);
  EXPECT_TRUE(statsOf("grid --seconds 0.01")["reading"].is_null());
}

TEST(Run, warnsOfPinsOnAllVerticesWithTheOptionThatHelps) {
  const auto mesh = testFolder() / "level.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 4 3 2 1\n";
  const Outcome outcome = headless("run " + mesh.string() + " --set pins=top --seconds 0.01");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.errors.find("All 4 vertices are pinned, so nothing can move. Use --set pins=shape"),
            std::string::npos)
      << outcome.errors;
}

TEST(Run, countsIntersectingTrianglesOnlyWhenAsked) {
  EXPECT_FALSE(statsOf("grid --seconds 0.1").contains("intersecting_pairs_max"));
  const auto stats = statsOf("grid --set time_step=0.01 --seconds 0.12 --check-intersections 5");
  EXPECT_EQ(stats["intersection_checks"], 4) << "steps 0, 5, 10 and 12";
  EXPECT_EQ(stats["intersecting_pairs_max"], 0);
  EXPECT_EQ(stats["intersecting_pairs_final"], 0);
  EXPECT_TRUE(stats["intersecting_pairs_worst_step"].is_null());
  EXPECT_GT(stats["intersection_check_us"]["median"], 0.0);
}

// The long form is drape-headless run walk --seconds 60 --check-intersections 1.
TEST(Run, ofAWalkingFigureHasNoIntersectionAtAnyStepOfThreeSeconds) {
  const auto stats = statsOf("walk --seconds 3 --check-intersections 1");
  EXPECT_EQ(stats["intersection_checks"], 901);
  EXPECT_EQ(stats["intersecting_pairs_max"], 0);
}

TEST(Run, findsTheStepAtWhichMostTrianglesIntersect) {
  // A triangle pinned at its top, and one that falls through the space below it.
  auto folder = testFolder();
  folder += "_scene";  // statsOf empties the other one
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "falling.obj")
      << "v 0 0.5 0\nv 1 0.5 0\nv 0.5 0.5 1\nv 0.4 1.0 0.2\nv 0.6 1.0 0.2\nv 0.5 0.7 0.2\n"
         "f 1 2 3\nf 4 5 6\n";
  const auto scene = folder / "falling.toml";
  std::ofstream(scene) << "[cloth]\nmesh = \"falling.obj\"\n[pins]\nvertices = [0, 1, 2]\n"
                          "[settings]\ntime_step = 0.01\nsolver = \"newton\"\nself_collision = \"off\"\n";
  const std::string command = scene.string() + " --check-intersections 1 --seconds ";
  const auto before = statsOf(command + "0.15");
  EXPECT_EQ(before["intersecting_pairs_max"], 0);
  // The lower tip is 0.2 m above the pinned triangle and falls h^2 g n (n + 1) / 2 in n steps: past it in the 20th.
  const auto within = statsOf(command + "0.25");
  EXPECT_EQ(within["intersecting_pairs_max"], 1);
  EXPECT_EQ(within["intersecting_pairs_final"], 1);
  EXPECT_EQ(within["intersecting_pairs_worst_step"], 20);
  // Its upper edge is 0.5 m above and passes in the 32nd step.
  const auto after = statsOf(command + "0.4");
  EXPECT_EQ(after["intersecting_pairs_max"], 1);
  EXPECT_EQ(after["intersecting_pairs_final"], 0);
  EXPECT_NE(headless("run " + command + "0.4").output.find("at most 1 (step 20), 0 at the end"), std::string::npos);
}

TEST(Run, countsIntersectionsWithBodiesApartFromThoseWithItself) {
  auto folder = testFolder();
  folder += "_scene";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "ball.toml") << "[cloth]\ngrid = \"horizontal\"\nposition = [0, 0.25, 0]\n"
                                         "[[bodies]]\nshape = \"sphere\"\nradius = 0.1\nposition = [0, 0.12, 0]\n"
                                         "[ground]\nheight = 0\nsolid = true\n"
                                         "[settings]\ngrid.resolution = 9\ngrid.width = 0.5\ngrid.height = 0.5\n"
                                         "time_step = 0.01\n";
  const std::string command = (folder / "ball.toml").string() + " --check-intersections 1 --seconds 0.6";
  const auto kept = statsOf(command);
  EXPECT_EQ(kept["intersecting_pairs_bodies"]["max"], 0);
  EXPECT_TRUE(kept["intersecting_pairs_bodies"]["worst_step"].is_null());
  const auto through = statsOf(command + " --set bodies=false");
  EXPECT_GT(through["intersecting_pairs_bodies"]["max"], 10) << "in the ball";
  EXPECT_EQ(through["intersecting_pairs_bodies"]["final"], through["triangles"]) << "all below the ground, once each";
  EXPECT_EQ(through["intersecting_pairs_self"]["max"], 0);
  EXPECT_EQ(through["intersecting_pairs_max"], through["intersecting_pairs_bodies"]["max"]);
}

TEST(Run, warnsWhenTheTimeIsLessThanHalfOfAStep) {
  const Outcome outcome = headless("run grid --set grid.resolution=3 --set time_step=1/60 --seconds 0.005");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.errors.find("warning: --seconds 0.005 leaves less than half of a time step of 0.0166667 s"),
            std::string::npos)
      << outcome.errors;
  EXPECT_EQ(headless("run grid --set grid.resolution=3 --seconds 0").errors.find("less than half"), std::string::npos);
}

TEST(Run, takesNoStepInNoTime) {
  EXPECT_EQ(statsOf("grid --seconds 0")["steps"], 0);
}

TEST(Run, showsNoProgressBarWhereThereIsNoTerminal) {
  EXPECT_EQ(headless("run grid --seconds 0.1 --set stiffness=0.5").errors, "");
}

TEST(Run, warnsOfTheSolverAndTheGhostsSolverOnThisCloth) {
  const Outcome outcome = headless("run grid --seconds 0.1 --set solver=verlet --set ghost.solver=one_iteration");
  EXPECT_EQ(outcome.status, 1) << "it blows up";
  EXPECT_NE(outcome.errors.find("warning: verlet: The time step is above"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("warning: the ghost's one_iteration: One sweep"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
