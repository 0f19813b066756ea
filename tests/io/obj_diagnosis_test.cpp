#include "io/obj_diagnosis.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

const std::string vertices = "# three corners\nv 0 0 0\nv 1.5 0 0\r\nv 0 +1e-3 0 1.0\n";

TEST(ObjDiagnosis, findsNothingInAnOrderlyFile) {
  EXPECT_EQ(diagnoseObj(vertices + "vt 0 0\nf 1/1 2/1 3/1\nf -3 -2 -1\nf 1//2 2//2 3//2"), "");
  EXPECT_EQ(diagnoseObj(""), "");
}

TEST(ObjDiagnosis, namesTheLineOfACoordinateThatIsNoNumber) {
  EXPECT_EQ(diagnoseObj(vertices + "v 0 nan 0\n"), "line 5: 'nan' is not a finite number");
  EXPECT_EQ(diagnoseObj(vertices + "v 0 0 -inf\n"), "line 5: '-inf' is not a finite number");
  EXPECT_EQ(diagnoseObj(vertices + "v 1e39 0 0\n"), "line 5: '1e39' is not a finite number");
  EXPECT_EQ(diagnoseObj(vertices + "v 1,5 0 0\n"), "line 5: '1,5' is not a finite number");
  EXPECT_EQ(diagnoseObj(vertices + "v 1 2\n"), "line 5: a vertex needs three coordinates");
}

TEST(ObjDiagnosis, namesTheLineOfAVertexThatIsNotThere) {
  EXPECT_EQ(diagnoseObj(vertices + "f 1 2 4\n"), "line 5: there is no vertex 4, only 3 come before it");
  EXPECT_EQ(diagnoseObj(vertices + "f 1 2 -4\n"), "line 5: there is no vertex -4, only 3 come before it");
  EXPECT_EQ(diagnoseObj(vertices + "f 0 1 2\n"), "line 5: vertex 0 does not exist: OBJ counts from 1");
  EXPECT_EQ(diagnoseObj(vertices + "f a b c\n"), "line 5: 'a' is not the number of a vertex");
}

TEST(ObjDiagnosis, keepsStrayBytesAndLongWordsOutOfTheMessage) {
  EXPECT_EQ(diagnoseObj("v \x1b[31m\x07 0 0"), "line 1: '?[31m?' is not a finite number");
  EXPECT_LT(diagnoseObj("v " + std::string(5000, 'x') + " 0 0").size(), 100U);
}

}  // namespace
}  // namespace drape
