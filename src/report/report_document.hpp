#pragma once

#include "report/section_run.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape {

/// All of a report.
struct Report {
  nlohmann::ordered_json machine;  ///< machineJson
  ReportOptions options;
  bool complete = false;  ///< no cell that was asked for is missing
  SectionRows rows;
  nlohmann::ordered_json comparison;  ///< compareReports, or null
};

/// Everything as one JSON object: machine, settings, complete, and an array for each section, empty where it was not
/// measured. docs/guide/report.schema.json tells what is in it.
[[nodiscard]] nlohmann::ordered_json reportJson(const Report& report);

/// The rows of an earlier report that was made with the same options on the same build and machine, to go on with.
/// Throws InputError when it is another one, or none at all.
[[nodiscard]] SectionRows rowsToResume(const nlohmann::ordered_json& json, const Report& report);

/// Throws InputError when `json` is no report, or was made by another version or build type or with other options than
/// `report`: then their figures say nothing about each other.
void requireComparable(const nlohmann::ordered_json& json, const Report& report);

/// A picture that goes with the Markdown text, and its name below the report's folder.
struct ReportPicture {
  std::string name;
  std::string svg;
};

struct MarkdownReport {
  std::string text;
  std::vector<ReportPicture> pictures;
};

[[nodiscard]] MarkdownReport reportMarkdown(const Report& report);

/// One page with its style and pictures in it: it needs no other file.
[[nodiscard]] std::string reportHtml(const Report& report);

/// The head of a report, as name and value.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> reportHead(const Report& report);

/// What there is of a section: measured, or derived from the others.
[[nodiscard]] ReportRows rowsOf(const Report& report, const Section& section);

}  // namespace drape
