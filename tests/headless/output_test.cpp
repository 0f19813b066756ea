#include "program.hpp"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>

/// Output and exit status of all commands.
namespace drape::app::testing {
namespace {

const std::string blownUp = "grid --set solver=verlet --set stiffness=1e7 --set grid.resolution=9 ";

TEST(BlowingUp, isAnErrorAndLeavesFiguresThatAreNumbers) {
  const auto folder = testFolder();
  const auto stats = folder / "stats.json";
  const auto positions = folder / "positions.csv";
  const Outcome outcome = headless("run " + blownUp + "--seconds 1 --stats " + stats.string() + " --every 0.01 " +
                                   "--positions " + positions.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("the cloth blew up at"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("or a lower stiffness"), std::string::npos) << outcome.errors;
  const auto json = nlohmann::json::parse(readFile(stats));
  EXPECT_EQ(json["finite"], false);
  EXPECT_LT(json["time"], 1.0);
  for (const char* figure : {"energy", "energy_kinetic", "energy_elastic", "energy_potential", "max_stretch"}) {
    EXPECT_TRUE(json[figure].is_number()) << figure;
  }
  EXPECT_EQ(readFile(positions).find("inf"), std::string::npos);
  EXPECT_EQ(readFile(positions).find("nan"), std::string::npos);
  EXPECT_GT(readFile(positions).size(), 1000U) << "what came before stays";
}

TEST(BlowingUp, ofAFabricAdvisesASofterFabric) {
  const Outcome outcome =
      headless("run grid --set material.model=fabric --set solver=explicit_euler --set grid.resolution=9 --seconds 1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("the cloth blew up at"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("Use a smaller time step or a softer fabric."), std::string::npos) << outcome.errors;
}

TEST(BlowingUp, isAnErrorOfCaptureWhichStillWritesItsPictures) {
  const auto folder = testFolder();
  const Outcome outcome = headless("capture " + blownUp + "--frames 3 --every 50 --resolution 64,64 --output " +
                                   (folder / "f_{frame}.png").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("the cloth blew up at"), std::string::npos) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "f_2.png"));
}

TEST(Commands, areListedWhereThereIsNoneOfThatName) {
  const Outcome unknown = headless("simulate flag");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("there is no command 'simulate'; the commands are run, capture"), std::string::npos)
      << unknown.errors;
  const Outcome mistyped = headless("Run flag --seconds 1");
  EXPECT_EQ(mistyped.status, 2);
  EXPECT_NE(mistyped.errors.find("there is no command 'Run'; did you mean 'run'?"), std::string::npos)
      << mistyped.errors;
  const Outcome none = headless("");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.errors.find("give a command: run, "), std::string::npos) << none.errors;
}

TEST(Commands, haveAVersion) {
  const Outcome outcome = headless("--version");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output.rfind("drape-headless ", 0), 0U) << outcome.output;
  const Outcome ofReport = report("--version");
  EXPECT_EQ(ofReport.status, 0);
  EXPECT_EQ(ofReport.output.rfind("drape-report ", 0), 0U) << ofReport.output;
}

TEST(OutputFiles, neverReplaceAFileThatTheCommandReads) {
  const auto folder = testFolder();
  const auto mesh = folder / "sheet.obj";
  const auto scene = folder / "scene.toml";
  ASSERT_EQ(headless("run grid --set grid.resolution=5 --seconds 0 --export " + mesh.string()).status, 0);
  std::ofstream(scene) << "[cloth]\nmesh = \"sheet.obj\"\n";
  const std::string meshBefore = readFile(mesh);
  const std::string sceneBefore = readFile(scene);
  for (const std::string& input : {mesh.string(), scene.string()}) {
    for (const std::string& output :
         {mesh.string(), folder.string() + "/../" + folder.filename().string() + "/sheet.obj"}) {
      for (const std::string& arguments :
           {"run " + input + " --seconds 0.01 --stats " + output, "run " + input + " --seconds 0.01 --save " + output,
            "run " + input + " --seconds 0.01 --every 0.01 --positions " + output,
            "run " + input + " --seconds 0.01 --probe 0 --probe-output " + output,
            "run " + input + " --seconds 0.01 --export " + output, "bake " + input + " --frames 1 --export " + output,
            "measure " + input + " --seconds 0.04 --against newton --json " + output,
            "errors " + input + " --times 0.04 --json " + output, "untangle " + input + " " + output}) {
        const Outcome outcome = headless(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_NE(outcome.errors.find("this file is read by this command"), std::string::npos) << outcome.errors;
      }
    }
  }
  EXPECT_EQ(headless("run " + scene.string() + " --seconds 0 --stats " + scene.string()).status, 2);
  EXPECT_EQ(readFile(mesh), meshBefore);
  EXPECT_EQ(readFile(scene), sceneBefore);
}

TEST(OutputFiles, ofOneRunHaveDifferentNames) {
  const auto file = (testFolder() / "all.csv").string();
  const std::string run = "run grid --set grid.resolution=5 --seconds 0.02 ";
  for (const std::string& outputs :
       {"--every 0.01 --positions " + file + " --export " + file, "--export " + file + " --export " + file,
        "--every 0.01 --positions " + file + " --stats " + file, "--save " + file + " --stats " + file}) {
    const Outcome outcome = headless(run + outputs);
    EXPECT_EQ(outcome.status, 2) << outputs;
    EXPECT_NE(outcome.errors.find("this file is also written by"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(headless(run + "--every 0.01 --positions /dev/null --stats /dev/null").status, 0)
      << "a device takes any output";
}

TEST(OutputFiles, mayReplaceTheCheckpointThatWasRead) {
  const auto file = (testFolder() / "sheet.state").string();
  const std::string run = "run grid --set grid.resolution=5 --save " + file + " --seconds ";
  ASSERT_EQ(headless(run + "0.02").status, 0);
  EXPECT_EQ(headless(run + "0.04 --resume " + file).status, 0);
}

TEST(StandardOutput, thatCannotBeWrittenIsAnErrorOfEveryCommand) {
  const auto folder = testFolder();
  const auto picture = (folder / "f.png").string();
  for (const std::string& arguments :
       {std::string("list settings --json"), std::string("list scenes"), std::string("--help"),
        std::string("run --help"), std::string("run grid --set grid.resolution=5 --seconds 0.02"),
        "capture grid --frames 1 --resolution 64,64 --output " + picture,
        std::string("measure grid --set grid.resolution=5 --seconds 0.04 --against newton"),
        std::string("hardcases --short --case heavy_gravity --solver verlet")}) {
    for (const char* redirection : {">/dev/full", ">&-"}) {
      const Outcome outcome = headlessInto(redirection, arguments);
      EXPECT_EQ(outcome.status, 1) << arguments << redirection;
      EXPECT_NE(outcome.errors.find("standard output could not be written"), std::string::npos)
          << arguments << redirection << ": " << outcome.errors;
    }
  }
  EXPECT_TRUE(std::filesystem::exists(picture)) << "what could be written stays";
  EXPECT_EQ(reportInto(">/dev/full", "--help").status, 1);
  EXPECT_EQ(reportInto(">&-", "--help").status, 1);
}

TEST(StandardOutput, thatIsClosedDoesNotEndUpInAFile) {
  const auto stats = testFolder() / "stats.json";
  EXPECT_EQ(headlessInto(">&-", "run grid --set grid.resolution=5 --seconds 0.02 --stats " + stats.string()).status, 1);
  EXPECT_TRUE(nlohmann::json::parse(readFile(stats)).is_object());
}

TEST(StandardOutput, ofAReaderThatHasEnoughIsNoConcernOfErrors) {
  EXPECT_EQ(headlessInto("| head -1 >/dev/null", "list settings").errors, "");
}

TEST(FileNames, mayBeAnyBytes) {
  // A folder, a mesh and files whose names are not UTF-8.
  const auto folder = testFolder() / "caf\xE9 \xFF";
  std::filesystem::create_directories(folder);
  const auto mesh = folder / "t\xFCr.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const auto quoted = [&](const char* name) { return "'" + (folder / name).string() + "'"; };
  const Outcome run = headless("run '" + mesh.string() + "' --seconds 0.02 --stats " + quoted("s\xE4.json") +
                               " --every 0.01 --positions " + quoted("p\xF6.csv"));
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto stats = nlohmann::json::parse(readFile(folder / "s\xE4.json"));
  EXPECT_NE(stats["scene"].get<std::string>().find("r.obj"), std::string::npos);
  EXPECT_GT(readFile(folder / "p\xF6.csv").size(), 20U);
  const Outcome capture =
      headless("capture '" + mesh.string() + "' --frames 1 --resolution 64,64 --output " + quoted("b\xFC.png"));
  EXPECT_EQ(capture.status, 0) << capture.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "b\xFC.png"));
  const Outcome measured =
      headless("measure '" + mesh.string() + "' --seconds 0.04 --against newton --json " + quoted("m\xE9.json"));
  EXPECT_EQ(measured.status, 0) << measured.errors;
  EXPECT_TRUE(nlohmann::json::parse(readFile(folder / "m\xE9.json")).is_object());
}

TEST(FileNames, mayBeThoseOfScenesOfAnyBytes) {
  const auto folder = testFolder();
  const auto scene = folder / "\xFFscene.toml";
  std::ofstream(scene) << "[cloth]\ngrid = \"horizontal\"\n[settings]\ngrid.resolution = 5\n";
  const Outcome run =
      headless("run '" + scene.string() + "' --seconds 0.02 --stats '" + (folder / "s.json").string() + "'");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(nlohmann::json::parse(readFile(folder / "s.json")).is_object());
}

TEST(FileNames, thatCannotBeWrittenAreErrorsBeforeTheRun) {
  const auto folder = testFolder();
  for (const std::string& arguments :
       {std::string("run grid --seconds 1e4 --stats /no/such/folder/s.json"),
        "run grid --seconds 1e4 --stats " + folder.string(),
        std::string("measure grid --seconds 50 --against converged --json /no/such/folder/m.json"),
        std::string("hardcases --json /no/such/folder/h.json")}) {
    const Outcome outcome = headless(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_NE(outcome.errors.find("cannot write"), std::string::npos) << outcome.errors;
  }
}

TEST(FileNames, ofARunThatFailsKeepTheirOldContent) {
  const auto folder = testFolder();
  std::ofstream(folder / "old.json") << "earlier";
  const std::string scene =
      "measure grid --set grid.resolution=9 --seconds 0.1 --against converged --reference-set solver=one_iteration "
      "--reference-tolerance 1e-12 --restarted --json ";
  EXPECT_EQ(headless(scene + (folder / "old.json").string()).status, 1) << "it does not converge";
  EXPECT_EQ(headless(scene + (folder / "new.json").string()).status, 1);
  EXPECT_EQ(readFile(folder / "old.json"), "earlier");
  EXPECT_FALSE(std::filesystem::exists(folder / "new.json")) << "no empty file is left behind";
}

TEST(FileNames, mayBeADevice) {
  const Outcome outcome = headless("run grid --set grid.resolution=5 --seconds 0.02 --stats /dev/stderr");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.errors.find("state_hash"), std::string::npos);
  EXPECT_EQ(headless("run grid --set grid.resolution=5 --seconds 0.02 --stats /dev/full").status, 1);
  EXPECT_EQ(headless("run grid --seconds 0.2 --every 0.01 --positions /dev/full").status, 1);
}

TEST(EmptyNames, areRefused) {
  for (const char* arguments : {"run '' --seconds 0.1", "run grid --seconds 0.1 --stats ''",
                                "run grid --seconds 0.1 --every 0.1 --positions ''", "run grid --seconds 0.1 --set ''",
                                "capture '' --frames 1 --output f.png", "capture grid --frames 1 --output ''",
                                "measure '' --seconds 0.1 --against newton", "measure grid --seconds 0.1 --against ''",
                                "measure grid --seconds 0.1 --against newton --json ''", "hardcases --json ''"}) {
    const Outcome outcome = headless(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.errors.find("must not be empty"), std::string::npos) << arguments << ": " << outcome.errors;
  }
  EXPECT_EQ(report("--quick --output ''").status, 2);
}

}  // namespace
}  // namespace drape::app::testing
