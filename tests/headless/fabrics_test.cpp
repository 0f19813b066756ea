#include "app/fabric_list.hpp"
#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "program.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

constexpr const char* softDenim = "[[fabrics]]\nname = \"Soft denim\"\nbased_on = \"denim\"\nshear = 40\n";
constexpr const char* runOfFabric = "run grid --seconds 0 --set solver=auto --set material.model=fabric ";

std::string listWith(const std::string& text) {
  const auto file = testFolder() / "fabrics.toml";
  std::ofstream(file) << text;
  return file.string();
}

settings::OwnFabric silkCalled(const std::string& name) {
  settings::Settings settings;
  settings::assignSettingExpression(settings, "material.preset=silk");
  return settings::fabricOf(settings, name);
}

std::string refusalOfSave(const std::filesystem::path& file, const settings::OwnFabric& fabric) {
  try {
    saveFabric(file, fabric);
    return "";
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

TEST(Fabrics, areListedWithAllValuesAndSources) {
  const Outcome outcome = headless("list fabrics --json --fabrics " + listWith(softDenim));
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto list = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(list.size(), fabrics::presetTable().size() + 1);
  for (const auto& row : list) {
    for (const std::string_view key : settings::fabricValueKeys()) {
      EXPECT_TRUE(row.contains(key)) << row;
    }
    EXPECT_TRUE(row["own"] == true || row["source"].get<std::string>().size() > 10) << row;
  }
  EXPECT_EQ(list.back()["name"], "Soft denim");
  EXPECT_EQ(list.back()["fabric.shear"], 40.0);
  const std::string words = headless("list fabrics --fabrics " + listWith(softDenim)).output;
  EXPECT_NE(words.find("Soft denim   Your own, based on denim"), std::string::npos) << words;
  EXPECT_NE(words.find("fabric.stretch_weft = 1014 N/m"), std::string::npos) << words;
  EXPECT_NE(words.find("Wang et al. 2011"), std::string::npos) << words;
  EXPECT_NE(words.find("fabric.shear = 461.5 N/m"), std::string::npos) << "felt, rounded: " << words;
  EXPECT_NE(words.find("drape coefficient = 20 to 40 % (Often quoted"), std::string::npos) << words;
  EXPECT_EQ(list[0]["drape_coefficient"]["upper"], 40.0);
}

TEST(Fabrics, areNamedOnTheCommandLineAndInTheSummary) {
  const std::string list = "--fabrics " + listWith(softDenim);
  const Outcome own = headless(runOfFabric + list + " --set 'material.preset=Soft denim'");
  EXPECT_EQ(own.status, 0) << own.errors;
  EXPECT_NE(own.output.find("fabric: Soft denim; warp vertical; no sliver has a lowered stiffness"), std::string::npos)
      << own.output;
  const Outcome changed = headless(runOfFabric + list + " --set 'material.preset=Soft denim' --set fabric.shear=41");
  EXPECT_NE(changed.output.find("fabric: Soft denim, changed;"), std::string::npos) << changed.output;
  EXPECT_NE(headless(runOfFabric + std::string("--set fabric.shear=41")).output.find("fabric: Cotton, changed;"),
            std::string::npos);
  const Outcome unknown = headless(runOfFabric + list + " --set material.preset=cardboard");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("rubber or Soft denim, or custom; 'cardboard' is not"), std::string::npos)
      << unknown.errors;
}

TEST(Fabrics, tellWhichRestShapeTheyHave) {
  const std::string run = "run skirt --seconds 0.01 ";
  EXPECT_EQ(headless(run).output.find("rest shape:"), std::string::npos);
  const std::string file = (testFolder() / "stats.json").string();
  const Outcome pattern = headless(run + "--set fabric.rest_shape=uv --stats " + file);
  EXPECT_NE(pattern.output.find("rest shape: the pattern in the UVs, "), std::string::npos) << pattern.errors;
  const auto stats = nlohmann::json::parse(readFile(file))["fabric"]["rest_shape"];
  EXPECT_EQ(stats["from"], "uv");
  EXPECT_GT(stats["uv_scale"], 0.1);
  EXPECT_GT(stats["mesh_strain"]["p99"], stats["mesh_strain"]["median"]);
  const Outcome refused = headless(run + "--set fabric.rest_shape=uv --set fabric.warp_from=vertical");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("fabric.warp_from = vertical is not possible"), std::string::npos) << refused.errors;
  const Outcome doubted = headless("run cape --seconds 0.01 --set material.model=fabric --set fabric.rest_shape=uv");
  EXPECT_NE(doubted.errors.find("warning: the UVs are unlikely to be the pattern of this mesh"), std::string::npos)
      << doubted.errors;
}

TEST(Fabrics, areFoundInTheConfigurationFolder) {
  const auto folder = testFolder();
  std::filesystem::create_directories(folder / "drape");
  std::ofstream(folder / "drape" / "fabrics.toml") << softDenim;
  ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): the test has one thread
  const Outcome good = headless("list fabrics");
  EXPECT_NE(good.output.find("Soft denim"), std::string::npos) << good.errors;
  std::ofstream(folder / "drape" / "fabrics.toml") << "[[fabrics]]\nname = \"Denim\"\n";
  const Outcome bad = headless("list fabrics");
  EXPECT_EQ(bad.status, 0) << "a bad usual list does not stop the program";
  EXPECT_NE(bad.errors.find("fabrics.toml:1: the fabric \"Denim\": the name 'Denim' belongs to the built-in fabric"),
            std::string::npos)
      << bad.errors;
  ::unsetenv("XDG_CONFIG_HOME");  // NOLINT(concurrency-mt-unsafe): the test has one thread
}

TEST(Fabrics, refuseABadListThatTheUserNames) {
  const Outcome bad = headless("list fabrics --fabrics " + listWith("[[fabrics]]\nname = \"a\"\n"));
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.errors.find("fabrics.toml:1: the fabric \"a\": the value density is missing"), std::string::npos)
      << bad.errors;
  const Outcome missing = headless("list fabrics --fabrics /no/such/list.toml");
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.errors.find("there is no list of fabrics '/no/such/list.toml'"), std::string::npos);
  EXPECT_EQ(headless("list scenes --fabrics x").status, 2);
}

TEST(FabricList, savesInANewFolderAndReadsItBack) {
  const auto file = testFolder() / "new" / "folder" / "fabrics.toml";
  FabricList list(file.string(), FabricList::Missing::Allowed);
  EXPECT_EQ(list.fabrics(), nullptr);
  list.add(silkCalled("My silk"));
  list.add(silkCalled("My other silk"));
  EXPECT_EQ(*FabricList(file.string()).fabrics(), *list.fabrics());
  EXPECT_EQ(list.fabrics()->size(), 2U);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(FabricList, keepsALinkToTheList) {
  const auto folder = testFolder();
  std::ofstream(folder / "real.toml") << softDenim;
  std::filesystem::create_symlink(folder / "real.toml", folder / "fabrics.toml");
  saveFabric(folder / "fabrics.toml", silkCalled("My silk"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "fabrics.toml"));
  EXPECT_EQ(FabricList((folder / "real.toml").string()).fabrics()->size(), 2U);
}

TEST(FabricList, losesNothingWhenASaveIsRefused) {
  const auto folder = testFolder();
  const auto file = folder / "fabrics.toml";
  std::ofstream(file) << "[[fabrics]\n";
  EXPECT_NE(refusalOfSave(file, silkCalled("a")).find("not valid TOML"), std::string::npos);
  EXPECT_EQ(readFile(file), "[[fabrics]\n");
  std::ofstream(file) << softDenim;
  EXPECT_NE(refusalOfSave(file, silkCalled("Silk")).find("belongs to the built-in fabric"), std::string::npos);
  EXPECT_EQ(readFile(file), softDenim);
  // The name beside the list is taken by a folder, so that the new list cannot be written.
  std::filesystem::create_directories(folder / "fabrics.toml.part" / "x");
  const std::string message = refusalOfSave(file, silkCalled("a"));
  EXPECT_NE(message.find("cannot save the fabric 'a' in " + file.string()), std::string::npos) << message;
  EXPECT_EQ(readFile(file), softDenim);
  EXPECT_NE(refusalOfSave("/dev/null/x/fabrics.toml", silkCalled("a")).find("/dev/null/x"), std::string::npos);
}

// The flat triangle is a sliver, and its neighbour at the thin corners is faster than most of the mesh.
TEST(Fabrics, countSliversInTheSummaryAndInTheFigures) {
  const auto folder = testFolder();
  const auto mesh = folder / "sliver.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 1.002 0\nf 1 2 3\nf 1 3 4\nf 4 3 5\n";
  const auto stats = folder / "stats.json";
  const Outcome outcome = headless("run " + mesh.string() + " --seconds 0 --set unit=m --set up=y" +
                                   " --set material.model=fabric --stats " + stats.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("slivers: the stiffness of 2 of 3 triangles is lowered"), std::string::npos)
      << outcome.output;
  const auto fabric = nlohmann::json::parse(readFile(stats))["fabric"];
  EXPECT_EQ(fabric["slivers"], 2);
  EXPECT_EQ(fabric["title"], "Cotton");
  EXPECT_EQ(fabric["warp_from"], "vertical");
}

}  // namespace
}  // namespace drape::app::testing
