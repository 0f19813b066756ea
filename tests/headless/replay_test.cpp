#include "app/command_json.hpp"
#include "app/session_log.hpp"
#include "messages/error.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

namespace drape::app::testing {
namespace {

/// A session with every command that a log can hold.
std::unique_ptr<session::Simulation> busySession() {
  auto session = std::make_unique<session::Simulation>(
      scene::buildScene(scene::openScene("sphere"), scene::openScene("sphere").settings));
  session::Simulation& simulation = *session;
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      simulation.step();
    }
  };
  steps(3);
  simulation.apply(session::SetSettingCommand{"wind.x", 2.5});
  simulation.apply(session::SetSettingCommand{"drag", 1});
  simulation.apply(session::AttachCommand{{40, Vec3(0.2, 0.3, 0.5), Vec3(0.1, 1.4, 0.1)}});
  steps(5);
  simulation.apply(session::MoveAttachmentCommand{Vec3(0.2, 1.6, 1.0 / 3.0)});
  steps(5);
  simulation.apply(session::TogglePinCommand{});
  simulation.apply(session::DetachCommand{});
  simulation.apply(session::MovePinsCommand{Vec3(0.0, 0.01, 0.0)});
  simulation.apply(session::PauseCommand{true});
  simulation.apply(session::SingleStepCommand{});
  simulation.apply(session::PauseCommand{false});
  simulation.apply(session::MoveBodyCommand{0, Vec3(0.05, 0.0, 0.0)});
  simulation.apply(session::SetSurfaceCommand{0, {0.9, 0.7, 0.003}});
  steps(5);
  simulation.apply(session::SwitchBodyCommand{0, false});
  simulation.apply(session::SetCostBudgetCommand{321.0});
  steps(2);
  return session;
}

std::string written(const SessionLog& log, const char* name = "session.json") {
  const std::string file = (testFolder() / name).string();
  OutputFile output(file, "the session log");
  write(log, output);
  return file;
}

TEST(Replay, endsInTheSameBitsAsTheSession) {
  const auto session = busySession();
  const std::string file = written(sessionLogOf(*session));
  const Outcome outcome = headless("run --replay " + file + " --threads 2");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find(sim::toHex(sim::stateHash(session->state()))), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("same state as the session"), std::string::npos) << outcome.output;
}

TEST(Replay, followsAResetToTheSameBits) {
  const auto session = busySession();
  session->apply(session::ResetCommand{});
  for (int i = 0; i < 4; ++i) {
    session->step();
  }
  EXPECT_EQ(headless("run --replay " + written(sessionLogOf(*session))).status, 0);
}

TEST(Replay, followsAFigureToTheSameBits) {
  session::Simulation session(scene::buildScene(scene::openScene("dance"), scene::openScene("dance").settings));
  session.step();
  session::SetFigureCommand command{0, {figure::findMotion("turn"), 1.5, {}}};
  command.figure.proportions.hip = 1.0;
  session.apply(command);
  for (int i = 0; i < 4; ++i) {
    session.step();
  }
  const Outcome outcome = headless("run --replay " + written(sessionLogOf(session)));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
}

TEST(Replay, keepsThePlacements) {
  const scene::SceneDescription sphere = scene::openScene("sphere");
  session::Simulation session(scene::buildScene(sphere, sphere.settings));
  scene::Placements placements = scene::placementsOf(sphere);
  placements.cloths[0] = {Vec3(0.1, 0.2, -1.0 / 3.0), Vec3(0.3, 20.0 / 3.0, 0), 1.1};
  placements.bodies[0] = {Vec3(0.05, 0, 0), Vec3(0, 17.3, 0), 0.9};
  placements.readings[0] = scene::ReadingChoice{"m", "z"};
  session.apply(
      session::LoadSceneCommand{scene::buildScene(scene::withPlacements(sphere, placements), session.settings())});
  for (int i = 0; i < 4; ++i) {
    session.step();
  }
  const std::string file = written(sessionLogOf(session));
  EXPECT_EQ(readSessionLog(file).placements, placements);
  const Outcome outcome = headless("run --replay " + file);
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  SessionLog log = sessionLogOf(session);
  log.placements->cloths[0].scale = 1e6;
  const Outcome refused = headless("run --replay " + written(log));
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("scale"), std::string::npos) << refused.errors;
}

TEST(Replay, keepsTheSettingsThatTheSceneWasOpenedWith) {
  settings::Settings settings = scene::openScene("grid").settings;
  settings.step.material.stiffness = 123.0;
  settings.material.mass = 0.2;
  settings.material.massGivenAs = "mass";
  session::Simulation session(scene::buildScene(scene::openScene("grid"), settings));
  session.step();
  EXPECT_EQ(headless("run --replay " + written(sessionLogOf(session))).status, 0);
}

TEST(Replay, keepsTheFabricAndItsChanges) {
  const scene::SceneDescription grid = scene::openScene("grid");
  settings::Settings settings = grid.settings;
  settings::assignSettingExpression(settings, "solver=auto");
  settings::assignSettingExpression(settings, "material.model=fabric");
  settings::assignSettingExpression(settings, "material.preset=denim");
  settings::assignSettingExpression(settings, "fabric.own_density=on");
  settings::assignSettingExpression(settings, "fabric.warp_angle=30");
  session::Simulation session(scene::buildScene(grid, settings));
  session.step();
  session.apply(session::SetSettingCommand{"fabric.shear", 60.0});
  session.step();
  session.apply(session::SetSettingCommand{"material.preset", std::string("silk")});
  session.step();
  const SessionLog log = sessionLogOf(session);
  const auto scene = openLoggedScene(log);
  EXPECT_EQ(scene->settings.fabric.moduli, settings.fabric.moduli);
  EXPECT_EQ(scene->model->totalMass(), session.scene().model->totalMass());
  const Outcome outcome = headless("run --replay " + written(log));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
}

TEST(Replay, needsNoListForTheOwnFabricsOfTheSession) {
  const scene::SceneDescription grid = scene::openScene("grid");
  settings::Settings settings = grid.settings;
  settings::assignSettingExpression(settings, "material.preset=denim");
  settings::OwnFabric first = settings::fabricOf(settings, "first");
  settings::OwnFabric second = settings::fabricOf(settings, "second");
  first.density = 0.3;
  second.density = 0.4;
  settings.fabric.own = settings::withOwnFabric({}, first);
  for (const char* expression :
       {"solver=auto", "material.model=fabric", "material.preset=first", "fabric.own_density=on"}) {
    settings::assignSettingExpression(settings, expression);
  }
  session::Simulation session(scene::buildScene(grid, settings));
  session.step();
  session.apply(session::SetOwnFabricsCommand{settings::withOwnFabric(settings.fabric.own, second)});
  session.apply(session::UseFabricCommand{second});
  session.step();
  session.apply(session::SetSettingCommand{"material.preset", std::string("first")});
  session.apply(session::SetSettingCommand{"material.preset", std::string("second")});
  session.step();
  ASSERT_TRUE(session.message().empty()) << session.message();
  const Outcome outcome = headless("run --replay " + written(sessionLogOf(session)));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("fabric: second;"), std::string::npos) << outcome.output;
}

TEST(Replay, failsWhereTheEndDiffers) {
  const auto session = busySession();
  SessionLog log = sessionLogOf(*session);
  std::get<session::SetSettingCommand>(log.commands.front().command).value = 2.6;
  const Outcome outcome = headless("run --replay " + written(log));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find(log.stateHash), std::string::npos) << outcome.errors;
}

TEST(Replay, refusesAnIncompleteLog) {
  const std::string whole = readFile(written(sessionLogOf(*busySession())));
  const std::string file = (testFolder() / "damaged.json").string();
  for (const std::string& text : {std::string(), std::string("{}"), whole.substr(0, whole.size() / 2)}) {
    std::ofstream(file) << text;
    const Outcome outcome = headless("run --replay " + file);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_NE(outcome.errors.find(file), std::string::npos) << outcome.errors;
  }
  const Outcome missing = headless("run --replay " + (testFolder() / "missing.json").string());
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.errors.find("missing.json"), std::string::npos) << missing.errors;
}

TEST(Replay, refusesUnknownSettingsWithTheNameOfTheLog) {
  SessionLog log = sessionLogOf(*busySession());
  log.settings.emplace_back("softness", "1");
  const std::string file = written(log);
  const Outcome outcome = headless("run --replay " + file);
  EXPECT_EQ(outcome.status, 1) << "the file is wrong, not the command line";
  EXPECT_NE(outcome.errors.find(file + ": there is no setting"), std::string::npos) << outcome.errors;
  EXPECT_EQ(headless("run --threads 0 --replay " + file).status, 2);
}

TEST(Replay, refusesStepsThatDecreaseOrHaveNoEnd) {
  SessionLog log = sessionLogOf(*busySession());
  log.steps = 1;
  EXPECT_NE(headless("run --replay " + written(log)).errors.find("\"steps\""), std::string::npos);
  log.steps = std::int64_t{1} << 40;
  EXPECT_EQ(headless("run --replay " + written(log)).status, 1);
  log.steps = 100;
  std::swap(log.commands.front(), log.commands.back());
  EXPECT_NE(headless("run --replay " + written(log)).errors.find("decrease"), std::string::npos);
}

TEST(Replay, takesSceneAndSettingsFromTheLogAlone) {
  EXPECT_EQ(headless("run grid --replay log.json").status, 2);
  EXPECT_EQ(headless("run --replay log.json --set drag=1").status, 2);
  EXPECT_EQ(headless("run --replay log.json --seconds 1").status, 2);
  EXPECT_EQ(headless("run grid").status, 2) << "without a log --seconds is required";
}

TEST(CommandJson, keepsEveryCommandAndAllBits) {
  const auto session = busySession();
  ASSERT_GE(session->log().size(), 13U);
  for (const session::LoggedCommand& entry : session->log()) {
    const auto json = toJson(entry);
    EXPECT_EQ(toJson(commandFrom(nlohmann::ordered_json::parse(json.dump()))), json);
  }
}

TEST(CommandJson, keepsTheMotionAndTheMeasuresOfAFigure) {
  session::SetFigureCommand command{2, {figure::findMotion("skate"), 1.0 / 3.0, {}}};
  command.figure.proportions.waist = 0.7;
  const auto json = toJson({5, command});
  EXPECT_FALSE(json["figure"].contains("height")) << "it stays as built";
  const session::LoggedCommand again = commandFrom(nlohmann::ordered_json::parse(json.dump()));
  EXPECT_EQ(again.step, 5);
  EXPECT_EQ(std::get<session::SetFigureCommand>(again.command).body, 2);
  EXPECT_EQ(std::get<session::SetFigureCommand>(again.command).figure, command.figure);
}

TEST(CommandJson, keepsSeamsAndElasticBands) {
  session::SetSewingCommand command;
  scene::SeamDescription& seam = command.sewing.seams.emplace_back();
  seam.sides = {scene::BorderDescription{"front", {0, 4, 8}, {}},
                scene::BorderDescription{"back", {}, {Vec3(1.0 / 3.0, 0.0, -0.1)}}};
  seam.isReversed = true;
  command.sewing.seams.emplace_back().pairs = {{1, 2}, {3, 4}};
  command.sewing.seams.back().duration = 1.0 / 7.0;
  command.sewing.bands = {{}, {{.nearest = Vec3(0.1, 0.2, 0.3), .length = 0.7}, {.length = 0.9, .vertices = {5}}}};
  const auto json = toJson({5, command});
  const session::LoggedCommand again = commandFrom(nlohmann::ordered_json::parse(json.dump()));
  EXPECT_EQ(std::get<session::SetSewingCommand>(again.command).sewing, command.sewing);
}

TEST(CommandJson, refusesAMotionThatDoesNotExist) {
  const char* text = R"({"step": 1, "command": "set_figure", "body": 0, "figure": {"motion": "fly", "speed": 1}})";
  EXPECT_THROW(static_cast<void>(commandFrom(nlohmann::ordered_json::parse(text))), messages::InputError);
}

TEST(CommandJson, namesAnEntryThatIsNoCommand) {
  for (const char* text : {"{}", "3", R"({"step": 1, "command": "attach"})", R"({"step": 1, "command": "fly"})",
                           R"({"step": 1, "command": "load_scene"})"}) {
    EXPECT_THROW(static_cast<void>(commandFrom(nlohmann::ordered_json::parse(text))), messages::InputError) << text;
  }
}

}  // namespace
}  // namespace drape::app::testing
