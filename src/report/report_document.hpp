#pragma once

#include "report/section_run.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape::report {

/// The whole report.
struct Report {
  nlohmann::ordered_json machine;  ///< machineJson
  ReportOptions options;
  bool complete = false;  ///< whether no requested cell is missing
  SectionRows rows;
  nlohmann::ordered_json comparison;  ///< compareReports, or null
};

/// The report as one JSON object: machine, settings, complete, and an array per section, empty when it was not
/// measured. docs/guide/report.schema.json describes it.
[[nodiscard]] nlohmann::ordered_json reportJson(const Report& report);

/// The rows of an earlier report with the same options, build and machine, to continue it. Throws InputError for any
/// other report.
[[nodiscard]] SectionRows rowsToResume(const nlohmann::ordered_json& json, const Report& report);

/// Throws InputError when `json` is not a report, or has another version, build type or options than `report`: their
/// values are then not comparable.
void requireComparable(const nlohmann::ordered_json& json, const Report& report);

/// A picture of the Markdown text, and its path below the report's folder.
struct ReportPicture {
  std::string name;
  std::string svg;
};

struct MarkdownReport {
  std::string text;
  std::vector<ReportPicture> pictures;
};

[[nodiscard]] MarkdownReport reportMarkdown(const Report& report);

/// A self-contained page with style and pictures.
[[nodiscard]] std::string reportHtml(const Report& report);

/// The head of a report, as names and values.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> reportHead(const Report& report);

/// The rows of a section: measured, or derived from others.
[[nodiscard]] ReportRows rowsOf(const Report& report, const Section& section);

}  // namespace drape::report
