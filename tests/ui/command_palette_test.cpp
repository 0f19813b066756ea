#include "panel_fixture.hpp"

#include <imgui.h>

namespace drape::ui {
namespace {

/// The panels with the search open.
class Palette : public PanelFixture {
 protected:
  Palette() {
    panels_.openSections(false);
    settle();
    panels_.toggleSearch({"/home/me/shirt.obj"});
    settle();
  }
  UiOutput type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    UiOutput all = frame();
    append(all, frame());
    return all;
  }
  UiOutput press(ImGuiKey_ key) {
    ImGuiIO& io = ImGui::GetIO();
    const int code = 100 + static_cast<int>(key);
    io.KeyMap[key] = code;
    io.KeysDown[code] = true;
    UiOutput all = frame();
    io.KeysDown[code] = false;
    append(all, frame());
    return all;
  }
  bool isOpen() { return panels_.buttons().contains("overlay.search"); }
};

TEST_F(Palette, TakesTextAtOnceAndReturnRunsACommand) {
  EXPECT_TRUE(panels_.takesText());
  type("wireframe");
  const UiOutput output = press(ImGuiKey_Enter);
  EXPECT_EQ(std::get<bool>(lastValue(output, "view.wireframe")), true);
  settle();
  EXPECT_FALSE(isOpen());
}

TEST_F(Palette, ShowsASettingInItsSection) {
  type("wind z");
  press(ImGuiKey_Enter);
  settle();
  EXPECT_FALSE(isOpen());
  ASSERT_TRUE(panels_.widgets().contains("wind.z")) << "the section Air is open";
  EXPECT_TRUE(widget("wind.z").visible);
  EXPECT_FALSE(panels_.widgets().contains("grid.width")) << "the others stay closed";
}

TEST_F(Palette, UnfoldsTheValuesOfAFabric) {
  apply(press(ImGuiKey_Escape));
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  simulation_.apply(session::SetSettingCommand{"material.model", std::string("fabric")});
  settle();
  panels_.toggleSearch({});
  settle();
  type("fabric.shear");
  press(ImGuiKey_Enter);
  settle();
  ASSERT_TRUE(panels_.widgets().contains("fabric.shear"));
  EXPECT_TRUE(widget("fabric.shear").visible);
}

TEST_F(Palette, SaysWhenASettingHasNoEffectHere) {
  type("fabric.shear");
  EXPECT_NE(press(ImGuiKey_Enter).hint.english().find("no effect"), std::string::npos);
}

TEST_F(Palette, OpensAScene) {
  type("flag_on_pole");
  const UiOutput output = press(ImGuiKey_Enter);
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<OpenSceneRequest>(output.requests.front()).nameOrPath, "flag_on_pole");
}

TEST_F(Palette, OpensARecentFile) {
  type("shirt.obj");
  const UiOutput output = press(ImGuiKey_Enter);
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<OpenSceneRequest>(output.requests.front()).nameOrPath, "/home/me/shirt.obj");
}

TEST_F(Palette, ArrowsChooseAnotherEntry) {
  type("look from the");
  press(ImGuiKey_DownArrow);
  const UiOutput output = press(ImGuiKey_Enter);
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::ViewFront) << "after the shortest title";
}

TEST_F(Palette, AClickTakesAnEntry) {
  type("look from the");
  settle();
  const UiOutput output = click(button("search.7"), 0.3);
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::ViewTop);
}

TEST_F(Palette, EscapeAndAClickBesideCloseIt) {
  press(ImGuiKey_Escape);
  settle();
  EXPECT_FALSE(isOpen());
  panels_.toggleSearch({});
  settle();
  ASSERT_TRUE(isOpen());
  click({1200.0, 20.0, 2.0, 2.0});
  settle();
  EXPECT_FALSE(isOpen());
}

TEST_F(Palette, ReturnTakesNothingWhereNothingFits) {
  type("xqzxqz");
  const UiOutput output = press(ImGuiKey_Enter);
  EXPECT_TRUE(output.requests.empty());
  EXPECT_TRUE(output.commands.empty());
}

}  // namespace
}  // namespace drape::ui
