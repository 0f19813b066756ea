#pragma once

#include "report/report_document.hpp"

#include <filesystem>

namespace drape {

/// The folder that a report is written to: report.json, report.md with its pictures, report.html.
class ReportFolder {
 public:
  /// Makes the folder. Throws InputError when it cannot be written to.
  explicit ReportFolder(std::filesystem::path folder);

  /// The report.json that is there. Throws InputError when it is none; null when there is none.
  [[nodiscard]] nlohmann::ordered_json earlier() const;

  void writeJson(const Report& report) const;
  void writeAll(const Report& report) const;

 private:
  /// Through a file beside it, so that what was there stays whole until the new one is.
  void write(const std::filesystem::path& name, const std::string& text) const;

  std::filesystem::path folder_;
};

}  // namespace drape
