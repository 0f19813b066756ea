// The labels of rows can be read in full at the usual width of the panel.
#include "panel_fixture.hpp"

#include "locale/language.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/solver.hpp"

#include <imgui.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace drape::ui {
namespace {

/// A language and a scene.
using Case = std::tuple<const char*, const char*>;

class RowLabels : public PanelFixture, public ::testing::WithParamInterface<Case> {
 protected:
  RowLabels() : PanelFixture(std::get<1>(GetParam())) {
    panels_.useLanguage(language());
    settle();
  }

  static const locale::Language& language() { return *locale::findLanguage(std::get<0>(GetParam())); }

  static double widthOf(const std::string& text) {
    const ImFont* font = ImGui::GetIO().FontDefault;
    const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
    return font->CalcTextSizeA(size, 1e6F, 0.0F, text.c_str()).x;
  }

  /// Every label is within the panel and has all of its words unbroken, and every setting has its whole title.
  void expectReadable() {
    panels_.openSections(true);
    settle();
    EXPECT_FALSE(panels_.labels().empty());
    for (const auto& [text, rect] : panels_.labels()) {
      EXPECT_LE(rect.x + rect.width, panels_.view().x) << text;
      std::istringstream words(text);
      for (std::string word; words >> word;) {
        EXPECT_GE(rect.width + 1.0, widthOf(word)) << "'" << word << "' of '" << text << "' is broken";
      }
    }
    for (const settings::SettingInfo& info : settings::settingsTable()) {
      const auto widget = panels_.widgets().find(std::string(info.key));
      if (widget == panels_.widgets().end()) {
        continue;
      }
      seen_.insert(std::string(info.key));
      const auto label = panels_.labels().find(language().texts(info.title));
      ASSERT_NE(label, panels_.labels().end()) << info.key << " has no whole title";
      const bool isBeside = label->second.x + label->second.width <= widget->second.x;
      const bool isAbove = label->second.y + label->second.height <= widget->second.y;
      EXPECT_TRUE(isBeside || isAbove) << info.key << " covers its title";
    }
  }

  void expectReadableWith(const char* key, const settings::SettingValue& value) {
    simulation_.apply(session::SetSettingCommand{key, value});
    expectReadable();
  }

  std::set<std::string> seen_;  ///< the settings that had a row
};

TEST_P(RowLabels, AreNotCut) {
  expectReadable();
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    expectReadableWith("solver", std::string(solver.name));
  }
  expectReadableWith("ghost.solver", std::string("newton"));
  expectReadableWith("view.colour_map", std::string("speed"));
  expectReadableWith("view.colour_range", std::string("fixed"));
  for (const char* flag : {"self_collision", "energy_balance", "ghost", "view.shadows"}) {
    const settings::SettingInfo* info = settings::findSetting(flag);
    if (info != nullptr && std::holds_alternative<settings::FlagField>(info->field)) {
      expectReadableWith(flag, true);
    }
  }
  constexpr std::size_t manyRows = 60;  // some settings exclude each other
  EXPECT_GT(seen_.size(), manyRows);
}

INSTANTIATE_TEST_SUITE_P(All, RowLabels,
                         ::testing::Combine(::testing::Values("en", "de"), ::testing::Values("grid", "skirt", "walk")),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
                         });

}  // namespace
}  // namespace drape::ui
