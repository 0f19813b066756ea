#include "report/sections/sections.hpp"

#include <array>

namespace drape {

std::span<const Section> sectionTable() {
  static const std::array table{sections::table1(), sections::growth(), sections::workPrecision(),
                                sections::stability()};
  return table;
}

}  // namespace drape
