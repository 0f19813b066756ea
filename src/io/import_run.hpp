#pragma once

#include "io/import_protocol.hpp"
#include "io/import_watch.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

inline constexpr std::size_t largestFile = std::size_t{512} << 20;  ///< [bytes]

/// The default time limit of an import: ten seconds and one second per 2 MiB [s].
[[nodiscard]] double defaultTimeLimit(std::size_t bytes);

/// The contents of a file. Throws InputError with its name when it is missing, not a regular file, too large or cannot
/// be read. @param check throws when the name has an unknown extension; called before the file is read
[[nodiscard]] std::string readWholeFile(const std::filesystem::path& file,
                                        const std::function<void(const std::string& name)>& check);

/// Runs drape-mesh-import with limits of memory and time. Throws InputError, without the name of the file, when it
/// crashes, takes too long or reports an error; and Cancelled when the watch cancels.
/// @param arguments the format, then what else the program takes  @param otherFormats "another format (.obj, .ply)"
[[nodiscard]] ImportReply replyOf(std::vector<std::string> arguments, std::string_view bytes, double timeLimit,
                                  const std::string& otherFormats, const ImportWatch& watch);

}  // namespace drape::io
