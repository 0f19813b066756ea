#include "app/command_line.hpp"
#include "app/fabric_json.hpp"
#include "app/headless/commands.hpp"
#include "app/output_file.hpp"
#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "report/hardcases/hard_case_rows.hpp"
#include "report/validation/validation_rows.hpp"
#include "scene/scene.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/solver.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const settings::SettingValue& value) {
  return std::visit([](const auto& each) { return Json(each); }, value);
}

void addRange(const settings::SettingField& field, Json& json) {
  if (const auto* number = std::get_if<settings::NumberField>(&field)) {
    json["type"] = "number";
    json["min"] = number->min;
    json["max"] = number->max;
  } else if (const auto* integer = std::get_if<settings::IntegerField>(&field)) {
    json["type"] = "integer";
    json["min"] = integer->min;
    json["max"] = integer->max;
  } else if (const auto* choice = std::get_if<settings::ChoiceField>(&field)) {
    json["type"] = "choice";
    json["choices"] = choice->choices();
  } else {
    json["type"] = "flag";
  }
}

Json settingsAsJson() {
  Json list = Json::array();
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    Json row{{"key", info.key}, {"title", info.title}, {"unit", info.unit}};
    addRange(info.field, row);
    row["range"] = settings::describeRange(info).english();
    row["default"] = toJson(settings::defaultValue(info));
    row["help"] = info.help;
    list.push_back(row);
  }
  return list;
}

Json scenesAsJson() {
  Json list = Json::array();
  for (const scene::SceneInfo& info : scene::sceneList()) {
    list.push_back({{"name", info.name}, {"title", info.title}, {"help", info.help}});
  }
  return list;
}

Json fabricAsJson(const settings::OwnFabric& fabric, std::string_view title, bool own) {
  Json row = app::toJson(fabric);
  row["title"] = title;
  row["own"] = own;
  return row;
}

/// The built-in fabrics, then the user's.
Json fabricsAsJson(const settings::OwnFabrics& own) {
  Json list = Json::array();
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    Json row = fabricAsJson({std::string(preset.name), {}, std::string(preset.source), preset.density, preset.material},
                            preset.title, false);
    row["thickness"] = preset.thickness;
    row["self_static_friction"] = preset.friction.selfStatic;
    row["self_friction"] = preset.friction.selfKinetic;
    row["skin_friction"] = preset.friction.skin;
    if (preset.drape) {
      row["drape_coefficient"] = {{"lower", preset.drape->lower},
                                  {"upper", preset.drape->upper},
                                  {"source", std::string(preset.drape->source)}};
    }
    list.push_back(std::move(row));
  }
  for (const settings::OwnFabric& fabric : own ? *own : std::vector<settings::OwnFabric>()) {
    list.push_back(fabricAsJson(fabric, fabric.name, true));
  }
  return list;
}

/// A value for the eye: moduli that follow from a thickness have many digits. The JSON form has them all.
std::string rounded(const Json& value) {
  return fmt::format("{:.4g}", value.get<double>());
}

void printFabrics(const Json& list) {
  for (const Json& row : list) {
    const std::string based = row["based_on"].get<std::string>();
    const bool own = row["own"].get<bool>();
    std::cout << row["name"].get<std::string>() << "   "
              << (own ? "Your own" + (based.empty() ? "" : ", based on " + based) : row["title"].get<std::string>())
              << '\n';
    for (const std::string_view key : settings::fabricValueKeys()) {
      const settings::SettingInfo& info = settings::requireSetting(key);
      std::cout << "    " << key << " = " << rounded(row[std::string(key)])
                << (info.unit == "-" ? "" : " " + std::string(info.unit)) << '\n';
    }
    if (row.contains("thickness")) {
      std::cout << "    thickness = " << rounded(row["thickness"]) << " m\n";
    }
    for (const char* key : {"self_static_friction", "self_friction", "skin_friction"}) {
      if (row.contains(key)) {
        std::cout << "    " << key << " = " << rounded(row[key]) << '\n';
      }
    }
    if (row.contains("drape_coefficient")) {
      const Json& range = row["drape_coefficient"];
      std::cout << "    drape coefficient = " << rounded(range["lower"]) << " to " << rounded(range["upper"]) << " % ("
                << range["source"].get<std::string>() << ")\n";
    }
    if (const std::string source = row["source"].get<std::string>(); !source.empty()) {
      std::cout << "    Source: " << source << '\n';
    }
  }
}

Json hardCasesAsJson() {
  Json list = Json::array();
  for (const report::hardcases::HardCase& one : report::hardcases::hardCaseTable()) {
    list.push_back({{"number", one.number}, {"name", one.name}, {"title", one.statement}, {"help", one.rule}});
  }
  return list;
}

Json validationAsJson() {
  Json list = Json::array();
  for (const report::validation::ValidationCase& one : report::validation::validationTable()) {
    list.push_back({{"name", one.name},
                    {"title", one.title},
                    {"help", one.compared},
                    {"group", nameOf(one.group)},
                    {"unit", one.unit},
                    {"aim", one.aim}});
  }
  return list;
}

Json solversAsJson() {
  Json list = Json::array();
  for (const sim::SolverInfo& info : sim::solverTable()) {
    list.push_back({{"name", info.name},
                    {"title", info.title},
                    {"help", info.help},
                    {"source", info.source},
                    {"backward_euler", info.backwardEuler},
                    {"takes_fabric", info.takesFabric},
                    {"settings", info.settings}});
  }
  return list;
}

void printSettings() {
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    std::cout << info.key << " = " << settings::formatValue(settings::defaultValue(info));
    if (info.unit != "-") {
      std::cout << ' ' << info.unit;
    }
    std::cout << "   (" << settings::describeRange(info) << ")\n    " << info.help << '\n';
  }
}

/// The Markdown table of docs/guide/settings.md.
void printSettingsMarkdown() {
  std::cout << "| key | unit | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    std::cout << "| `" << info.key << "` | " << info.unit << " | " << settings::describeRange(info) << " | `"
              << settings::formatValue(settings::defaultValue(info)) << "` | " << info.help << " |\n";
  }
}

void printNamed(const Json& list) {
  for (const auto& row : list) {
    std::cout << row["name"].get<std::string>() << "   " << row["title"].get<std::string>() << "\n    "
              << row["help"].get<std::string>() << '\n';
    if (row.contains("takes_fabric")) {
      std::cout << "    Material: " << (row["takes_fabric"].get<bool>() ? "springs or fabric.\n" : "springs only.\n");
    }
  }
}

struct ListArguments {
  std::string what;
  std::string fabrics;  // the file of the user's fabrics
  bool json = false;
  bool markdown = false;
};

/// One list, by the word on the command line.
struct Listing {
  std::string_view what;
  Json (*json)();
  void (*markdown)();  ///< null: there is none
};

constexpr std::array listings{
    Listing{"scenes", scenesAsJson, nullptr}, Listing{"settings", settingsAsJson, printSettingsMarkdown},
    Listing{"solvers", solversAsJson, nullptr},
    Listing{"hardcases", hardCasesAsJson, [] { std::cout << report::hardcases::hardCaseListMarkdown(); }},
    Listing{"validation", validationAsJson, [] { std::cout << report::validation::validationListMarkdown(); }}};

constexpr std::string_view fabricsWord = "fabrics";

void listFabrics(const ListArguments& arguments) {
  if (arguments.markdown) {
    throw messages::UsageError("list fabrics has no --markdown");
  }
  const Json fabrics = fabricsAsJson(readFabricList(arguments.fabrics).fabrics());
  if (arguments.json) {
    std::cout << jsonText(fabrics, 2) << '\n';
  } else {
    printFabrics(fabrics);
  }
}

void list(const ListArguments& arguments) {
  if (arguments.what == fabricsWord) {
    listFabrics(arguments);
    return;
  }
  if (!arguments.fabrics.empty()) {
    throw messages::UsageError("--fabrics belongs to 'list fabrics', not to 'list " + arguments.what + "'");
  }
  const Listing& listing =
      *std::find_if(listings.begin(), listings.end(), [&](const Listing& one) { return one.what == arguments.what; });
  if (arguments.json) {
    std::cout << jsonText(listing.json(), 2) << '\n';
  } else if (arguments.markdown) {
    if (listing.markdown == nullptr) {
      throw messages::UsageError("list " + arguments.what + " has no --markdown");
    }
    listing.markdown();
  } else if (listing.what == "settings") {
    printSettings();
  } else {
    printNamed(listing.json());
  }
}

std::vector<std::string> listable() {
  std::vector<std::string> words{std::string(fabricsWord)};
  std::transform(listings.begin(), listings.end(), std::back_inserter(words),
                 [](const Listing& one) { return std::string(one.what); });
  return words;
}

}  // namespace

void addListCommand(CLI::App& app) {
  auto arguments = std::make_shared<ListArguments>();
  CLI::App* command =
      app.add_subcommand("list", "Lists scenes, settings, solvers, fabrics, hard cases or validation cases");
  command->add_option("what", arguments->what, "What to list")->required()->check(CLI::IsMember(listable()));
  auto* json = command->add_flag("--json", arguments->json, "As JSON");
  command->add_flag("--markdown", arguments->markdown, "Settings, hard cases or validation cases as a Markdown table")
      ->excludes(json);
  addFabricsOption(*command, arguments->fabrics);
  command->callback([arguments] { list(*arguments); });
}

}  // namespace drape::app
