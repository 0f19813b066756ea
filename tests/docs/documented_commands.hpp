#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace drape::app::testing {

/// A command line in the documentation.
struct DocumentedCommand {
  std::string page;     ///< the Markdown file, relative to the project's root
  int line = 0;         ///< of its start, from 1
  std::string program;  ///< first word, without its folder: "drape-headless", "run" for scripts/run
  bool script = false;  ///< the first word is in scripts/
  std::string text;     ///< the whole command line, continued lines joined, without a comment
  /// It cannot be run as it is: it has placeholders (`[SCENE|MESH]`, `--seconds T`, `...`), or contains only a
  /// subcommand (`drape-headless measure`).
  bool synopsis = false;
  std::string needs;  ///< the command before it that writes a file it reads; empty: it reads none
};

/// For messages of Google Test: page, line and text.
std::ostream& operator<<(std::ostream& stream, const DocumentedCommand& command);

/// The commands of README.md, CONTRIBUTING.md, the guide and the theory that call one of the project's programs or
/// scripts, cmake or ctest, with at least one argument: lines of code blocks and code spans.
[[nodiscard]] std::vector<DocumentedCommand> documentedCommands(const std::filesystem::path& root);

/// The commands of one page's text.
[[nodiscard]] std::vector<DocumentedCommand> commandsIn(const std::string& page, const std::string& markdown);

}  // namespace drape::app::testing
