#include "report/comparison.hpp"
#include "report/report_document.hpp"
#include "report/svg.hpp"
#include "report/svg_ink.hpp"
#include "report/xml_writer.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::report {
namespace {

constexpr std::string_view pageStyle = R"(
:root { color-scheme: light dark; --ink: #222; --paper: #fff; --faint: #ddd; --shade: #f4f5f7; --off: #b3001b; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #ddd; --paper: #16181c; --faint: #444; --shade: #202329; --off: #ff8a80; } }
body { color: var(--ink); background: var(--paper); font: 15px/1.5 sans-serif; max-width: 84rem; margin: 1rem auto;
  padding: 0 1rem; }
h1 { margin: 0; font-size: 1.5rem; }
p { max-width: 62rem; }
p.head { margin: 0; max-width: none; font-size: 12px; }
section.answer h2, section.answer p { margin: 0.4rem 0; }
section.answer table { margin: 0 0 0.6rem; font-size: 12px; line-height: 1.3; }
section.answer p { max-width: none; font-size: 12px; }
table { border-collapse: collapse; margin: 0.5rem 0 1.5rem; font-size: 13px; }
caption { text-align: left; font-weight: bold; padding-bottom: 0.3rem; }
th, td { border-bottom: 1px solid var(--faint); padding: 0.15rem 0.6rem; text-align: right; }
th.words, td.words { text-align: left; }
td { white-space: nowrap; }
td.words { overflow-wrap: anywhere; white-space: pre-line; }
th { background: var(--shade); }
tr.bad td { color: var(--off); font-weight: bold; }
summary { cursor: pointer; }
figure { margin: 1rem 0; }
svg.drape { max-width: 100%; height: auto; }
@media print {
  body { max-width: none; margin: 0; font-size: 11px; }
  section.details { break-before: page; }
  figure, tr { break-inside: avoid; }
  table, section.answer table { font-size: 8px; }
  th, td { padding: 0.1rem 0.25rem; }
  svg.drape { max-height: 11cm; }
}
)";

class HtmlWriter {
 public:
  explicit HtmlWriter(XmlWriter& html) : html_(html) {}

  void operator()(const Paragraph& paragraph) { html_.text("p", paragraph.text); }

  void operator()(const TextTable& table) {
    if (table.folded) {
      html_.open("details");
      html_.text("summary", table.title);
    }
    html_.open("table");
    html_.text("caption", table.title);
    std::vector<bool> words;
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      words.push_back(holdsWords(table, i));
    }
    row("th", table.header, words, false);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      row("td", table.rows[i], words, isBad(table, i));
    }
    html_.close();
    if (table.folded) {
      html_.close();
    }
  }

  void operator()(const Plot& plot) { picture(svgOf(plot)); }
  void operator()(const StateMap& map) { picture(svgOf(map)); }
  void operator()(const Drawing& drawing) { picture(svgOf(drawing)); }

 private:
  void row(std::string_view element, const std::vector<std::string>& fields, const std::vector<bool>& words, bool bad) {
    if (bad) {
      html_.open("tr", {{"class", "bad"}});
    } else {
      html_.open("tr");
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i < words.size() && words[i]) {
        html_.text(element, fields[i], {{"class", "words"}});
      } else {
        html_.text(element, fields[i]);
      }
    }
    html_.close();
  }

  void picture(const std::string& svg) {
    html_.open("figure");
    html_.raw(svg);
    html_.close();
  }

  XmlWriter& html_;
};

/// The machine and the build in one line.
void writeHead(XmlWriter& html, const Report& report) {
  html.text("h1", "Speed against error");
  std::string line;
  for (const auto& [name, value] : reportHead(report)) {
    line += (line.empty() ? "" : " · ") + name + ": " + value;
  }
  html.text("p", line, {{"class", "head"}});
}

void writeBlocks(XmlWriter& html, std::string_view title, const std::vector<Block>& blocks) {
  HtmlWriter writer(html);
  html.text("h2", title);
  for (const Block& block : blocks) {
    std::visit(writer, block);
  }
}

/// The first section answers the report's question, and fits on a screen together with the head.
void writeSections(XmlWriter& html, const Report& report) {
  for (const Section& section : sectionTable()) {
    const ReportRows rows = rowsOf(report, section);
    const bool isAnswer = section.name == sectionTable().front().name;
    if (!rows.empty()) {
      html.open("section", {{"class", isAnswer ? "answer" : "details"}});
      writeBlocks(html, section.title, section.show(report.options, rows));
      html.close();
    }
    if (isAnswer && !report.comparison.is_null()) {
      writeBlocks(html, comparisonTitle, showComparison(report.comparison));
    }
  }
}

}  // namespace

std::string reportHtml(const Report& report) {
  XmlWriter html;
  html.raw("<!DOCTYPE html>\n");
  html.open("html", {{"lang", "en"}});
  html.open("head");
  html.empty("meta", {{"charset", "utf-8"}});
  html.empty("meta", {{"name", "viewport"}, {"content", "width=device-width"}});
  html.text("title", "Drape: speed against error");
  html.open("style");
  html.raw(pageStyle);
  html.raw("@media screen and (prefers-color-scheme: dark) {\n" + darkStyle() + "}\n");
  html.close();
  html.close();
  html.open("body");
  writeHead(html, report);
  writeSections(html, report);
  return html.take();
}

}  // namespace drape::report
