#include "ui/setting_widget.hpp"

#include "messages/error.hpp"
#include "panel_fixture.hpp"
#include "sim/solvers/solver.hpp"
#include "ui/number_slider.hpp"

#include <imgui.h>

#include <algorithm>
#include <set>

namespace drape::ui {
namespace {

class SettingWidget : public PanelFixture {
 protected:
  explicit SettingWidget(const char* scene = "grid") : PanelFixture(scene) {}

  [[nodiscard]] std::set<std::string> drawnKeys() const {
    std::set<std::string> keys;
    for (const auto& [key, rect] : panels_.widgets()) {
      keys.insert(key);
    }
    return keys;
  }
};

TEST_F(SettingWidget, DrawsExactlyTheSettingsThatApply) {
  for (const char* massGivenAs : {"density", "mass"}) {
    simulation_.apply(session::SetSettingCommand{"mass_given_as", std::string(massGivenAs)});
    settle();
    std::set<std::string> expected;
    for (const settings::SettingInfo& info : settings::settingsTable()) {
      if (settingApplies(info, simulation_.settings(), simulation_.scene())) {
        expected.insert(std::string(info.key));
      }
    }
    EXPECT_EQ(drawnKeys(), expected);
    EXPECT_EQ(expected.contains("density"), std::string(massGivenAs) == "density");
    EXPECT_EQ(expected.contains("mass"), std::string(massGivenAs) == "mass");
  }
}

TEST_F(SettingWidget, EverySettingOfTheTableAppliesSomewhere) {
  scene::Scene meshScene = simulation_.scene();
  meshScene.description.cloth().source = scene::MeshFileSource{"shirt.obj", false};
  const auto applies = [&](const settings::SettingInfo& info, const sim::SolverInfo& solver, const char* integration) {
    settings::Settings settings;
    settings.solver.name = solver.name;
    settings::assignSetting(settings, settings::requireSetting("integration"), std::string(integration));
    settings.ghost.solver = solver.name;
    settings.step.contact.self = sim::contact::SelfCollision::Hash;
    settings.view.colourMap = "speed";
    settings.view.colourRange = "fixed";
    settings::Settings byMass = settings;
    byMass.material.massGivenAs = "mass";
    settings::Settings fabric = settings;
    fabric.material.model = "fabric";
    settings::Settings pattern = fabric;
    pattern.fabric.restShape = "uv";
    return settingApplies(info, fabric, meshScene) || settingApplies(info, pattern, meshScene) ||
           settingApplies(info, settings, simulation_.scene()) || settingApplies(info, settings, meshScene) ||
           settingApplies(info, byMass, meshScene);
  };
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    const auto table = sim::solverTable();
    EXPECT_TRUE(std::any_of(table.begin(), table.end(), [&](const sim::SolverInfo& solver) {
      return applies(info, solver, "backward_euler") || applies(info, solver, "theta");
    })) << info.key;
  }
}

TEST_F(SettingWidget, ShowsTheSettingsOfSpringsOrThoseOfTheFabric) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  EXPECT_TRUE(drawnKeys().contains("stiffness"));
  EXPECT_TRUE(drawnKeys().contains("material.model"));
  EXPECT_FALSE(drawnKeys().contains("material.preset"));
  EXPECT_FALSE(drawnKeys().contains("fabric.shear"));
  apply(click(button("material.model=fabric")));
  settle();
  EXPECT_FALSE(drawnKeys().contains("stiffness"));
  EXPECT_TRUE(drawnKeys().contains("material.preset"));
  EXPECT_FALSE(drawnKeys().contains("fabric.shear")) << "the moduli are folded at first";
  click(button("fold.moduli"));
  settle();
  EXPECT_TRUE(drawnKeys().contains("fabric.shear"));
  EXPECT_TRUE(drawnKeys().contains("mass")) << "the scene gives the mass";
  EXPECT_FALSE(drawnKeys().contains("fabric.density"));
  apply(click(widget("fabric.own_density"), 0.05));
  settle();
  EXPECT_TRUE(simulation_.settings().fabric.ownDensity);
  EXPECT_TRUE(drawnKeys().contains("fabric.density"));
  EXPECT_FALSE(drawnKeys().contains("mass"));
  EXPECT_FALSE(drawnKeys().contains("mass_given_as"));
}

TEST_F(SettingWidget, ChoosingAFabricSetsItsValuesAndChangingOneIsNamed) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  simulation_.apply(session::SetSettingCommand{"material.model", std::string("fabric")});
  settle();
  click(widget("material.preset"));
  settle();
  apply(click(button("material.preset=denim")));
  settle();
  EXPECT_EQ(simulation_.settings().fabric.moduli.stretchWeft, 1014.0);
  click(button("fold.moduli"));
  settle();
  apply(typeInto(widget("fabric.shear"), "60"));
  EXPECT_EQ(simulation_.settings().fabric.moduli.shear, 60.0);
  EXPECT_EQ(settings::settingValue(simulation_.settings(), settings::requireSetting("material.preset")),
            settings::SettingValue(std::string("denim, changed")));
}

class FabricPanel : public SettingWidget {
 protected:
  FabricPanel() {
    simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
    simulation_.apply(session::SetSettingCommand{"material.model", std::string("fabric")});
    simulation_.apply(session::SetSettingCommand{"material.preset", std::string("denim")});
    simulation_.apply(session::SetSettingCommand{"fabric.shear", 60.0});
    settle();
  }

  /// Types a name and presses the button that saves.
  UiOutput saveAs(const std::string& name) {
    click(button("fabric.name"));
    ImGui::GetIO().AddInputCharactersUTF8(name.c_str());
    frame();
    settle();
    return click(button("button.save_fabric"));
  }
};

TEST_F(FabricPanel, SavesTheFabricUnderTheNameThatIsTyped) {
  const UiOutput output = saveAs("My denim");
  ASSERT_EQ(output.requests.size(), 1U);
  const auto& request = std::get<SaveFabricRequest>(output.requests.front());
  EXPECT_EQ(request.fabric.name, "My denim");
  EXPECT_EQ(request.fabric.basedOn, "denim");
  EXPECT_EQ(request.fabric.material.shear, 60.0);
  EXPECT_EQ(request.place, SaveFabricRequest::Place::List);
  EXPECT_FALSE(panels_.buttons().contains("button.save_fabric_in_scene")) << "a built-in scene has no file";
}

TEST_F(FabricPanel, RefusesABadNameAndSaysWhy) {
  for (const auto& [name, expected] : {std::pair("", "needs a name"), {"Silk", "belongs to the built-in fabric"}}) {
    const UiOutput output = saveAs(name);
    EXPECT_TRUE(output.requests.empty()) << name;
    EXPECT_NE(output.hint.english().find(expected), std::string::npos) << output.hint;
  }
}

TEST_F(FabricPanel, OffersOwnFabricsAmongThePresets) {
  settings::OwnFabric own = settings::fabricOf(simulation_.settings(), "My denim");
  own.density = 0.5;
  simulation_.apply(session::SetOwnFabricsCommand{settings::withOwnFabric({}, own)});
  settle();
  click(widget("material.preset"));
  settle();
  apply(click(button("material.preset=My denim")));
  settle();
  EXPECT_EQ(simulation_.settings().fabric.density, 0.5);
  EXPECT_EQ(settings::fabricTitle(simulation_.settings()), "My denim");
}

TEST_F(FabricPanel, RightClickOnThePresetRestoresAllValuesOfTheScene) {
  const UiOutput output = click(widget("material.preset"), 0.3, 1);
  apply(output);
  EXPECT_EQ(simulation_.settings().fabric.moduli, simulation_.scene().description.settings.fabric.moduli);
  EXPECT_EQ(settings::fabricTitle(simulation_.settings()), "Cotton");
}

TEST_F(SettingWidget, NoTwoWidgetsShareAPlace) {
  for (const auto& [key, rect] : panels_.widgets()) {
    for (const auto& [other, otherRect] : panels_.widgets()) {
      if (key != other) {
        EXPECT_FALSE(rect.contains({otherRect.x + otherRect.width / 2.0, otherRect.y + otherRect.height / 2.0}))
            << key << " and " << other;
      }
    }
  }
}

TEST_F(SettingWidget, WidgetsStayInsideTheColumn) {
  const double edge = panels_.view().x;
  for (const auto& [key, rect] : panels_.widgets()) {
    EXPECT_GE(rect.x, 0.0) << key;
    EXPECT_LE(rect.x + rect.width, edge) << key;
  }
}

TEST_F(SettingWidget, NoTitleIsCutShort) {
  // A label has two fifths of its row, the widget has the rest, with a small gap.
  const double labelWidth = widget("drag").width * 2.0 / 3.0 - 4.0;
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    EXPECT_LT(ImGui::CalcTextSize(std::string(info.title).c_str()).x, labelWidth) << info.key;
  }
}

TEST_F(SettingWidget, DraggingASliderSetsTheValueUnderTheMouse) {
  const UiOutput output = drag(widget("drag"), 0.1, 0.5);
  EXPECT_NEAR(std::get<double>(lastValue(output, "drag")), 5.0, 0.05);
  EXPECT_GE(output.commands.size(), 2U);
  EXPECT_TRUE(output.requests.empty());
}

TEST_F(SettingWidget, ASliderShowsWhatWasChosenUntilTheSimulationFollows) {
  const UiOutput output = drag(widget("drag"), 0.1, 0.5);
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0) << "the commands are not applied yet";
  // A right click acts only when the value differs from the scene's.
  const UiOutput reset = click(widget("drag"), 0.5, 1);
  EXPECT_EQ(std::get<double>(lastValue(reset, "drag")), 0.0);
}

TEST_F(SettingWidget, RightClickRestoresTheScenesValue) {
  const settings::SettingInfo& info = settings::requireSetting("solver");
  const settings::SettingValue own = settings::settingValue(simulation_.scene().description.settings, info);
  ASSERT_NE(own, settings::defaultValue(info)) << "the scene of this test names its solver";
  simulation_.apply(session::SetSettingCommand{"solver", std::string("verlet")});
  settle();
  EXPECT_EQ(lastValue(click(widget("solver"), 0.3, 1), "solver"), own);
}

TEST_F(SettingWidget, RightClickOnTheScenesValueSetsTheDefault) {
  const settings::SettingInfo& info = settings::requireSetting("solver");
  EXPECT_EQ(lastValue(click(widget("solver"), 0.3, 1), "solver"), settings::defaultValue(info));
  EXPECT_TRUE(click(widget("drag"), 0.3, 1).commands.empty()) << "the scene has the default";
}

TEST_F(SettingWidget, SweepsStayOdd) {
  for (const double place : {0.05, 0.2, 0.33, 0.47, 0.61, 0.78, 1.0}) {
    apply(drag(widget("sweeps"), 0.5, place));
    settle();
    EXPECT_EQ(simulation_.settings().step.jacobi.sweeps % 2, 1) << place;
    EXPECT_TRUE(simulation_.message().empty()) << simulation_.message();
  }
}

TEST_F(SettingWidget, TypedNumbersAreTakenAsOnTheCommandLine) {
  const UiOutput output = typeInto(widget("time_step"), "1/300");
  EXPECT_DOUBLE_EQ(std::get<double>(lastValue(output, "time_step")), 1.0 / 300.0);
}

TEST_F(SettingWidget, TypedNumbersBeyondTheSliderButInRangeAreTaken) {
  const UiOutput output = typeInto(widget("wind.x"), "-75");
  EXPECT_DOUBLE_EQ(std::get<double>(lastValue(output, "wind.x")), -75.0);
}

TEST_F(SettingWidget, TypedNumbersBeyondTheRangeAreClamped) {
  const UiOutput output = typeInto(widget("drag"), "1000");
  EXPECT_DOUBLE_EQ(std::get<double>(lastValue(output, "drag")), 10.0);
  EXPECT_EQ(output.hint, "1000 is not allowed here. The nearest allowed value is 10");
  EXPECT_TRUE(typeInto(widget("drag"), "3").hint.empty());
}

TEST_F(SettingWidget, TypedNonsenseChangesNothingAndSaysWhy) {
  const UiOutput output = typeInto(widget("drag"), "lots");
  EXPECT_TRUE(output.commands.empty());
  EXPECT_NE(output.hint.english().find("drag"), std::string::npos) << output.hint;
}

TEST_F(SettingWidget, CtrlClickAloneChangesNothing) {
  EXPECT_TRUE(typeInto(widget("drag"), "0").commands.empty());
}

TEST_F(SettingWidget, AFlagIsTickedByAClick) {
  const UiOutput output = click(widget("view.wireframe"), 0.5);
  EXPECT_EQ(std::get<bool>(lastValue(output, "view.wireframe")), true);
}

TEST_F(SettingWidget, AShortChoiceIsOneClick) {
  const UiOutput output = click(button("material.model=fabric"));
  EXPECT_EQ(std::get<std::string>(lastValue(output, "material.model")), "fabric");
}

TEST_F(SettingWidget, ALongChoiceIsPickedFromTheListByItsTitle) {
  click(widget("derivative"));
  settle();
  for (const char* word : {"stabilised", "exact", "scalar", "axial", "tension_only"}) {
    EXPECT_TRUE(panels_.buttons().contains(std::string("derivative=") + word)) << word;
  }
  const UiOutput output = click(button("derivative=scalar"));
  EXPECT_EQ(std::get<std::string>(lastValue(output, "derivative")), "scalar");
}

TEST_F(SettingWidget, TheLookOfTheClothIsPickedFromAList) {
  click(widget("view.surface"));
  settle();
  const UiOutput output = click(button("view.surface=fabric"));
  EXPECT_EQ(std::get<std::string>(lastValue(output, "view.surface")), "fabric");
}

TEST_F(SettingWidget, EverySolverIsInBothLists) {
  for (const std::string key : {"solver", "ghost.solver"}) {
    click(widget(key));
    settle();
    for (const sim::SolverInfo& solver : sim::solverTable()) {
      EXPECT_TRUE(panels_.buttons().contains(key + "=" + std::string(solver.name))) << key << solver.name;
    }
    panels_.closeOverlay();
    settle();
  }
}

TEST_F(SettingWidget, SolversAreShownOnlyTheirOwnSettings) {
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    simulation_.apply(session::SetSettingCommand{"solver", std::string(solver.name)});
    settle();
    const std::set<std::string> drawn = drawnKeys();
    for (const sim::SolverInfo& other : sim::solverTable()) {
      for (const std::string_view key : other.settings) {
        const bool own = std::find(solver.settings.begin(), solver.settings.end(), key) != solver.settings.end();
        EXPECT_EQ(drawn.contains(std::string(key)), own) << solver.name << ": " << key;
      }
    }
  }
}

TEST_F(SettingWidget, TheGhostsSettingsAppearWithTheGhost) {
  EXPECT_FALSE(drawnKeys().contains("ghost.substeps"));
  apply(click(widget("ghost.solver")));
  settle();
  apply(click(button("ghost.solver=one_iteration")));
  settle();
  EXPECT_EQ(simulation_.settings().ghost.solver, "one_iteration");
  EXPECT_TRUE(drawnKeys().contains("ghost.substeps"));
  EXPECT_TRUE(drawnKeys().contains("ghost.offset"));
}

TEST_F(SettingWidget, AMeshSettingIsSentWhenTheMouseLetsGo) {
  const UiRect rect = widget("grid.width");
  moveTo(rect, 0.2);
  settle();
  ImGui::GetIO().MouseDown[0] = true;
  EXPECT_TRUE(frame().requests.empty());
  moveTo(rect, 0.4);
  EXPECT_TRUE(frame().requests.empty());
  ImGui::GetIO().MouseDown[0] = false;
  UiOutput output = frame();
  append(output, frame());
  EXPECT_TRUE(output.commands.empty());
  ASSERT_EQ(output.requests.size(), 1U);
  const auto* request = std::get_if<RebuildSceneRequest>(&output.requests.front());
  ASSERT_NE(request, nullptr);
  EXPECT_NE(request->settings.grid.width, simulation_.settings().grid.width);
  EXPECT_EQ(request->settings.grid.height, simulation_.settings().grid.height);
}

TEST_F(SettingWidget, ASecondMeshSettingKeepsTheFirstOneThatIsStillBeingBuilt) {
  drag(widget("grid.width"), 0.2, 0.4);
  stats_.loading = "Building grid";
  const UiOutput output = drag(widget("grid.height"), 0.2, 0.6);
  ASSERT_EQ(output.requests.size(), 1U);
  const settings::Settings& asked = std::get<RebuildSceneRequest>(output.requests.front()).settings;
  EXPECT_NE(asked.grid.width, simulation_.settings().grid.width);
  EXPECT_NE(asked.grid.height, simulation_.settings().grid.height);
}

TEST(NumberFormat, CarriesTheUnit) {
  EXPECT_EQ(numberFormat("%.4g", "m/s"), "%.4g m/s");
  EXPECT_EQ(numberFormat("%.4g", "-"), "%.4g");
  EXPECT_EQ(numberFormat("%d", "%"), "%d %%");
  EXPECT_EQ(numberFormat("%.4g", "kg/m^2"), "%.4g kg/m\u00B2");
}

struct SubstepsOf {
  template <typename AnySettings>
  auto& operator()(AnySettings& settings) const {
    return settings.step.substeps;
  }
};

TEST(NearestAllowed, KeepsToRange) {
  const settings::IntegerField field{SubstepsOf(), 1, 99};
  EXPECT_EQ(nearestAllowed(field, -5.0), 1);
  EXPECT_EQ(nearestAllowed(field, 4.2), 4);
  EXPECT_EQ(nearestAllowed(field, 98.6), 99);
  EXPECT_EQ(nearestAllowed(field, 1e9), 99);
}

TEST(TypedValue, RefusesTextThatIsNoNumber) {
  const settings::SettingInfo& info = settings::requireSetting("drag");
  EXPECT_THROW(static_cast<void>(typedValue(info, settings::Settings(), "nan")), messages::UsageError);
  EXPECT_THROW(static_cast<void>(typedValue(info, settings::Settings(), "")), messages::UsageError);
  EXPECT_THROW(static_cast<void>(typedValue(info, settings::Settings(), "3 apples")), messages::UsageError);
  EXPECT_EQ(std::get<double>(typedValue(info, settings::Settings(), "-1")), 0.0);
}

}  // namespace
}  // namespace drape::ui
