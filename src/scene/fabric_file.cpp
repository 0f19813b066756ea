#include "scene/fabric_file.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "scene/text_file.hpp"
#include "scene/toml_reader.hpp"
#include "scene/toml_text.hpp"
#include "settings/settings_table.hpp"

#include <algorithm>

namespace drape::scene {
namespace {

constexpr std::string_view valuePrefix = "fabric.";

/// The key of a value in the file: "shear" for "fabric.shear".
std::string_view keyInFile(std::string_view settingKey) {
  return settingKey.substr(valuePrefix.size());
}

/// The built-in fabric that an own one is based on, or nullptr.
const fabrics::Preset* readBase(const TomlReader& table) {
  const std::string name = table.text("based_on").value_or("");
  const fabrics::Preset* base = fabrics::findPreset(name);
  if (base == nullptr && !name.empty()) {
    throw messages::UsageError("based_on must be a built-in fabric ('drape-headless list fabrics' lists them); '" +
                               name + "' is not");
  }
  return base;
}

/// The settings with the values of a table.
settings::Settings readValues(const TomlReader& table, const fabrics::Preset* base) {
  settings::Settings values;
  if (base != nullptr) {
    settings::assignSetting(values, settings::requireSetting("material.preset"), std::string(base->name));
  }
  const auto keys = settings::fabricValueKeys();
  table.forEachValue([&](const std::string& key, const toml::node& node) {
    const std::string full = std::string(valuePrefix) + key;
    if (std::find(keys.begin(), keys.end(), full) != keys.end()) {
      settings::assignSetting(values, settings::requireSetting(full), settingValueOf(node));
    }
  });
  const auto missing =
      std::find_if(keys.begin(), keys.end(), [&](std::string_view key) { return !table.has(keyInFile(key)); });
  if (base == nullptr && missing != keys.end()) {
    throw messages::UsageError(
        "the value " + std::string(keyInFile(*missing)) +
        " is missing. Add it, or name a built-in fabric in based_on, whose values fill the gaps");
  }
  settings::requireConsistent(values);
  return values;
}

settings::OwnFabric readFabric(const TomlReader& table) {
  std::vector<std::string_view> keys{"name", "based_on", "source"};
  for (const std::string_view key : settings::fabricValueKeys()) {
    keys.push_back(keyInFile(key));
  }
  const std::string name = table.text("name").value_or("");
  try {
    table.allowOnly(keys);
    if (const std::string problem = settings::problemWithFabricName(name); !problem.empty()) {
      throw messages::UsageError(problem);
    }
    const fabrics::Preset* base = readBase(table);
    settings::OwnFabric fabric = settings::fabricOf(readValues(table, base), name);
    fabric.basedOn = base == nullptr ? "" : base->name;
    fabric.source = table.text("source").value_or("");
    return fabric;
  } catch (const messages::UsageError& error) {
    table.fail("the fabric \"" + name + "\": " + error.what());
  }
}

/// A part of a text, from its first character up to `end`.
struct TextPart {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool opensTable(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '[';
}

/// The lines from `line` (1 is the first) up to the next line that opens a table, without the blank lines and comments
/// before it.
TextPart tableFrom(std::string_view text, std::size_t line) {
  TextPart part;
  for (std::size_t number = 1, begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view content = text.substr(begin, end - begin);
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (number == line) {
      part.begin = begin;
      part.end = end;
    } else if (number > line && opensTable(content)) {
      break;
    } else if (number > line && first != std::string_view::npos && content[first] != '#') {
      part.end = end;
    }
    begin = end;
  }
  return part;
}

/// The line of the table that has the fabric with that name; 0 if there is none.
std::size_t lineOfFabric(const TomlReader& document, std::string_view name) {
  for (const TomlReader& table : document.tables("fabrics")) {
    if (table.text("name") == name) {
      return table.line();
    }
  }
  return 0;
}

}  // namespace

std::string fabricEntry(const settings::OwnFabric& fabric) {
  settings::Settings values;
  settings::useFabric(values, fabric);
  std::string text = "[[fabrics]]\nname = " + quotedText(fabric.name) + '\n';
  if (!fabric.basedOn.empty()) {
    text += "based_on = " + quotedText(fabric.basedOn) + '\n';
  }
  if (!fabric.source.empty()) {
    text += "source = " + quotedText(fabric.source) + '\n';
  }
  for (const std::string_view key : settings::fabricValueKeys()) {
    const settings::SettingInfo& info = settings::requireSetting(key);
    text += std::string(keyInFile(key)) + " = " + settings::formatValue(settings::settingValue(values, info));
    text += info.unit == "-" ? "\n" : "  # " + std::string(info.unit) + '\n';
  }
  return text;
}

settings::OwnFabrics readFabrics(const TomlReader& document) {
  settings::OwnFabrics fabrics;
  for (const TomlReader& table : document.tables("fabrics")) {
    settings::OwnFabric fabric = readFabric(table);
    if (settings::findOwnFabric(fabrics, fabric.name) != nullptr) {
      table.fail("there are two fabrics with the name \"" + fabric.name + "\"; rename or remove one of them");
    }
    fabrics = settings::withOwnFabric(fabrics, std::move(fabric));
  }
  return fabrics;
}

settings::OwnFabrics parseFabrics(std::string_view text, const std::string& file) {
  const TomlReader document(text, file);
  document.allowOnly({"fabrics"});
  return readFabrics(document);
}

settings::OwnFabrics readFabricFile(const std::filesystem::path& file) {
  return parseFabrics(readTextFile(file), file.string());
}

std::string withFabricEntry(std::string_view text, const settings::OwnFabric& fabric, const std::string& file) {
  const TomlReader document(text, file);
  const settings::OwnFabrics expected = settings::withOwnFabric(readFabrics(document), fabric);
  const std::size_t line = lineOfFabric(document, fabric.name);
  std::string changed(text);
  if (line == 0) {
    const bool begins = changed.empty() || changed.ends_with("\n\n");
    changed += (begins ? "" : changed.ends_with('\n') ? "\n" : "\n\n") + fabricEntry(fabric);
  } else {
    const TextPart part = tableFrom(text, line);
    changed.replace(part.begin, part.end - part.begin, fabricEntry(fabric));
  }
  settings::OwnFabrics written;
  try {
    written = readFabrics(TomlReader(changed, file));
  } catch (const messages::InputError&) {
    written.reset();
  }
  if (!written || *written != *expected) {
    throw messages::InputError(file +
                               " writes its fabrics in a form that Drape cannot extend. Write each as a table "
                               "[[fabrics]] with one value a line, or choose another file");
  }
  return changed;
}

}  // namespace drape::scene
