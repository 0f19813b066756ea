// The panels in another language: every text that they show has a translation, and nothing but the texts changes.
#include "panel_fixture.hpp"

#include "fabrics/presets.hpp"
#include "locale/language.hpp"
#include "settings/surface_fields.hpp"
#include "sim/fields/field_table.hpp"
#include "ui/search.hpp"
#include "ui/undo.hpp"

#include <algorithm>
#include <set>

namespace drape::ui {
namespace {

std::string listed(const std::set<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) {
    list += "\n  " + text;
  }
  return list;
}

/// All names, but for the line that a longer message takes.
std::set<std::string> namesOf(const UiRects& rects) {
  std::set<std::string> names;
  for (const auto& [name, rect] : rects) {
    names.insert(name);
  }
  names.erase("overlay.status");
  return names;
}

/// A mesh whose shape does not show what is up.
scene::FoundMesh foundOf(const Vec3& extent) {
  return {.format = {}, .extent = extent, .upOfShape = "", .pieces = 1, .vertices = 9, .triangles = 8};
}

/// The panels of a scene in German, which note the texts without a translation.
class GermanPanels : public PanelFixture, public ::testing::WithParamInterface<const char*> {
 protected:
  GermanPanels() : PanelFixture(GetParam()) {
    locale::Language german = *locale::findLanguage("de");
    german.texts.reportMissing(&missing_);
    panels_.useLanguage(german);
  }

  void expectComplete(const char* what) {
    settle();
    EXPECT_TRUE(missing_.empty()) << what << " without a translation:" << listed(missing_);
    missing_.clear();
  }

  void set(const std::string& key, const settings::SettingValue& value) {
    simulation_.apply(session::SetSettingCommand{key, value});
    panels_.openSections(true);
  }

  /// A step of a garment would take long here, and shows nothing more.
  void stepIfSmall() {
    constexpr int manyVertices = 2000;
    if (simulation_.model().vertexCount() < manyVertices) {
      simulation_.step();
    }
  }

  std::set<std::string> missing_;
};

TEST_P(GermanPanels, TranslateAllSections) {
  panels_.openSections(true);
  expectComplete("texts of the sections");
  for (const char* solver : {"xpbd", "one_iteration", "pcg"}) {
    set("solver", std::string(solver));
    set("ghost.solver", std::string(solver));
    stepIfSmall();
    expectComplete("texts with another solver");
  }
  set("solver", std::string("auto"));
  set("energy_balance", true);
  set("self_collision", std::string("exact"));
  set("view.colour_map", std::string("ghost_error"));
  stepIfSmall();
  expectComplete("texts with more rows");
}

TEST_P(GermanPanels, TranslateBoxesAndQuestions) {
  stats_.error = "Stopped. The scene did not change";
  stats_.loading = text::Sentence("Opening '{}'", "coat.obj");
  stats_.dressing = DressingProgress{text::Sentence("growing the body"), 0.5};
  stats_.exporting = ExportProgress{"film.mp4", 0.5, 3.0};
  stats_.recentFiles = {"/tmp/coat.obj"};
  stats_.selection.mode = SelectionMode::Border;
  expectComplete("boxes");
  panels_.showHelp(true);
  expectComplete("the help");
  panels_.showHelp(false);
  panels_.toggleSearch({"/tmp/coat.obj"});
  expectComplete("the search");
  panels_.toggleSearch({});
  panels_.askWhichIsTheCloth(
      {.scenes = {"a.toml"}, .meshes = {"coat.obj", "body.obj"}, .others = {}, .alone = "coat.obj"});
  expectComplete("the question about dropped files");
  std::vector<FoundFile> found{{"coat.obj", foundOf({0.8, 0.6, 0.0}), {}},
                               {"body.obj", foundOf({50.0, 170.0, 30.0}), {}}};
  stats_.found = found;
  expectComplete("what dropped files contain");
  found[0].mesh->pieces = 3;
  found[0].mesh->format = {1.0, 'y'};
  found[1].mesh = foundOf({9000.0, 9000.0, 9000.0});
  expectComplete("what other dropped files contain");
  stats_.found = {};
  panels_.forgetQuestions();
  stats_.placing.emplace().reading = scene::ReadingChoice{"inch", "y"};
  expectComplete("the box of the mode Place");
  stats_.placing.reset();
  panels_.askToReplace("a.toml");
  expectComplete("the question about a file");
  panels_.forgetQuestions();
  panels_.askToQuit(true);
  expectComplete("the question before the end");
  panels_.askToQuit(false);
  expectComplete("the question before the end of an export");
  stats_.exporting.reset();
  expectComplete("the question when the export has ended");
}

TEST_P(GermanPanels, KeepTheNamesOfAllRectangles) {
  panels_.openSections(true);
  settle();
  const std::set<std::string> widgets = namesOf(panels_.widgets());
  const std::set<std::string> buttons = namesOf(panels_.buttons());
  EXPECT_TRUE(buttons.contains("section.air"));
  panels_.useLanguage(locale::languages().front());
  settle();
  EXPECT_EQ(namesOf(panels_.widgets()), widgets);
  EXPECT_EQ(namesOf(panels_.buttons()), buttons);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GermanPanels,
                         ::testing::Values("grid", "flag", "mannequin", "walk", "table_runner", "fold"));

class Languages : public PanelFixture {
 protected:
  const locale::Language& german() { return *locale::findLanguage("de"); }
};

TEST_F(Languages, AreChosenInTheSectionView) {
  const UiOutput output = click(button("language=de"));
  ASSERT_EQ(output.requests.size(), 1U);
  const auto* request = std::get_if<LanguageRequest>(&output.requests.front());
  ASSERT_NE(request, nullptr);
  EXPECT_EQ(request->name, "de");
  panels_.useLanguage(german());
  EXPECT_EQ(panels_.language().name, "de");
  EXPECT_TRUE(click(button("language=de")).requests.empty()) << "it is that already";
}

TEST_F(Languages, ChangeTheStatusLineAtOnce) {
  EXPECT_NE(panels_.status().find("paused"), std::string::npos) << panels_.status();
  panels_.useLanguage(german());
  frame();
  EXPECT_NE(panels_.status().find("angehalten"), std::string::npos) << panels_.status();
  EXPECT_NE(panels_.status().find(" Knoten"), std::string::npos) << panels_.status();
  panels_.useLanguage(locale::languages().front());
  frame();
  EXPECT_NE(panels_.status().find("paused"), std::string::npos) << panels_.status();
}

TEST_F(Languages, KeepOpenSectionsAndRememberThemByTheirEnglishTitle) {
  const UiRect rowBefore = widget("drag");
  panels_.useLanguage(german());
  settle();
  EXPECT_TRUE(panels_.widgets().contains("drag")) << "the section is still open";
  EXPECT_EQ(widget("drag").height, rowBefore.height);
  click(button("section.air"));
  settle();
  EXPECT_FALSE(panels_.widgets().contains("drag"));
  EXPECT_EQ(panels_.sections(), (std::map<std::string, bool>{{"Air", false}}));
  panels_.useLanguage(locale::languages().front());
  settle();
  EXPECT_FALSE(panels_.widgets().contains("drag")) << "and still closed in English";
}

TEST_F(Languages, ATextOfTheUserStaysAsItIs) {
  panels_.useLanguage(locale::parseLanguage("title = \"X\"\n[texts]\n\"Play\" = \"Go\"\n", "xx", "xx.toml"));
  EXPECT_EQ(panels_.language().texts("Play"), "Go");
  EXPECT_EQ(panels_.language().texts("Pause"), "Pause");
  settle();
  EXPECT_TRUE(panels_.buttons().contains("button.play"));
}

/// What the tables of the program show, besides the sections: the choices of lists, and explanations.
std::vector<std::string> textsOfTables() {
  std::vector<std::string> texts;
  const auto add = [&](std::string_view text) { texts.emplace_back(text); };
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    add(info.title);
    add(info.help);
    if (const auto* choice = std::get_if<settings::ChoiceField>(&info.field)) {
      for (const std::string& word : choice->choices()) {
        add(settings::choiceTitle(*choice, word));
        const bool isSolver = sim::findSolver(word) != nullptr;  // its help is below
        add(choice->label == nullptr || isSolver ? std::string_view() : choice->label(word).help);
      }
      add(choice->otherTexts);
    }
  }
  for (const settings::SurfaceField& field : settings::surfaceFields()) {
    add(field.title);
    add(field.help);
  }
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    add(solver.title);
    add(solver.help);
  }
  for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
    add(field.title);
    add(field.help);
  }
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    add(preset.title);
    add(preset.source);
  }
  for (const figure::Motion& motion : figure::motions()) {
    add(motion.title);
  }
  for (const ExportFormat& format : exportFormats()) {
    add(format.title);
  }
  for (const ThemeInfo& theme : themes()) {
    add(theme.title);
  }
  for (const Shortcut& shortcut : shortcuts()) {
    add(shortcut.help);
  }
  for (const scene::SceneInfo& scene : scene::sceneList()) {
    add(scene.title);
    add(scene.help);
  }
  return texts;
}

TEST(Translations, CoverAllTables) {
  ASSERT_GT(textsOfTables().size(), 300U);
  for (const locale::Language& language : locale::languages()) {
    std::set<std::string> missing;
    text::Catalogue texts = language.texts;
    texts.reportMissing(&missing);
    for (const std::string& text : textsOfTables()) {
      static_cast<void>(texts(text));
    }
    EXPECT_TRUE(missing.empty()) << language.name << " has no entry for:" << listed(missing);
  }
}

TEST(Translations, KeepSettingsApart) {
  for (const locale::Language& language : locale::languages()) {
    std::set<std::string> titles;
    for (const settings::SettingInfo& info : settings::settingsTable()) {
      const std::string group = std::to_string(static_cast<int>(info.group));
      EXPECT_TRUE(titles.insert(group + language.texts(info.title)).second) << language.name << ": " << info.key;
    }
  }
}

TEST(Translations, OfAChangeHaveTheirOwnOrder) {
  const text::Sentence change("{} {} to {}", text::Sentence("Stiffness"), "150", "300");
  EXPECT_EQ(change, "Stiffness 150 to 300");
  EXPECT_EQ(locale::findLanguage("de")->texts(change), "Steifigkeit von 150 auf 300");
}

/// The keys of the entries that a text finds in German, the best first.
std::vector<std::string> found(const char* text) {
  const std::vector<SearchEntry> entries = searchEntries(scene::sceneList(), {}, locale::findLanguage("de")->texts);
  std::vector<std::string> keys;
  for (const std::size_t i : findEntries(entries, text)) {
    keys.push_back(entries[i].key);
  }
  return keys;
}

TEST(GermanSearch, FindsGermanAndEnglishWords) {
  EXPECT_EQ(found("zeitschritt").front(), "time_step");
  EXPECT_EQ(found("time step").front(), "time_step");
  EXPECT_EQ(found("steifigkeit").front(), "stiffness");
  EXPECT_EQ(found("stiffness").front(), "stiffness");
  EXPECT_EQ(found("fahne wind").front(), "flag");
  EXPECT_EQ(found("dämpfung").front(), "damping");
  EXPECT_EQ(found("DÄMPFUNG").front(), "damping") << "capital letters beyond ASCII";
  EXPECT_EQ(found("wind.z").front(), "wind.z");
  EXPECT_TRUE(found("xyzzy").empty());
}

TEST(GermanSearch, BeginsCommandsWithACapitalLetter) {
  const std::vector<SearchEntry> entries = searchEntries({}, {}, locale::findLanguage("de")->texts);
  const auto hasTitle = [&](const char* title) {
    return std::ranges::any_of(entries, [&](const SearchEntry& entry) { return entry.title == title; });
  };
  EXPECT_TRUE(hasTitle("Eine Datei öffnen"));
  EXPECT_TRUE(hasTitle("Alles zurück: Einstellungen, Fixierungen und Körper der Szene"));
}

}  // namespace
}  // namespace drape::ui
