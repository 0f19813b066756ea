#include "report/report_document.hpp"

#include "messages/error.hpp"

namespace drape::report {
namespace {

/// Increases when rows change their meaning, so that an old report is not continued.
constexpr int formatVersion = 2;

nlohmann::ordered_json optionsJson(const ReportOptions& options) {
  nlohmann::ordered_json json{{"quick", options.quick}, {"scene", options.scene}, {"threads", options.threads}};
  if (options.own) {
    json["set"] = options.own->settings;
    json["budget_ms"] = options.own->budget;
    json["seconds"] = options.own->seconds;
  }
  return json;
}

}  // namespace

nlohmann::ordered_json reportJson(const Report& report) {
  nlohmann::ordered_json json{{"format", formatVersion},
                              {"machine", report.machine},
                              {"settings", optionsJson(report.options)},
                              {"complete", report.complete}};
  for (const Section& section : sectionTable()) {
    json[std::string(section.name)] = rowsOf(report, section);
  }
  if (!report.comparison.is_null()) {
    json["comparison"] = report.comparison;
  }
  return json;
}

void requireComparable(const nlohmann::ordered_json& json, const Report& report) {
  const bool isReport = json.is_object() && json.contains("format") && json.contains("settings") &&
                        json.contains("machine") && json["machine"].is_object();
  if (!isReport) {
    throw messages::InputError("the file to compare with is not a report.json of drape-report");
  }
  if (json["format"] != formatVersion) {
    throw messages::InputError("the report to compare with has format " + json["format"].dump() +
                               ", this program writes " + std::to_string(formatVersion) +
                               ": their values are not comparable; make the report again");
  }
  if (json["settings"] != optionsJson(report.options)) {
    throw messages::InputError("the report to compare with was made with " + json["settings"].dump() +
                               ", this one with " + optionsJson(report.options).dump() + "; give the same options");
  }
  if (json["machine"].value("build_type", "") != report.machine.value("build_type", "")) {
    throw messages::InputError("the report to compare with is of a " + json["machine"].value("build_type", "") +
                               " build, this one of a " + report.machine.value("build_type", "") + " build");
  }
}

SectionRows rowsToResume(const nlohmann::ordered_json& json, const Report& report) {
  if (!json.is_object() || json.value("format", 0) != formatVersion || !json.contains("machine")) {
    throw messages::InputError("this report.json cannot be continued; start again without --resume");
  }
  for (const char* key : {"cpu", "commit", "build_type"}) {
    if (json["machine"].value(key, "") != report.machine.value(key, "")) {
      throw messages::InputError(std::string("report.json was made with another ") + key +
                                 ", and values of two must not be mixed; start again without --resume");
    }
  }
  if (json["settings"] != optionsJson(report.options)) {
    throw messages::InputError("report.json was made with " + json["settings"].dump() +
                               "; continue with the same options, or start again without --resume");
  }
  SectionRows rows;
  for (const Section& section : sectionTable()) {
    const std::string name(section.name);
    if (section.plan != nullptr && json.contains(name) && json[name].is_array()) {
      rows[name] = json[name].get<ReportRows>();
    }
  }
  return rows;
}

std::vector<std::pair<std::string, std::string>> reportHead(const Report& report) {
  std::vector<std::pair<std::string, std::string>> head;
  for (const auto& [key, value] : report.machine.items()) {
    head.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  const ReportOptions& options = report.options;
  head.emplace_back("settings", std::string(options.quick ? "quick" : "full") + ", scenes " +
                                    (options.scene.empty() ? "all" : options.scene) + ", " +
                                    std::to_string(options.threads) + (options.threads == 1 ? " thread" : " threads"));
  if (!report.complete) {
    head.emplace_back("complete", "no: it was stopped early");
  }
  return head;
}

ReportRows rowsOf(const Report& report, const Section& section) {
  if (section.derive != nullptr) {
    return section.derive(report.rows);
  }
  const auto rows = report.rows.find(section.name);
  return rows == report.rows.end() ? ReportRows() : rows->second;
}

}  // namespace drape::report
