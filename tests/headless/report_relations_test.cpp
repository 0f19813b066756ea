#include "browser.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace drape::app::testing {
namespace {

using Json = nlohmann::json;

/// One complete quick report, which all tests below read.
class QuickReport : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::path(::testing::TempDir()) / "drape_quick_report";
    std::filesystem::remove_all(folder_);
    status_ =
        std::system((std::string(DRAPE_REPORT) + " --quick --output " + folder_.string() + " >/dev/null").c_str());
    json_ = Json::parse(readFile(folder_ / "report.json"), nullptr, false);
  }

  void SetUp() override { ASSERT_EQ(status_, 0); }

  /// The rows of a section that satisfy `isWanted`.
  template <typename Predicate>
  static std::vector<Json> rows(const char* section, const Predicate& isWanted) {
    std::vector<Json> found;
    std::copy_if(json_[section].begin(), json_[section].end(), std::back_inserter(found), isWanted);
    return found;
  }

  /// A row of work_precision on the flat sheet that falls from two corners.
  static Json work(double stiffness, const std::string& method, const std::string& setting, double time) {
    for (const Json& row : json_["work_precision"]) {
      if (row["scene"] == "hang" && row["stiffness"] == stiffness && row["method"] == method &&
          row["setting"] == setting && row["time"] == time) {
        return row;
      }
    }
    ADD_FAILURE() << "no row for " << method << " " << setting;
    return {};
  }

  static double soft(const std::string& method, const std::string& setting) {
    return work(10.0, method, setting, 0.2)["error_mean"];
  }

  static Json table2(const std::string& start, const std::string& method, const std::string& mode) {
    const auto found = rows("table2", [&](const Json& row) {
      return row["start"] == start && row["method"] == method && row["mode"] == mode;
    });
    EXPECT_EQ(found.size(), 1U) << start << " " << method << " " << mode;
    return found.empty() ? Json() : found.front();
  }

  static inline std::filesystem::path folder_;
  static inline int status_ = -1;
  static inline Json json_;
};

std::string faultsOf(const Json& json, const Json& schemaJson) {
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schemaJson), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(json), &results)) {
    return "";
  }
  std::string faults;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    for (const std::string& part : error.context) {
      faults += part;
    }
    faults += ": " + error.description + "\n";
  }
  return faults;
}

TEST_F(QuickReport, conformsToItsSchema) {
  const Json schema =
      Json::parse(readFile(std::filesystem::path(DRAPE_SOURCE) / "docs" / "guide" / "report.schema.json"));
  EXPECT_EQ(faultsOf(json_, schema), "");
  for (const auto& [name, value] : json_.items()) {
    if (value.is_array()) {
      EXPECT_FALSE(value.empty()) << name;
    }
  }
  Json wrong = json_;
  wrong["work_precision"][0]["state"] = "strange";
  EXPECT_NE(faultsOf(wrong, schema), "");
  wrong = json_;
  wrong["table2"][0].erase("eps");
  EXPECT_NE(faultsOf(wrong, schema), "");
}

TEST_F(QuickReport, findsNoSolveErrorWhereASolveConverged) {
  // Methods that solve the same step to convergence agree; the remaining error is that of the step.
  const double newton = soft("newton", "substeps=1 tolerance=1e-6 derivative=exact max_iterations=50");
  EXPECT_NEAR(soft("vbd", "iterations=10") / newton, 1.0, 0.02);
  EXPECT_NEAR(soft("local_global", "iterations=10") / newton, 1.0, 0.02);
}

TEST_F(QuickReport, findsMoreSweepsNotWorse) {
  EXPECT_LE(soft("one_iteration", "sweeps=9"), soft("one_iteration", "sweeps=3"));
  EXPECT_LE(soft("one_iteration", "sweeps=3"), soft("one_iteration", "substeps=1"));
}

TEST_F(QuickReport, readsTheOrderOfConvergenceOffTheCurves) {
  const auto order = [](const std::string& method, const std::string& rest) {
    const double coarse = soft(method, "substeps=4" + rest);
    const double fine = soft(method, "substeps=16" + rest);
    return std::log2(coarse / fine) / 2.0;
  };
  EXPECT_NEAR(order("verlet", ""), 2.0, 0.35);
  EXPECT_NEAR(order("one_iteration", ""), 1.0, 0.35);
  EXPECT_NEAR(order("one_iteration", " integration=theta theta=0.5"), 2.0, 0.7);
  EXPECT_NEAR(order("xpbd", " iterations=1"), 1.0, 0.5);
}

TEST_F(QuickReport, findsVerletAheadOnSoftClothAndAbsentOnStiff) {
  // The most accurate setting on soft cloth is one of Verlet or of a higher-order relative ...
  auto soft = rows("work_precision", [](const Json& row) {
    return row["scene"] == "hang" && row["stiffness"] == 10.0 && row["time"] == 0.2 && row["state"] == "calm";
  });
  ASSERT_FALSE(soft.empty());
  const auto best = std::min_element(soft.begin(), soft.end(), [](const Json& a, const Json& b) {
    return a["error_mean"].get<double>() < b["error_mean"].get<double>();
  });
  EXPECT_TRUE((*best)["method"] == "verlet" || (*best)["method"] == "auto") << *best;
  // ... and on stiff cloth all settings of its short lists explode.
  const auto stiff = rows("work_precision", [](const Json& row) {
    return row["scene"] == "hang" && row["stiffness"] == 1e5 && row["method"] == "verlet";
  });
  ASSERT_FALSE(stiff.empty());
  for (const Json& row : stiff) {
    EXPECT_EQ(row["state"], "exploded") << row;
  }
}

TEST_F(QuickReport, comparesTheSolversThatTakeAFabricOnIt) {
  std::set<std::string> methods;
  for (const Json& row : json_["work_precision"]) {
    if (row["material"] == "jersey") {
      EXPECT_TRUE(row["stiffness"].is_null());
      EXPECT_TRUE(row["trusted"]) << row;
      methods.insert(row["method"]);
    }
  }
  EXPECT_EQ(methods, (std::set<std::string>{"auto", "chebyshev", "explicit_euler", "newton", "one_iteration", "pcg",
                                            "vbd", "verlet", "xpbd"}));
}

/// eps of backward Euler with n steps an interval against explicit Euler with m, both falling freely from rest, in
/// interval k: (n (2k - 1) + 1) / n against (m (2k - 1) - 1) / m intervals' lengths.
double freeFallEps(double n, double m, double k) {
  const double own = 2.0 * k - 1.0 + 1.0 / n;
  const double reference = 2.0 * k - 1.0 - 1.0 / m;
  return std::pow(own / reference - 1.0, 2);
}

TEST_F(QuickReport, findsTheClosedFormOfFreeFall) {
  const Json row = table2("free fall", "pcg", "free-running");
  ASSERT_EQ(row["eps"].size(), 25U);
  for (std::size_t k = 0; k < 25; ++k) {
    const double expected = freeFallEps(5.0, 1000.0, static_cast<double>(k + 1));
    EXPECT_NEAR(row["eps"][k].get<double>() / expected, 1.0, 1e-3) << k;
    EXPECT_NEAR(row["S"][k].get<double>(), 1.0, 1e-9);
  }
  EXPECT_NEAR(row["eps"][0].get<double>(), 0.04, 0.002);
}

TEST_F(QuickReport, findsThatOneSweepAddsToTheErrorOfTheSolvedStep) {
  for (const char* start : {"flat, two corners", "swinging, edge"}) {
    EXPECT_GT(table2(start, "one_iteration", "free-running")["eps_mean"],
              table2(start, "pcg", "free-running")["eps_mean"]);
  }
}

TEST_F(QuickReport, namesAsCheapestWhatIsCheapestInItsOwnRows) {
  int named = 0;
  for (const Json& answer : json_["conclusions"]) {
    if (answer["question"] != "cheapest" || answer["method"].is_null()) {
      continue;
    }
    ++named;
    EXPECT_LT(answer["error_of_diagonal"], answer["share"]);
    for (const Json& row : json_["work_precision"]) {
      const bool same = row["scene"] == answer["scene"] && row["stiffness"] == answer["stiffness"] &&
                        row["material"] == answer["material"] && row["resolution"] == answer["resolution"] &&
                        row["time"] == answer["time"];
      if (same && row["state"] == "calm" && row["us_per_simulated_second"].is_number() &&
          row["error_of_diagonal"] < answer["share"]) {
        EXPECT_GE(row["us_per_simulated_second"], answer["us_per_simulated_second"]);
      }
    }
  }
  EXPECT_GT(named, 3);
}

/// The command of a browser; empty when there is none.
std::string browser() {
  for (const char* name : {"chromium", "google-chrome", "chromium-browser"}) {
    if (std::system((std::string("command -v ") + name + " >/dev/null 2>&1").c_str()) == 0) {
      return name;
    }
  }
  return "";
}

TEST_F(QuickReport, opensInABrowser) {
  const std::string program = browser();
  if (program.empty()) {
    GTEST_SKIP() << "Chromium is not installed";
  }
  const auto page = folder_ / "report.html";
  const auto dom = folder_ / "dom.html";
  const auto log = folder_ / "browser.log";
  // A script in the page reports its layout width and the size of each picture.
  const auto probe = folder_ / "probe.html";
  std::string html = readFile(page);
  const std::string script =
      "<script>addEventListener('load',()=>{const s=[...document.querySelectorAll('svg.drape')].map("
      "e=>e.getBoundingClientRect());document.body.setAttribute('data-drawn',s.filter(r=>r.width>200&&r.height>100)"
      ".length);document.body.setAttribute('data-wide',document.documentElement.scrollWidth>innerWidth);});</script>";
  html.insert(html.rfind("</body>"), script);
  std::ofstream(probe) << html;
  const std::string command = program +
                              " --headless --no-sandbox --disable-gpu --window-size=1100,900 --user-data-dir=" +
                              (folder_ / "profile").string() + " --dump-dom file://" + probe.string() + " >" +
                              dom.string() + " 2>" + log.string();
  ASSERT_EQ(std::system(command.c_str()), 0) << readFile(log);
  const std::string seen = readFile(dom);
  std::size_t pictures = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) {
    ++pictures;
  }
  EXPECT_GT(pictures, 10U);
  EXPECT_NE(seen.find("data-drawn=\"" + std::to_string(pictures) + "\""), std::string::npos);
  EXPECT_NE(seen.find("data-wide=\"false\""), std::string::npos);
}

TEST_F(QuickReport, answersFirstAndDecidesEachClaimByItsOwnRows) {
  std::map<std::string, std::string> verdicts;
  int answered = 0;
  for (const Json& row : json_["answer"]) {
    if (row["question"] == "claim") {
      verdicts[row["claim"]] = row["verdict"];
    } else if (!row["method"].is_null()) {
      ++answered;
      EXPECT_LE(row["cost_ms"], row["budget_ms"]) << row;
    }
  }
  EXPECT_GT(answered, 4);
  EXPECT_EQ(verdicts.size(), 7U);
  // The quick report has no run that compresses a sheet, and its runs of Table 2 are all far from the paper's.
  EXPECT_EQ(verdicts["No instability under compression"], "not measured");
  EXPECT_EQ(verdicts["Table 2: eps of at most 0.000485 (k = 10 N/m)"], "refuted");
  EXPECT_EQ(verdicts["Drag and lift look right"], "not testable");
  const std::string html = readFile(folder_ / "report.html");
  EXPECT_LT(html.find("The method to take"), html.find("<svg"));
}

/// Everything that reaches beyond the right edge of the window, folded tables included, and text beyond its picture.
constexpr const char* tooWide = R"(
  for (const details of document.querySelectorAll('details')) details.open = true;
  const beyond = [];
  const edge = document.documentElement.clientWidth + 0.5;
  const name = (e) => e.tagName + ' "' + e.textContent.trim().slice(0, 60) + '"; ';
  for (const e of document.querySelectorAll('body *')) {
    const inPicture = e.ownerSVGElement;
    const right = inPicture ? inPicture.getBoundingClientRect().right + 0.5 : edge;
    if ((!inPicture || e.tagName == 'text') && e.getBoundingClientRect().right > right) beyond.push(name(e));
  }
  return beyond.join('');
)";

void expectNowhereWiderThanTheScreenOrThePaper(const std::string& html) {
  const PageVisit screen = visitPage(html, 1440, 900, tooWide, testFolder());
  EXPECT_EQ(screen.result, "");
  EXPECT_EQ(screen.console, "");
  EXPECT_NE(visitPage(html, 300, 900, tooWide, testFolder()).result, "") << "a table does not fit a window this narrow";
  // A page of A4 between the browser's margins, at 96 pixels an inch.
  std::string print = html;
  print.replace(print.find("@media print"), 12, "@media all");
  constexpr int paperWidth = 718;
  const PageVisit paper = visitPage(print, paperWidth, 1000, tooWide, testFolder());
  EXPECT_EQ(paper.result, "");
  EXPECT_EQ(paper.console, "");
}

void expectAnswerThatFitsAScreen(const std::string& html) {
  const PageVisit visit =
      visitPage(html, 1440, 900, "return '' + document.querySelector('section.answer').getBoundingClientRect().bottom;",
                testFolder());
  ASSERT_NE(visit.result.find_first_of("0123456789"), std::string::npos) << visit.result;
  EXPECT_LE(std::stod(visit.result), 900.0);
  EXPECT_GT(std::stod(visit.result), 200.0);
}

TEST_F(QuickReport, isNowhereWiderThanTheScreenOrThePaperInABrowser) {
  if (!hasBrowser()) {
    GTEST_SKIP() << "chromium is not installed";
  }
  expectNowhereWiderThanTheScreenOrThePaper(readFile(folder_ / "report.html"));
}

TEST_F(QuickReport, beginsWithAnAnswerThatFitsAScreen) {
  if (!hasBrowser()) {
    GTEST_SKIP() << "chromium is not installed";
  }
  expectAnswerThatFitsAScreen(readFile(folder_ / "report.html"));
}

/// A full report takes an hour, so scripts/update-report runs this test on the one that it has made.
TEST(FullReport, fitsTheScreenAndThePaperInABrowser) {
  const char* folder = std::getenv("DRAPE_REPORT_FOLDER");
  if (folder == nullptr) {
    GTEST_SKIP() << "DRAPE_REPORT_FOLDER does not name the folder of a full report";
  }
  ASSERT_TRUE(hasBrowser());
  const std::string html = readFile(std::filesystem::path(folder) / "report.html");
  ASSERT_FALSE(html.empty()) << folder;
  expectNowhereWiderThanTheScreenOrThePaper(html);
  expectAnswerThatFitsAScreen(html);
}

}  // namespace
}  // namespace drape::app::testing
