// The comparison of the sources of error in the section Performance.
#include "panel_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

namespace drape::ui {
namespace {

class ErrorSourcesPanel : public PanelFixture {
 protected:
  void openPerformance() {
    settle();
    if (!panels_.buttons().contains("compare_errors")) {
      click(button("section.performance"));
      settle();
    }
  }

  static bool asks(const UiOutput& output, UiAction wanted) {
    return std::ranges::any_of(output.requests, [&](const UiRequest& request) {
      const auto* action = std::get_if<UiAction>(&request);
      return action != nullptr && *action == wanted;
    });
  }
};

TEST_F(ErrorSourcesPanel, StartsAComparisonAndCancelsIt) {
  openPerformance();
  EXPECT_TRUE(asks(click(button("compare_errors")), UiAction::CompareErrors));
  stats_.errors.share = 0.34;
  settle();
  EXPECT_TRUE(asks(click(button("compare_errors")), UiAction::CancelComparison));
}

}  // namespace
}  // namespace drape::ui
