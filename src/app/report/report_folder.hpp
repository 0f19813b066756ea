#pragma once

#include "report/report_document.hpp"

#include <filesystem>

namespace drape::app {

/// Reads a report.json. Throws InputError when it cannot be read or is not JSON.
[[nodiscard]] nlohmann::ordered_json readReport(const std::filesystem::path& file);

/// The folder of a report: report.json, report.md with its pictures, report.html.
class ReportFolder {
 public:
  /// Creates the folder. Throws InputError when it is not writable.
  explicit ReportFolder(std::filesystem::path folder);

  /// The existing report.json; null when there is none. Throws like readReport.
  [[nodiscard]] nlohmann::ordered_json earlier() const;

  void writeJson(const report::Report& report) const;
  void writeAll(const report::Report& report) const;

 private:
  /// Writes through a temporary file, so that the old file stays intact until the new one is complete.
  void write(const std::filesystem::path& name, const std::string& text) const;

  std::filesystem::path folder_;
};

}  // namespace drape::app
