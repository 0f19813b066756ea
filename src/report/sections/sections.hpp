#pragma once

#include "report/section.hpp"

/// All sections of the report. Each is described by a function in the file of its name, and listed in sections.cpp.
namespace drape::report::sections {

Section answer();
Section table1();
Section table2();
Section growth();
Section workPrecision();
Section stability();
Section conclusions();
Section budget();
Section threads();
Section hardCases();
Section collision();
Section validation();
Section stretchLimit();
Section errorCheck();
Section errorSources();
Section pace();

}  // namespace drape::report::sections
