#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace drape::app {

/// Whether a file may be replaced.
enum class Existing { Refused, Replaced };

/// Throws InputError if the file exists and may not be replaced.
/// @param option of the command that allows the file to be replaced, for the message; empty: there is none
void requireFree(const std::filesystem::path& file, Existing existing, std::string_view option = {});

/// A file for the results of a program.
///
/// It is opened before the run, so that a wrong folder shows at once. The old content stays until `write` replaces it.
/// A new file that is never written is removed again.
class OutputFile {
 public:
  /// @param name of the file, in any bytes  @param what it contains, for messages: "statistics"
  /// Throws InputError when the file cannot be opened for writing.
  OutputFile(std::string name, std::string what);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Writes the results and closes the file; call it once. Each byte that is not valid UTF-8 (as in file names) becomes
  /// the replacement character U+FFFD. Throws InputError when the file could not be written completely.
  void write(const nlohmann::ordered_json& figures);
  /// The same with text of any format, unchanged.
  void writeText(std::string_view text);

 private:
  std::string name_;
  std::string what_;
  int file_ = -1;         // descriptor; -1 when closed
  bool isOurs_ = false;   // the file did not exist before
  bool written_ = false;  // `write` was called
};

/// Writes FILE.part and renames it to FILE, so that a reader never sees half a file. False if that fails.
[[nodiscard]] bool replaceFile(const std::filesystem::path& file, std::string_view text);

/// Creates the folder, with those above it, if it does not exist. Throws InputError.
void makeFolder(const std::filesystem::path& folder);

/// JSON as text. Bytes that are not valid UTF-8 become the replacement character U+FFFD.
/// @param indent spaces per level
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json, int indent);

}  // namespace drape::app
