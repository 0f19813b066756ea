// The numbers of the section Export.
#include "panel_fixture.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

class ExportPanel : public PanelFixture {
 protected:
  ExportPanel() {
    click(button("export.kind=motion"));
    settle();
  }

  /// The request of the button Export.
  ExportRequest exported() {
    const UiOutput output = click(button("button.export"));
    return std::get<ExportRequest>(output.requests.at(0));
  }
};

TEST_F(ExportPanel, ANumberWithinItsRangeStays) {
  EXPECT_TRUE(typeInto(button("export.to"), "12.5").hint.empty());
  EXPECT_EQ(exported().to, 12.5);
}

TEST_F(ExportPanel, ANumberBeyondItsRangeBecomesTheNearestAndAHintSaysSo) {
  EXPECT_EQ(typeInto(button("export.rate"), "5000").hint,
            "Frame rate must be a number from 0.1 to 1000, so 5000 became 1000");
  EXPECT_EQ(typeInto(button("export.from"), "-2").hint,
            "The time of the first frame must be a number from 0 to 3600, so -2 became 0");
  EXPECT_EQ(typeInto(button("export.to"), "9999").hint,
            "The time of the last frame must be a number from 0 to 3600, so 9999 became 3600");
  const ExportRequest request = exported();
  EXPECT_EQ(request.rate, 1000.0);
  EXPECT_EQ(request.from, 0.0);
  EXPECT_EQ(request.to, 3600.0);
}

}  // namespace
}  // namespace drape::ui
