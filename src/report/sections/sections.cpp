#include "report/sections/sections.hpp"

#include <array>

namespace drape::report {

std::span<const Section> sectionTable() {
  static const std::array table{
      sections::answer(),       sections::table1(),     sections::table2(),       sections::workPrecision(),
      sections::conclusions(),  sections::budget(),     sections::stability(),    sections::hardCases(),
      sections::growth(),       sections::threads(),    sections::collision(),    sections::validation(),
      sections::stretchLimit(), sections::errorCheck(), sections::errorSources(), sections::pace()};
  return table;
}

}  // namespace drape::report
