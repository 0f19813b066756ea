#include "report/comparison.hpp"
#include "report/report_document.hpp"
#include "report/svg.hpp"

namespace drape::report {
namespace {

/// Escapes characters that end a field of a table or start an HTML element.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '\\') {
      result += '\\';
    }
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string lineOf(const std::vector<std::string>& fields, bool bold = false) {
  const std::string mark = bold ? "**" : "";
  std::string line = "|";
  for (const std::string& field : fields) {
    line.append(" ").append(field.empty() ? "" : mark + escaped(field) + mark).append(" |");
  }
  return line + "\n";
}

class MarkdownWriter {
 public:
  void operator()(const Paragraph& paragraph) { report.text += escaped(paragraph.text) + "\n\n"; }

  void operator()(const TextTable& table) {
    if (table.folded) {
      return;
    }
    report.text += "**" + escaped(table.title) + "**\n\n" + lineOf(table.header) + "|";
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      report.text += holdsWords(table, i) ? "---|" : "---:|";
    }
    report.text += "\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      report.text += lineOf(table.rows[i], isBad(table, i));
    }
    report.text += "\n";
  }

  void operator()(const Plot& plot) { picture(plot.name, plot.title, svgFile(svgOf(plot))); }

  void operator()(const StateMap& map) { picture(map.name, map.title, svgFile(svgOf(map))); }

  void operator()(const Drawing& drawing) { picture(drawing.name, drawing.title, svgFile(svgOf(drawing))); }

  MarkdownReport report;

 private:
  void picture(const std::string& name, const std::string& title, std::string svg) {
    const std::string file = "pictures/" + name + ".svg";
    report.text += "![" + escaped(title) + "](" + file + ")\n\n";
    report.pictures.push_back({file, std::move(svg)});
  }
};

/// The machine and the build.
std::string headTable(const Report& report) {
  std::string text = "| | |\n|---|---|\n";
  for (const auto& [name, value] : reportHead(report)) {
    text += lineOf({name, value});
  }
  return text + "\n";
}

}  // namespace

MarkdownReport reportMarkdown(const Report& report) {
  MarkdownWriter writer;
  std::string& text = writer.report.text;
  text = "# Speed against error\n\n";
  const auto write = [&](std::string_view title, const std::vector<Block>& blocks) {
    text += "## " + escaped(std::string(title)) + "\n\n";
    for (const Block& block : blocks) {
      std::visit(writer, block);
    }
  };
  for (const Section& section : sectionTable()) {
    if (const ReportRows rows = rowsOf(report, section); !rows.empty()) {
      write(section.title, section.show(report.options, rows));
    }
    // The answer comes first.
    if (section.name == sectionTable().front().name) {
      text += headTable(report);
      if (!report.comparison.is_null()) {
        write(comparisonTitle, showComparison(report.comparison));
      }
    }
  }
  return std::move(writer.report);
}

}  // namespace drape::report
