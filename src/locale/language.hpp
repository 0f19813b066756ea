#pragma once

#include "text/catalogue.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace drape::locale {

/// A language of the window.
struct Language {
  std::string name;   ///< "de"
  std::string title;  ///< in the language itself: "Deutsch"
  text::Catalogue texts;
};

/// English and the languages of assets/locale, which are embedded.
[[nodiscard]] std::span<const Language> languages();

/// The language with that name, or nullptr.
[[nodiscard]] const Language* findLanguage(std::string_view name);

/// The language with that name, or of a catalogue file of the user: a name with the ending .toml. Throws UsageError
/// with all names when there is none, InputError as parseLanguage() does.
[[nodiscard]] Language openLanguage(const std::string& nameOrFile);

/// A language from a catalogue file, which gives a translation for each text of the sources:
///
///     title = "Deutsch"
///     [texts]
///     "{} vertices" = "{} Knoten"
///
/// Throws InputError with the line when the file is no such table, or a translation does not name exactly the
/// placeholders of its text.
/// @param source of the text, for messages
[[nodiscard]] Language parseLanguage(std::string_view toml, const std::string& name, const std::string& source);

/// The language of a locale of the system, such as "de_AT.UTF-8"; English where there is none.
[[nodiscard]] const Language& languageOfLocale(std::string_view locale);

}  // namespace drape::locale
