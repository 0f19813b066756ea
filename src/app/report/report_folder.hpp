#pragma once

#include "report/report_document.hpp"

#include <filesystem>

namespace drape {

/// A report.json. Throws InputError when it cannot be read or is no JSON.
[[nodiscard]] nlohmann::ordered_json readReport(const std::filesystem::path& file);

/// The folder that a report is written to: report.json, report.md with its pictures, report.html.
class ReportFolder {
 public:
  /// Makes the folder. Throws InputError when it cannot be written to.
  explicit ReportFolder(std::filesystem::path folder);

  /// The report.json that is there; null when there is none. Throws as readReport.
  [[nodiscard]] nlohmann::ordered_json earlier() const;

  void writeJson(const Report& report) const;
  void writeAll(const Report& report) const;

 private:
  /// Through a file beside it, so that what was there stays whole until the new one is.
  void write(const std::filesystem::path& name, const std::string& text) const;

  std::filesystem::path folder_;
};

}  // namespace drape
