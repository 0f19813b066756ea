#include "report/sections/error_check_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/work_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace drape::report::sections {
namespace {

constexpr double millimetres = 1e3;
/// The factor within which an error that the check calls known must be right [-].
constexpr double promisedFactor = 5.0;
/// Errors below this are right if the check is below it too [m].
constexpr double negligible = 1e-6;

double ratioOf(const ReportRow& row) {
  return std::max(numberIn(row, "checked_error"), negligible) / std::max(numberIn(row, "error"), negligible);
}

bool isKnown(const ReportRow& row) {
  return row.value("state", "") == "known";
}

bool isCalledUnknown(const ReportRow& row) {
  return row.value("state", "") == "not known";
}

/// What is wrong with a number that should be 1; empty if it is right, or not a number.
std::string faultOf(double ratio, const char* tooLarge, const char* tooSmall) {
  if (ratio > promisedFactor) {
    return tooLarge;
  }
  return ratio < 1.0 / promisedFactor ? tooSmall : "";
}

std::string inOneLine(const CheckCounts& counts) {
  return fmt::format(
      "{} checks. Error right within a factor of {:g}: {}. Error not to be known: {}. Wrong: {}. No result: {}.",
      counts.all(), promisedFactor, counts.right, counts.notKnown, counts.wrong, counts.noResult);
}

TextTable tableOf(const ReportRows& rows) {
  TextTable table{"Errors after 0.2 s",
                  {"cloth", "method", "error by the check [mm]", "true error [mm]", "check / true",
                   "spread of the references [mm]", "jitter [mm]", "verdict of the check", "note"},
                  {}};
  for (const ReportRow& row : rows) {
    const std::string note = checkNote(row);
    table.rows.push_back(
        {titleOf(workClothOf(row)), row.value("method", ""), text::figure(millimetres * numberIn(row, "checked_error")),
         text::figure(millimetres * numberIn(row, "error")), isKnown(row) ? text::figure(ratioOf(row)) : "-",
         text::figure(millimetres * numberIn(row, "spread")), text::figure(millimetres * numberIn(row, "noise_floor")),
         row.value("state", ""), note});
    table.tones.push_back(note.empty() ? Tone::None : Tone::Bad);
  }
  return table;
}

}  // namespace

std::string checkNote(const ReportRow& row) {
  if (isKnown(row)) {
    return faultOf(ratioOf(row), "too large", "too small");
  }
  if (isCalledUnknown(row)) {
    return faultOf(numberIn(row, "spread") / numberIn(row, "noise_floor"), "spread too large", "spread too small");
  }
  return {};
}

CheckCounts countChecks(const ReportRows& rows) {
  CheckCounts counts;
  for (const ReportRow& row : rows) {
    const bool hasResult = (isKnown(row) && std::isfinite(ratioOf(row))) || isCalledUnknown(row);
    int& count = !hasResult                ? counts.noResult
                 : !checkNote(row).empty() ? counts.wrong
                 : isKnown(row)            ? counts.right
                                           : counts.notKnown;
    ++count;
  }
  return counts;
}

std::vector<Block> showErrorCheck(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{inOneLine(countChecks(rows))});
  blocks.emplace_back(Paragraph{
      "With 'error_check' Drape compares 0.2 s of the motion with that of 'auto' in double with finer steps, and with "
      "a second such motion whose start differs by 0.001 mm. 'Spread' is the distance between the two finer motions. "
      "Drape shows the error, or says that it cannot be known because tiny differences grow too fast. The table "
      "compares the error with the distance from a converged reference, and the spread with 'jitter': the distance "
      "between two converged motions whose starts differ by up to 0.001 mm. A row is red where an error that is given, "
      "or the spread of one that cannot be known, is wrong by more than a factor of 5. Errors below 0.001 mm count as "
      "0.001 mm."});
  blocks.emplace_back(tableOf(rows));
  return blocks;
}

}  // namespace drape::report::sections
