#include "report/comparison.hpp"
#include "report/report_document.hpp"
#include "report/svg.hpp"
#include "report/xml_writer.hpp"

namespace drape::report {
namespace {

constexpr std::string_view pageStyle = R"(
:root { color-scheme: light dark; --ink: #222; --paper: #fff; --faint: #ddd; --shade: #f4f5f7; --off: #b3001b; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #ddd; --paper: #16181c; --faint: #444; --shade: #202329; --off: #ff8a80; } }
body { color: var(--ink); background: var(--paper); font: 15px/1.5 sans-serif; max-width: 62rem; margin: 2rem auto;
  padding: 0 1rem; }
table { border-collapse: collapse; margin: 0.5rem 0 1.5rem; font-size: 13px; }
caption { text-align: left; font-weight: bold; padding-bottom: 0.3rem; }
th, td { border-bottom: 1px solid var(--faint); padding: 0.15rem 0.6rem; text-align: right; }
th.words, td.words, table.head td { text-align: left; }
table.head td { overflow-wrap: anywhere; }
th { background: var(--shade); }
tr.bad td { color: var(--off); font-weight: bold; }
summary { cursor: pointer; }
figure { margin: 1rem 0; }
div.wide { overflow-x: auto; }
@media print {
  body { max-width: none; margin: 0; font-size: 11px; }
  h2:not(:first-of-type) { break-before: page; }
  figure, tr { break-inside: avoid; }
  div.wide { overflow: visible; }
  table { font-size: 8px; }
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
    html_.open("div", {{"class", "wide"}});
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

void writeHead(XmlWriter& html, const Report& report) {
  html.text("h1", "Speed against error");
  html.open("table", {{"class", "head"}});
  for (const auto& [name, value] : reportHead(report)) {
    html.open("tr");
    html.text("td", name);
    html.text("td", value);
    html.close();
  }
  html.close();
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
  html.raw(svgStyle());
  html.close();
  html.close();
  html.open("body");
  writeHead(html, report);
  HtmlWriter writer(html);
  if (!report.comparison.is_null()) {
    html.text("h2", comparisonTitle);
    for (const Block& block : showComparison(report.comparison)) {
      std::visit(writer, block);
    }
  }
  for (const Section& section : sectionTable()) {
    if (const ReportRows rows = rowsOf(report, section); !rows.empty()) {
      html.text("h2", section.title);
      for (const Block& block : section.show(report.options, rows)) {
        std::visit(writer, block);
      }
    }
  }
  return html.take();
}

}  // namespace drape::report
