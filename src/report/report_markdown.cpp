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
    line += " " + (field.empty() ? "" : mark + escaped(field) + mark) + " |";
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

}  // namespace

MarkdownReport reportMarkdown(const Report& report) {
  MarkdownWriter writer;
  std::string& text = writer.report.text;
  text = "# Speed against error\n\n| | |\n|---|---|\n";
  for (const auto& [name, value] : reportHead(report)) {
    text += lineOf({name, value});
  }
  text += "\n";
  if (!report.comparison.is_null()) {
    text += "## " + std::string(comparisonTitle) + "\n\n";
    for (const Block& block : showComparison(report.comparison)) {
      std::visit(writer, block);
    }
  }
  for (const Section& section : sectionTable()) {
    if (const ReportRows rows = rowsOf(report, section); !rows.empty()) {
      text += "## " + escaped(std::string(section.title)) + "\n\n";
      for (const Block& block : section.show(report.options, rows)) {
        std::visit(writer, block);
      }
    }
  }
  return std::move(writer.report);
}

}  // namespace drape::report
