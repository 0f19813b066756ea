#include "browser.hpp"

#include "program.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace drape::app::testing {

bool hasBrowser() {
  return std::system("command -v chromium >/dev/null") == 0;
}

PageVisit visitPage(const std::string& html, int width, int height, const std::string& script,
                    const std::filesystem::path& folder) {
  // The browser prints the whole page after the script; the result stands between two marks.
  const std::string begin = "RESULT-BEGIN";
  const std::string end = "RESULT-END";
  const auto page = folder / "visited.html";
  std::ofstream(page) << html << "<script>const visit = () => {" << script
                      << "};\ndocument.body.append('RESULT-' + 'BEGIN' + visit() + 'RESULT-' + 'END');</script>";
  const std::string command =
      "timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=" +
      std::to_string(width) + "," + std::to_string(height) + " --user-data-dir=" + (folder / "browser").string() +
      " --enable-logging=stderr --dump-dom 'file://" + page.string() + "' >" + (folder / "dom").string() + " 2>" +
      (folder / "messages").string() + " </dev/null";
  (void)std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): the test has one thread
  PageVisit visit;
  const std::string dom = readFile(folder / "dom");
  const std::size_t from = dom.rfind(begin);
  const std::size_t to = dom.rfind(end);
  visit.result = from == std::string::npos || to == std::string::npos
                     ? "the page was not opened"
                     : dom.substr(from + begin.size(), to - from - begin.size());
  std::ifstream messages(folder / "messages");
  for (std::string line; std::getline(messages, line);) {
    visit.console += line.find("CONSOLE") == std::string::npos ? "" : line + "\n";
  }
  return visit;
}

}  // namespace drape::app::testing
