#pragma once

#include "report/section.hpp"

/// Every section of the report: a function that describes it, defined in the file of its name, and its place in the
/// list of sections.cpp. Nothing else has to know a new one.
namespace drape::sections {

Section table1();
Section table2();
Section growth();
Section workPrecision();
Section stability();
Section whatFollows();
Section threads();
Section hardCases();
Section collision();

}  // namespace drape::sections
