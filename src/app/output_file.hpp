#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace drape {

/// A file that receives a program's figures when its work is done.
///
/// It is opened before the work, so that a wrong folder shows at once and not after hours. What was in the file stays
/// until `write` replaces it; a file that did not exist and was never written disappears again.
class OutputFile {
 public:
  /// @param name of the file, of any bytes  @param what it holds, for messages: "statistics"
  /// Throws InputError when the file cannot be opened for writing.
  OutputFile(std::string name, std::string what);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Writes the figures and closes the file; call it once. Text that is not UTF-8, as file names may be, gets the
  /// replacement character U+FFFD for each wrong byte. Throws InputError when not everything could be written.
  void write(const nlohmann::ordered_json& figures);

 private:
  std::string name_;
  std::string what_;
  int file_ = -1;         // descriptor; -1 when closed
  bool isOurs_ = false;   // it did not exist before
  bool written_ = false;  // `write` has begun
};

/// JSON as text. Bytes that are not UTF-8 become the replacement character U+FFFD.
/// @param indent spaces a level
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json, int indent);

}  // namespace drape
