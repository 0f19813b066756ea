// The box of the mode Place: its buttons and numbers.
#include "panel_fixture.hpp"

#include "locale/language.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace drape::ui {
namespace {

/// The last request of the box with this kind.
std::optional<PlacingRequest> placingRequest(const UiOutput& output, PlacingRequest::Kind kind) {
  std::optional<PlacingRequest> found;
  for (const UiRequest& request : output.requests) {
    const auto* placing = std::get_if<PlacingRequest>(&request);
    if (placing != nullptr && placing->kind == kind) {
      found = *placing;
    }
  }
  return found;
}

class PlacingBox : public PanelFixture {
 protected:
  PlacingBox() : PanelFixture("sphere") {
    placing_.middle = placing_.rawMiddle = Vec3(0.0, 1.02, 0.0);
    placing_.handles.push_back({GizmoHandle::MoveX, {Vec2(700, 300), Vec2(790, 300)}, Vec2(775, 300), false});
    placing_.box.push_back({Vec2(600, 200), Vec2(800, 200)});
    show();
  }

  void show() {
    stats_.placing = placing_;
    settle();
  }

  PlacingView placing_;
};

TEST_F(PlacingBox, TheSectionSceneStartsAndEndsTheMode) {
  EXPECT_TRUE(placingRequest(click(button("button.place")), PlacingRequest::Kind::End).has_value());
  stats_.placing.reset();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.placing"));
  const UiOutput output = click(button("button.place"));
  EXPECT_TRUE(std::ranges::any_of(output.requests, [](const UiRequest& request) {
    const auto* action = std::get_if<UiAction>(&request);
    return action != nullptr && *action == UiAction::Place;
  }));
}

TEST_F(PlacingBox, HasToolsThingsAndButtons) {
  const auto tool = placingRequest(click(button("placing.tool=turn")), PlacingRequest::Kind::UseTool);
  ASSERT_TRUE(tool.has_value());
  EXPECT_EQ(tool->tool, PlacingTool::Turn);
  EXPECT_TRUE(placingRequest(click(button("button.place_on_ground")), PlacingRequest::Kind::OnGround).has_value());
  EXPECT_TRUE(placingRequest(click(button("button.restore_placement")), PlacingRequest::Kind::Restore).has_value());
  EXPECT_TRUE(placingRequest(click(button("button.end_placing")), PlacingRequest::Kind::End).has_value());
  click(button("placing.thing"));
  settle();
  const auto thing = placingRequest(click(button("placing.thing=sphere")), PlacingRequest::Kind::Choose);
  ASSERT_TRUE(thing.has_value());
  EXPECT_EQ(thing->thing, (scene::Placeable{scene::Placeable::Kind::Body, 0}));
}

TEST_F(PlacingBox, FitsIntoThePictureOfANarrowWindowWithLargeText) {
  for (const char* language : {"en", "de"}) {
    panels_.useLanguage(*locale::findLanguage(language));
    for (const float scale : {1.0F, 2.0F}) {
      panels_.setDisplay({.width = 800, .height = 600, .density = 1.0F, .scale = scale});
      show();
      show();
      const UiRect box = button("overlay.placing");
      const UiRect view = panels_.view();
      EXPECT_GE(box.x, view.x);
      EXPECT_LE(box.x + box.width, view.x + view.width) << language << ", scale " << scale;
      EXPECT_LE(box.y + box.height, view.y + view.height) << language << ", scale " << scale;
      for (const char* name : {"button.place_on_ground", "button.restore_placement", "button.end_placing"}) {
        EXPECT_LE(button(name).x + button(name).width, box.x + box.width) << name << ", " << language;
      }
    }
  }
}

TEST_F(PlacingBox, ATypedPositionIsThatOfTheMiddle) {
  const auto place = placingRequest(typeInto(widget("placing.position.y"), "1.5"), PlacingRequest::Kind::Place);
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE(place->placement.applied(placing_.rawMiddle).isApprox(Vec3(0.0, 1.5, 0.0), 1e-12));
  EXPECT_EQ(place->placement.scale, 1.0);
}

TEST_F(PlacingBox, ATypedRotationKeepsTheMiddle) {
  const auto place = placingRequest(typeInto(widget("placing.rotation.z"), "90"), PlacingRequest::Kind::Place);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->placement.rotation, Vec3(0, 0, 90));
  EXPECT_LT((place->placement.applied(placing_.rawMiddle) - placing_.middle).norm(), 1e-6);
}

TEST_F(PlacingBox, RefusesNumbersOutsideTheirRanges) {
  const UiOutput tooLarge = typeInto(widget("placing.scale"), "1000");
  EXPECT_FALSE(placingRequest(tooLarge, PlacingRequest::Kind::Place).has_value());
  EXPECT_EQ(tooLarge.hint, "Scale must be a number from 0.01 to 100, not '1000'");
  const UiOutput tooFar = typeInto(widget("placing.position.x"), "-500");
  EXPECT_FALSE(placingRequest(tooFar, PlacingRequest::Kind::Place).has_value());
  EXPECT_EQ(tooFar.hint, "Position x must be a number from -100 to 100 m, not '-500'");
  EXPECT_NE(typeInto(widget("placing.rotation.y"), "nan").hint.english().find("Rotation y must be"), std::string::npos);
}

TEST_F(PlacingBox, ADragOfANumberIsAPreviewUntilTheEnd) {
  const UiOutput output = drag(widget("placing.scale"), 0.5, 0.8);
  const auto preview = placingRequest(output, PlacingRequest::Kind::Preview);
  ASSERT_TRUE(preview.has_value());
  EXPECT_GT(preview->placement.scale, 1.0);
  EXPECT_FALSE(placingRequest(output, PlacingRequest::Kind::Place).has_value());
  EXPECT_TRUE(placingRequest(output, PlacingRequest::Kind::Keep).has_value());
}

TEST_F(PlacingBox, SaysWhatAGripIsCalled) {
  const UiRect& grip = button("gizmo.x");
  EXPECT_NEAR(grip.x + 0.5 * grip.width, 775.0, 1e-9);
  EXPECT_FALSE(panels_.covers(Vec2(775.0, 300.0))) << "the press belongs to the picture";
}

class PlacingBoxOfAFigure : public PanelFixture {
 protected:
  PlacingBoxOfAFigure() : PanelFixture("dance") {
    stats_.placing.emplace();
    stats_.placing->thing = {scene::Placeable::Kind::Body, 0};
    settle();
  }
};

TEST_F(PlacingBoxOfAFigure, HasNoScale) {
  EXPECT_FALSE(panels_.widgets().contains("placing.scale"));
  EXPECT_TRUE(panels_.widgets().contains("placing.position.x"));
}

TEST_F(PlacingBox, ChangesUnitAndUpAxisOfAFile) {
  EXPECT_FALSE(panels_.buttons().contains("placing.unit=cm")) << "a sphere has no file";
  placing_.reading = scene::ReadingChoice{"cm", "y"};
  show();
  const auto unit = placingRequest(click(button("placing.unit=inch")), PlacingRequest::Kind::Read);
  ASSERT_TRUE(unit.has_value());
  EXPECT_EQ(unit->reading, (scene::ReadingChoice{"inch", "y"}));
  const auto up = placingRequest(click(button("placing.up=z")), PlacingRequest::Kind::Read);
  ASSERT_TRUE(up.has_value());
  EXPECT_EQ(up->reading, (scene::ReadingChoice{"cm", "z"}));
  EXPECT_FALSE(placingRequest(click(button("placing.unit=cm")), PlacingRequest::Kind::Read)) << "it is that already";
}

TEST_F(PlacingBox, PutsTheClothOnTheBodyAndDressesIt) {
  const auto requests = [](const UiOutput& output, UiAction wanted) {
    return std::ranges::any_of(output.requests, [&](const UiRequest& request) {
      const auto* action = std::get_if<UiAction>(&request);
      return action != nullptr && *action == wanted;
    });
  };
  EXPECT_TRUE(requests(click(button("button.place_on_body")), UiAction::PlaceOnBody));
  EXPECT_TRUE(requests(click(button("button.dress_placed")), UiAction::Dress));
}

}  // namespace
}  // namespace drape::ui
