#include "app/report/report_folder.hpp"

#include "app/output_file.hpp"
#include "messages/error.hpp"

#include <fstream>
#include <utility>

namespace drape::app {
namespace {

constexpr const char* jsonName = "report.json";

}  // namespace

ReportFolder::ReportFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  makeFolder(folder_);
  // An error must show before the measurements.
  const auto probe = folder_ / ".report-probe";
  if (!std::ofstream(probe)) {
    throw messages::InputError("cannot write to the folder " + folder_.string());
  }
  std::filesystem::remove(probe);
}

nlohmann::ordered_json readReport(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) {
    throw messages::InputError("cannot read " + file.string());
  }
  auto json = nlohmann::ordered_json::parse(stream, nullptr, false);
  if (json.is_discarded()) {
    throw messages::InputError(file.string() + " is not JSON");
  }
  return json;
}

nlohmann::ordered_json ReportFolder::earlier() const {
  const auto file = folder_ / jsonName;
  return std::filesystem::exists(file) ? readReport(file) : nlohmann::ordered_json();
}

void ReportFolder::write(const std::filesystem::path& name, const std::string& text) const {
  const auto file = folder_ / name;
  makeFolder(file.parent_path());
  if (!replaceFile(file, text)) {
    throw messages::InputError("the report could not be written to " + file.string());
  }
}

void ReportFolder::writeJson(const report::Report& report) const {
  write(jsonName, jsonText(report::reportJson(report), 1) + "\n");
}

void ReportFolder::writeAll(const report::Report& report) const {
  writeJson(report);
  const report::MarkdownReport markdown = report::reportMarkdown(report);
  for (const report::ReportPicture& picture : markdown.pictures) {
    write(picture.name, picture.svg);
  }
  write("report.md", markdown.text);
  write("report.html", report::reportHtml(report));
}

}  // namespace drape::app
