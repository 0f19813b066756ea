#include "scene/unit_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace drape::scene {
namespace {

TEST(UnitGuess, findsTheUnitOfUsualGarmentsAndBodies) {
  struct Case {
    const char* what;
    double metres;
  };
  for (const Case& each : {Case{"T-shirt", 0.77}, Case{"short shirt", 0.6}, Case{"dress", 1.2}, Case{"body", 1.75}}) {
    EXPECT_EQ(guessUnit(each.metres).unit, "m") << each.what;
    EXPECT_EQ(guessUnit(each.metres * 10.0).unit, "dm") << each.what;
    EXPECT_EQ(guessUnit(each.metres * 100.0).unit, "cm") << each.what;
    EXPECT_EQ(guessUnit(each.metres * 1000.0).unit, "mm") << each.what;
  }
  EXPECT_EQ(guessUnit(28.0).unit, "inch") << "a T-shirt of 28 inches rather than a sock of 28 cm";
}

TEST(UnitGuess, comparesABodyWithPersons) {
  for (const double metres : {1.55, 1.7, 1.85}) {
    for (const char* unit : {"m", "dm", "cm", "mm", "inch", "foot"}) {
      const UnitGuess guess = guessUnit(metres / metresPerUnit(unit), io::MeshUse::Body);
      EXPECT_EQ(guess.unit, unit) << metres;
      EXPECT_TRUE(guess.isUsual) << unit;
    }
  }
  EXPECT_EQ(guessUnit(67.0, io::MeshUse::Body).unit, "inch");
  EXPECT_EQ(guessUnit(67.0).unit, "cm") << "a T-shirt, but no person";
  EXPECT_FALSE(guessUnit(0.4, io::MeshUse::Body).isUsual) << "a ball";
  EXPECT_TRUE(guessUnit(0.4).isUsual);
}

TEST(UnitGuess, comparesATorsoWithTorsos) {
  constexpr double fullness = 0.09;  // of a dress form
  EXPECT_TRUE(isTorso(fullness));
  for (const double metres : {0.65, 0.75, 0.85}) {
    for (const char* unit : {"m", "dm", "cm", "mm", "inch", "foot"}) {
      const UnitGuess guess = guessUnit(metres / metresPerUnit(unit), io::MeshUse::Body, fullness);
      EXPECT_EQ(guess.unit, unit) << metres;
      EXPECT_TRUE(guess.isUsual) << unit;
    }
  }
  EXPECT_EQ(guessUnit(78.0, io::MeshUse::Body).unit, "inch") << "a person";
}

TEST(UnitGuess, namesTheOtherUnitsThatMakeAGarment) {
  const UnitGuess shirt = guessUnit(77.0);
  EXPECT_EQ(shirt.unit, "cm");
  EXPECT_EQ(shirt.others, (std::vector<std::string>{"inch"}));
  EXPECT_TRUE(guessUnit(0.81).others.empty()) << "a T-shirt of 81 cm rather than one of 25 cm in feet";
  const UnitGuess small = guessUnit(30.0);
  EXPECT_NE(std::find(small.others.begin(), small.others.end(), "cm"), small.others.end());
}

TEST(UnitGuess, staysWithinTheSizesOfGarments) {
  for (double extent = smallestGarment; extent < largestGarment * 1000.0; extent *= 1.07) {
    const UnitGuess guess = guessUnit(extent);
    const double metres = extent * metresPerUnit(guess.unit);
    EXPECT_GE(metres, smallestGarment) << extent;
    EXPECT_LE(metres, largestGarment) << extent;
  }
}

TEST(UnitGuess, takesTheNearestUnitForWhatIsNoGarment) {
  EXPECT_EQ(guessUnit(0.05).unit, "m") << "a patch of 5 cm";
  EXPECT_EQ(guessUnit(1e-6).unit, "m");
  EXPECT_EQ(guessUnit(1e7).unit, "mm");
  EXPECT_TRUE(guessUnit(0.05).others.empty());
  EXPECT_EQ(guessUnit(0.0).unit, "m");
}

TEST(UnitGuess, knowsHowLongUnitsAre) {
  EXPECT_EQ(metresPerUnit("m"), 1.0);
  EXPECT_EQ(metresPerUnit("dm"), 0.1);
  EXPECT_EQ(metresPerUnit("cm"), 0.01);
  EXPECT_EQ(metresPerUnit("mm"), 0.001);
  EXPECT_EQ(metresPerUnit("inch"), 0.0254);
  EXPECT_EQ(metresPerUnit("0.3048"), 0.3048);
  EXPECT_EQ(metresPerUnit("foot"), 0.3048);
  EXPECT_EQ(unitInWords("cm"), "centimetres");
  EXPECT_EQ(wordForUnit(0.3048), "foot");
  EXPECT_EQ(unitInWords("0.3048"), "units of 0.3048 m");
}

}  // namespace
}  // namespace drape::scene
