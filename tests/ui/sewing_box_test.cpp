// The box of the mode Sew, and the rows of the section Scene for seams and elastic bands.
#include "panel_fixture.hpp"

#include "locale/language.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <variant>

namespace drape::ui {
namespace {

/// The last one.
std::optional<SewingRequest> sewingRequest(const UiOutput& output) {
  std::optional<SewingRequest> found;
  for (const UiRequest& request : output.requests) {
    if (const auto* sewing = std::get_if<SewingRequest>(&request)) {
      found = *sewing;
    }
  }
  return found;
}

const session::SetSewingCommand* sewingCommand(const UiOutput& output) {
  for (const session::Command& command : output.commands) {
    if (const auto* sewing = std::get_if<session::SetSewingCommand>(&command)) {
      return sewing;
    }
  }
  return nullptr;
}

class SewingBox : public PanelFixture {
 protected:
  void show(const SewingView& view) {
    stats_.sewing = view;
    settle();
  }

  static SewingView picked() {
    SewingView view;
    const PickedSide side{{{Vec2(600, 200), Vec2(700, 200)}, false}, 2, 0.1};
    view.sides = {side, side};
    view.pairs = {{Vec2(600, 200), Vec2(600, 300)}, {Vec2(700, 200), Vec2(700, 300)}};
    return view;
  }

  /// Gives the grid a seam between two of its sides, and a band.
  void sewGrid() {
    const int side = static_cast<int>(simulation_.settings().grid.resolution);
    scene::Sewing sewing = simulation_.sewing();
    sewing.seams.emplace_back().pairs = {{side * (side - 1), side * side - 1}};
    sewing.bands[0].push_back({.length = 0.9, .vertices = {0}});
    simulation_.apply(session::SetSewingCommand{sewing});
    simulation_.capture(snapshot_);
    EXPECT_TRUE(snapshot_.message.empty()) << snapshot_.message;
    settle();
  }
};

TEST_F(SewingBox, TheSectionSceneStartsTheMode) {
  const UiOutput output = click(button("sew=band"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::SetBand);
  EXPECT_FALSE(panels_.buttons().contains("overlay.sewing"));
}

TEST_F(SewingBox, SewsOnlyTwoBordersThatFit) {
  show({});
  EXPECT_FALSE(sewingRequest(click(button("button.sew"))).has_value()) << "nothing is picked";
  show(picked());
  EXPECT_EQ(sewingRequest(click(button("button.sew"))).value().kind, SewingRequest::Kind::Sew);
  EXPECT_EQ(sewingRequest(click(button("button.flip_seam"))).value().kind, SewingRequest::Kind::Flip);
  SewingView refused = picked();
  refused.problem = text::Sentence("other seams join these vertices already");
  show(refused);
  EXPECT_FALSE(sewingRequest(click(button("button.sew"))).has_value());
  EXPECT_EQ(sewingRequest(click(button("button.end_sewing"))).value().kind, SewingRequest::Kind::End);
}

TEST_F(SewingBox, ChoosesWhatAClickPicks) {
  show({});
  const auto extent = sewingRequest(click(button("sewing.extent=whole")));
  ASSERT_TRUE(extent.has_value());
  EXPECT_EQ(extent->kind, SewingRequest::Kind::UseExtent);
  EXPECT_EQ(extent->extent, BorderExtent::Whole);
  const auto kind = sewingRequest(click(button("sewing.kind=band")));
  ASSERT_TRUE(kind.has_value());
  EXPECT_EQ(kind->sewing, SewingKind::Band);
}

TEST_F(SewingBox, SetsABandOfTheTypedLength) {
  SewingView view = picked();
  view.kind = SewingKind::Band;
  view.sides.pop_back();
  view.pairs.clear();
  show(view);
  typeInto(widget("sewing.length"), "0.4");
  const auto set = sewingRequest(click(button("button.set_band")));
  ASSERT_TRUE(set.has_value());
  EXPECT_EQ(set->kind, SewingRequest::Kind::SetBand);
  EXPECT_EQ(set->length, 0.4);
  const UiOutput refused = typeInto(widget("sewing.length"), "0.1");
  EXPECT_EQ(refused.hint, "The length of a band must be a number from 0.3 to 1.5, not '0.1'");
  view.bandLength = 0.8;
  show(view);
  EXPECT_FALSE(sewingRequest(click(button("button.set_band"))).has_value()) << "it is there";
  EXPECT_NEAR(sewingRequest(drag(widget("sewing.length"), 0.5, 0.9)).value().length, 0.95, 0.05)
      << "the slider changes it at once";
}

TEST_F(SewingBox, ListsSeamsAndBandsAndRemovesThem) {
  EXPECT_FALSE(panels_.buttons().contains("button.remove_seam.0"));
  sewGrid();
  const UiOutput seam = click(button("button.remove_seam.0"));
  ASSERT_NE(sewingCommand(seam), nullptr);
  EXPECT_TRUE(sewingCommand(seam)->sewing.seams.empty());
  EXPECT_EQ(sewingCommand(seam)->sewing.bands[0].size(), 1U);
  const UiOutput band = click(button("button.remove_band.0"));
  ASSERT_NE(sewingCommand(band), nullptr);
  EXPECT_TRUE(sewingCommand(band)->sewing.bands[0].empty());
  const UiOutput length = typeInto(widget("band.0"), "1.2");
  ASSERT_NE(sewingCommand(length), nullptr);
  EXPECT_EQ(sewingCommand(length)->sewing.bands[0][0].length, 1.2);
}

TEST_F(SewingBox, IsTranslated) {
  std::set<std::string> missing;
  locale::Language german = *locale::findLanguage("de");
  german.texts.reportMissing(&missing);
  panels_.useLanguage(german);
  sewGrid();
  SewingView view = picked();
  for (const auto kind : {SewingKind::Seam, SewingKind::Band}) {
    for (const auto extent : {BorderExtent::Corners, BorderExtent::Points, BorderExtent::Whole}) {
      view.kind = kind;
      view.extent = extent;
      show(view);
    }
  }
  view.kind = SewingKind::Seam;
  view.sides[1].vertices = 5;
  show(view);
  EXPECT_TRUE(missing.empty()) << *missing.begin();
}

}  // namespace
}  // namespace drape::ui
