#include "report/sections/error_sources_view.hpp"
#include "report/sections/sections.hpp"

#include <gtest/gtest.h>
#include <variant>

namespace drape::report {
namespace {

TEST(ErrorSources, findsThatTheMeshMovesAHangingSheetMuchMoreThanTheSolverDoes) {
  ReportOptions options;
  options.quick = true;
  options.scene = "hang";
  const SectionPlan plan = sections::errorSources().plan(options);
  ASSERT_FALSE(plan.cells.empty());
  const ReportRow row = plan.cells.front().measure({{}, {}}).at(1);
  EXPECT_EQ(row["time"], 0.5);
  EXPECT_GT(row["mesh"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["implicit"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["stiffer"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["diagonals"].get<double>(), 10.0 * row["auto"].get<double>()) << "a sheet on two corners is symmetric";
  EXPECT_LT(row["jitter"].get<double>(), 1e-4);
}

TEST(ErrorSources, namesTheLargestSourceAndChaosWhereThatIsLarger) {
  ReportRow row{{"scene", "hang"},      {"resolution", 17}, {"material", "springs"}, {"stiffness", 10.0},
                {"time", 0.2},          {"auto", 1e-5},     {"implicit", 8e-3},      {"mesh", 5e-3},
                {"diagonals", nullptr}, {"stiffer", 1e-3},  {"jitter", 1e-6}};
  const auto dominant = [](const ReportRow& one) {
    return std::get<TextTable>(sections::showErrorSources({}, {one}).back()).rows.at(0).back();
  };
  EXPECT_EQ(dominant(row), "mesh") << "the implicit solver is there for comparison";
  row["jitter"] = 1e-2;
  EXPECT_EQ(dominant(row), "chaos");
}

}  // namespace
}  // namespace drape::report
