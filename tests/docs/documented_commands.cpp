#include "documented_commands.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace drape::app::testing {
namespace {

/// Parses a command line; empty when it calls none of the project's programs.
std::optional<DocumentedCommand> parse(const std::string& page, int line, std::string text) {
  static const std::regex shape(
      R"(^(scripts/|build/release/bin/)?(drape[a-z-]*|drape_bench|[a-z_]+_tests|cmake|ctest|[a-z-]+)( +\S.*)$)");
  static const std::regex comment(R"( +# .*$)");
  static const std::regex mention(R"(drape-headless +(run|capture|measure|save|dress|untangle|bake))");
  static const std::regex placeholder(R"((^|[ |=/\[])(\.\.\.|[A-Z][A-Z_]*|\[.*\])($|[ |\]]))");
  text = std::regex_replace(text, comment, "");
  std::smatch parts;
  if (!std::regex_match(text, parts, shape)) {
    return std::nullopt;
  }
  const std::string folder = parts[1];
  const std::string program = parts[2];
  const bool known = program.rfind("drape", 0) == 0 || program == "cmake" || program == "ctest" ||
                     (program.size() > 6 && program.substr(program.size() - 6) == "_tests");
  if (!known && folder != "scripts/") {
    return std::nullopt;
  }
  const bool synopsis = std::regex_search(text, placeholder) || std::regex_match(text, mention);
  return DocumentedCommand{page, line, program, folder == "scripts/", text, synopsis, ""};
}

/// The code spans of a line outside code blocks. A bar is escaped in tables.
std::vector<std::string> codeSpans(const std::string& line) {
  std::vector<std::string> spans;
  for (std::size_t begin = line.find('`'); begin != std::string::npos;) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string::npos) {
      break;
    }
    spans.push_back(std::regex_replace(line.substr(begin + 1, end - begin - 1), std::regex(R"(\\\|)"), "|"));
    begin = line.find('`', end + 1);
  }
  return spans;
}

/// Text of the nearest command of the list that writes a file which that command reads; empty: none.
std::string writingCommand(const std::vector<DocumentedCommand>& before, const std::string& text) {
  static const std::regex written(R"(--(save|scene|output|export|film|probe-output|record|stats|json) +(\S+))");
  const std::string read = std::regex_replace(text, written, "") + ' ';
  const auto writes = std::find_if(before.rbegin(), before.rend(), [&](const DocumentedCommand& command) {
    std::smatch file;
    return std::regex_search(command.text, file, written) && read.find(' ' + file[2].str() + ' ') != std::string::npos;
  });
  return writes == before.rend() ? std::string{} : writes->text;
}

/// Reads the lines of a page.
class Page {
 public:
  Page(std::string name, const std::string& markdown) : name_(std::move(name)), stream_(markdown) {}

  std::vector<DocumentedCommand> read() {
    for (std::string line; next(line);) {
      if (line.rfind("```", 0) == 0) {
        fenced_ = !fenced_;
      } else if (fenced_ || line.rfind("    ", 0) == 0) {
        const int first = number_;
        add(first, withContinuation(line.substr(fenced_ ? 0 : 4)));
      } else {
        for (const std::string& span : codeSpans(line)) {
          add(number_, span);
        }
      }
    }
    return std::move(commands_);
  }

 private:
  bool next(std::string& line) {
    ++number_;
    return static_cast<bool>(std::getline(stream_, line));
  }

  std::string withContinuation(std::string line) {
    for (std::string more; !line.empty() && line.back() == '\\' && next(more);) {
      line.pop_back();
      line += more.substr(std::min(more.find_first_not_of(' '), more.size()));
    }
    return line;
  }

  void add(int line, const std::string& text) {
    if (auto command = parse(name_, line, text)) {
      command->needs = writingCommand(commands_, command->text);
      commands_.push_back(std::move(*command));
    }
  }

  std::string name_;
  std::istringstream stream_;
  int number_ = 0;
  bool fenced_ = false;
  std::vector<DocumentedCommand> commands_;
};

}  // namespace

std::ostream& operator<<(std::ostream& stream, const DocumentedCommand& command) {
  return stream << command.page << ':' << command.line << ": " << command.text;
}

std::vector<DocumentedCommand> commandsIn(const std::string& page, const std::string& markdown) {
  return Page(page, markdown).read();
}

std::vector<DocumentedCommand> documentedCommands(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> pages{root / "README.md", root / "CONTRIBUTING.md"};
  // The records in docs/experiments keep their original commands.
  for (const char* folder : {"docs", "docs/guide", "docs/theory"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") {
        pages.push_back(entry.path());
      }
    }
  }
  std::sort(pages.begin(), pages.end());
  std::vector<DocumentedCommand> all;
  for (const auto& page : pages) {
    std::ifstream stream(page, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (text.empty()) {
      throw std::runtime_error("cannot read " + page.string());
    }
    for (DocumentedCommand& command : commandsIn(std::filesystem::relative(page, root).string(), text)) {
      all.push_back(std::move(command));
    }
  }
  return all;
}

}  // namespace drape::app::testing
