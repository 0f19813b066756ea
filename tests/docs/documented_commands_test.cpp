// Tries every command of the documentation, so that readers can copy it.
#include "documented_commands.hpp"
#include "process.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace drape::app::testing {
namespace {

namespace fs = std::filesystem;

constexpr int longestRun = 15;        // a command that runs this long works [s]
constexpr int timedOut = 124;         // status of timeout(1)
constexpr double longestWait = 90.0;  // for a window on a machine under load [s]

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The name of a command among the tests: "README_14_run".
std::string testName(const ::testing::TestParamInfo<DocumentedCommand>& info) {
  std::string name = info.param.page + "_" + std::to_string(info.param.line) + "_" + info.param.program + "_" +
                     std::to_string(info.index);
  for (char& letter : name) {
    letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  }
  return name;
}

/// Creates the files of the examples: a T-shirt in centimetres and a scene.
void addExampleFiles(const fs::path& folder) {
  std::ifstream metres(fs::path(DRAPE_SOURCE) / "assets/meshes/tshirt.obj");
  std::ofstream shirt(folder / "shirt.obj");
  for (std::string line; std::getline(metres, line);) {
    std::istringstream words(line);
    std::string keyword;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    if (words >> keyword >> x >> y >> z && keyword == "v") {
      shirt << "v " << 100.0 * x << ' ' << 100.0 * y << ' ' << 100.0 * z << '\n';
    } else {
      shirt << line << '\n';
    }
  }
  std::ofstream(folder / "my_scene.toml")
      << "title = \"Mine\"\n[cloth]\ngrid = \"vertical\"\n[pins]\nedges = [\"top\"]\n";
}

class Documentation : public ::testing::TestWithParam<DocumentedCommand> {
 protected:
  void SetUp() override { addExampleFiles(folder_.path()); }

  /// Runs a shell command in the folder of examples, with the built programs in the path.
  int shell(const std::string& command) {
    return runToEnd({.command = {"timeout", "--signal=INT", "--kill-after=10", std::to_string(longestRun), "bash", "-c",
                                 "export PATH=" DRAPE_BIN ":$PATH; " + command},
                     .folder = folder_.path(),
                     .output = output()});
  }

  [[nodiscard]] fs::path output() const { return folder_.path() / "output.txt"; }
  [[nodiscard]] fs::path folder() const { return folder_.path(); }

  /// Opens the window with those arguments and waits until it shows the cloth.
  void openWindow(const std::string& arguments) {
    const VirtualDisplay display;
    Process viewer({.command = {"bash", "-c", "exec " DRAPE_BIN "/drape " + arguments + " --status status.json"},
                    .environment = {{"DISPLAY", display.name()}, {"WAYLAND_DISPLAY", ""}},
                    .folder = folder(),
                    .output = output()});
    const std::regex drawn("\"frame\": *[1-9]");
    for (double waited = 0.0; waited < longestWait && viewer.running(); waited += 0.1) {
      if (std::regex_search(contentOf(folder() / "status.json"), drawn)) {
        return;
      }
      (void)viewer.waitFor(0.1);
    }
    FAIL() << "no window: " << contentOf(output());
  }

  void callProgram(const DocumentedCommand& command) {
    if (!command.needs.empty()) {
      ASSERT_EQ(shell(command.needs), 0) << command.needs << ": " << contentOf(output());
    }
    const int status = shell(std::regex_replace(command.text, std::regex("^build/release/bin/"), ""));
    const std::string printed = contentOf(output());
    // Two subcommands end with 1 when a result exceeds its limit, as many do, and then say so (docs/guide/headless.md).
    const bool exceedsLimits =
        status == 1 && std::regex_search(printed, std::regex("failed hard cases, of|off by more than the aim"));
    EXPECT_TRUE(status == 0 || status == timedOut || exceedsLimits) << "status " << status << ": " << printed;
  }

  /// Checks that each pattern of the filter matches a test; CTest runs the tests themselves.
  void findTests(const DocumentedCommand& command) {
    std::smatch filter;
    ASSERT_TRUE(std::regex_search(command.text, filter, std::regex("--gtest_filter='?([^' ]+)")));
    std::istringstream patterns(filter[1]);
    for (std::string pattern; std::getline(patterns, pattern, ':');) {
      ASSERT_EQ(shell(command.program + " --gtest_list_tests --gtest_filter='" + pattern + "'"), 0);
      EXPECT_NE(contentOf(output()).find("\n  "), std::string::npos) << "no test is called " << pattern;
    }
  }

  void findPreset(const DocumentedCommand& command) {
    std::smatch preset;
    ASSERT_TRUE(std::regex_search(command.text, preset, std::regex("--preset ([a-z]+)")));
    const std::string kind = command.program == "ctest"                          ? "test"
                             : command.text.find("--build") == std::string::npos ? "configure"
                                                                                 : "build";
    ASSERT_EQ(shell("cd " DRAPE_SOURCE " && cmake --list-presets=" + kind), 0);
    EXPECT_NE(contentOf(output()).find('"' + preset[1].str() + '"'), std::string::npos) << contentOf(output());
  }

  /// Checks that the options of a synopsis are in the program's help.
  void findOptions(const DocumentedCommand& command) {
    std::istringstream words(command.text);
    std::string program;
    std::string first;
    words >> program >> first;
    // The window has one subcommand only.
    const bool subcommand =
        first == "dress" || (command.program == "drape-headless" && first.find_first_of("-[.A") != 0);
    ASSERT_EQ(shell(command.program + (subcommand ? " " + first : "") + " --help"), 0) << contentOf(output());
    const std::string help = contentOf(output());
    const std::regex option("--[a-z-]+");
    for (std::sregex_iterator found(command.text.begin(), command.text.end(), option), end; found != end; ++found) {
      EXPECT_NE(help.find(found->str()), std::string::npos) << found->str() << " is not in the help";
    }
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(Documentation, printsCommandsThatWork) {
  const DocumentedCommand& command = GetParam();
  SCOPED_TRACE(command);
  const bool window = (command.script && command.program == "run") || (!command.script && command.program == "drape");
  if (command.script && !window) {
    // These scripts install, build or measure for minutes, or run these tests.
    const fs::path script = fs::path(DRAPE_SOURCE) / "scripts" / command.program;
    EXPECT_EQ(shell("test -x " + script.string() + " && bash -n " + script.string()), 0) << "there is no such script";
  } else if (command.program == "cmake" || command.program == "ctest") {
    findPreset(command);
  } else if (command.program == "drape_bench") {
    GTEST_SKIP() << "the benchmarks are not built for the tests";
  } else if (command.program.find("_tests") != std::string::npos) {
    findTests(command);
  } else if (command.synopsis) {
    findOptions(command);
  } else if (window) {
    openWindow(command.text.substr(command.text.find(' ')));
  } else {
    callProgram(command);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Documentation, ::testing::ValuesIn(documentedCommands(DRAPE_SOURCE)), testName);

TEST(DocumentedCommands, areFoundInBlocksAndSpansWithTheirLines) {
  const auto commands =
      commandsIn("page.md",
                 "Call `drape flag` or `drape`.\n"
                 "\n"
                 "    scripts/run     # build\n"
                 "    drape-headless run grid \\\n"
                 "      --seconds 1   # a second\n"
                 "| `drape-headless list scenes\\|settings [--json]` | `sim_tests --gtest_filter='A.*'` |\n"
                 "```\n"
                 "drape-report --only SECTION\n"
                 "other thing\n"
                 "```\n");
  ASSERT_EQ(commands.size(), 5U);
  EXPECT_EQ(commands[0].text, "drape flag");
  EXPECT_EQ(commands[0].line, 1);
  EXPECT_EQ(commands[1].text, "drape-headless run grid --seconds 1");
  EXPECT_EQ(commands[1].line, 4);
  EXPECT_FALSE(commands[1].synopsis);
  EXPECT_EQ(commands[2].text, "drape-headless list scenes|settings [--json]");
  EXPECT_TRUE(commands[2].synopsis);
  EXPECT_EQ(commands[3].program, "sim_tests");
  EXPECT_TRUE(commands[4].synopsis);
  EXPECT_EQ(commands[4].line, 8);
}

TEST(DocumentedCommands, thatReadAFileNeedTheCommandThatWritesIt) {
  const auto commands = commandsIn("page.md",
                                   "    drape-headless run skirt --save a.state\n"
                                   "    drape-headless run skirt --save b.state\n"
                                   "    drape-headless run skirt --seconds 2 --resume a.state\n"
                                   "    drape-headless save flag --output mine.toml\n"
                                   "    drape-headless run mine.toml --output other.toml\n");
  ASSERT_EQ(commands.size(), 5U);
  EXPECT_EQ(commands[4].needs, "drape-headless save flag --output mine.toml");
  EXPECT_EQ(commands[0].needs, "");
  EXPECT_EQ(commands[2].needs, "drape-headless run skirt --save a.state");
}

TEST(DocumentedCommands, ofTheFrontPageAreAllFound) {
  std::set<std::string> found;
  for (const DocumentedCommand& command : documentedCommands(DRAPE_SOURCE)) {
    if (command.page == "README.md") {
      found.insert(command.program);
    }
  }
  for (const char* program : {"run", "drape", "drape-headless", "drape-report", "drape-make-garments"}) {
    EXPECT_EQ(found.count(program), 1U) << program;
  }
}

}  // namespace
}  // namespace drape::app::testing
