#pragma once

#include "settings/own_fabrics.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace drape::scene {

class TomlReader;

/// The fabrics in the tables [[fabrics]] of a TOML document: the user's list or a scene file. A fabric with based_on
/// takes the values that its table leaves out from that built-in fabric; without based_on it must give all of them.
/// Throws InputError with file, line and name for a bad name, a value out of its range, values that exclude each other,
/// and two fabrics of one name.
[[nodiscard]] settings::OwnFabrics readFabrics(const TomlReader& document);

/// The fabrics of a file's text. @param file for messages
[[nodiscard]] settings::OwnFabrics parseFabrics(std::string_view text, const std::string& file);

/// Reads the user's list. Throws InputError as parseFabrics does, and when the file cannot be read or is above 1 MiB.
[[nodiscard]] settings::OwnFabrics readFabricFile(const std::filesystem::path& file);

/// The table [[fabrics]] of a fabric.
[[nodiscard]] std::string fabricEntry(const settings::OwnFabric& fabric);

/// The text of a fabric list or of a scene file with one more fabric, which replaces one of the same name. Everything
/// else keeps its text, comments too. Throws InputError when the text is not valid, or when the fabric with that name
/// is written in a form that cannot be replaced. @param file for messages
[[nodiscard]] std::string withFabricEntry(std::string_view text, const settings::OwnFabric& fabric,
                                          const std::string& file);

}  // namespace drape::scene
