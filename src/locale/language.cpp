#include "locale/language.hpp"

#include "locale/embedded_catalogues.hpp"
#include "messages/error.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

namespace drape::locale {
namespace {

constexpr std::string_view ending = ".toml";

/// Whether a translation names the same placeholders as its text, in any order.
bool fits(std::string_view english, std::string_view translation) {
  std::vector<std::size_t> wanted = text::placeholdersOf(english);
  std::vector<std::size_t> found = text::placeholdersOf(translation);
  std::ranges::sort(wanted);
  std::ranges::sort(found);
  return wanted == found;
}

[[noreturn]] void fail(const std::string& source, const toml::source_region& place, const std::string& problem) {
  throw messages::InputError(source + ":" + std::to_string(place.begin.line) + ": " + problem);
}

toml::table tableOf(std::string_view toml, const std::string& source) {
  try {
    return toml::parse(toml, source);
  } catch (const toml::parse_error& error) {
    fail(source, error.source(), "this is not valid TOML: " + std::string(error.description()));
  }
}

std::vector<Language> readLanguages() {
  std::vector<Language> list{{"en", "English", text::Catalogue()}};
  for (const EmbeddedFile& file : embeddedCatalogues()) {
    const std::string name(file.name);
    list.push_back(parseLanguage(file.bytes, name.substr(0, name.size() - ending.size()), name));
  }
  return list;
}

std::string listOfNames() {
  std::string list;
  for (const Language& language : languages()) {
    list += (list.empty() ? "" : ", ") + language.name + " (" + language.title + ")";
  }
  return list;
}

}  // namespace

std::span<const Language> languages() {
  static const std::vector<Language> list = readLanguages();
  return list;
}

const Language* findLanguage(std::string_view name) {
  const auto all = languages();
  const auto found = std::ranges::find(all, name, &Language::name);
  return found == all.end() ? nullptr : &*found;
}

Language openLanguage(const std::string& nameOrFile) {
  if (const Language* known = findLanguage(nameOrFile)) {
    return *known;
  }
  if (!nameOrFile.ends_with(ending)) {
    throw messages::UsageError("there is no language '" + nameOrFile + "'; the languages are " + listOfNames() +
                               ", and a catalogue file of your own ends in .toml");
  }
  std::ifstream file(nameOrFile, std::ios::binary);
  std::ostringstream bytes;
  if (!file || !(bytes << file.rdbuf())) {
    throw messages::InputError("cannot read the catalogue of texts " + nameOrFile +
                               "; check that the file exists and is readable");
  }
  return parseLanguage(bytes.str(), std::filesystem::path(nameOrFile).stem().string(), nameOrFile);
}

Language parseLanguage(std::string_view toml, const std::string& name, const std::string& source) {
  const toml::table table = tableOf(toml, source);
  const auto title = table["title"].value<std::string>();
  const toml::table* texts = table["texts"].as_table();
  if (!title || texts == nullptr) {
    fail(source, table.source(), "a catalogue of texts needs a title, such as \"Deutsch\", and a table [texts]");
  }
  text::Catalogue::Entries entries;
  for (const auto& [english, value] : *texts) {
    const auto translation = value.value<std::string>();
    const std::string key(english.str());
    if (!translation || translation->empty()) {
      fail(source, value.source(), "the translation of \"" + key + "\" is no text; write it in quotes");
    }
    if (!fits(key, *translation)) {
      fail(source, value.source(), "the translation of \"" + key + "\" must have the same placeholders {}");
    }
    entries.emplace(key, *translation);
  }
  return {name, *title, text::Catalogue(std::move(entries))};
}

const Language& languageOfLocale(std::string_view locale) {
  const Language* found = findLanguage(locale.substr(0, locale.find_first_of("_.@")));
  return found == nullptr ? languages().front() : *found;
}

}  // namespace drape::locale
