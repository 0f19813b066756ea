#include "report/blocks.hpp"

#include <gtest/gtest.h>

namespace drape::report {
namespace {

TEST(Blocks, tellColumnsOfWordsFromColumnsOfNumbers) {
  TextTable table;
  table.header = {"17x17", "time", "grid", "what", "limit"};
  table.rows = {
      {"1", "0.5", "17x17", "calm", "none"}, {"2", "-", "33x33", "exploded", "12"}, {"3", "1e3", "", "", "7"}};
  EXPECT_TRUE(holdsWords(table, 0)) << "the first column names the row";
  EXPECT_FALSE(holdsWords(table, 1));
  EXPECT_FALSE(holdsWords(table, 2)) << "a size is a number";
  EXPECT_TRUE(holdsWords(table, 3));
  EXPECT_FALSE(holdsWords(table, 4)) << "one word among numbers";
}

TEST(Blocks, tellBadRowsOfATable) {
  const TextTable table{.title = "", .header = {"a"}, .rows = {{"1"}, {"2"}, {"3"}}, .tones = {Tone::None, Tone::Bad}};
  EXPECT_FALSE(isBad(table, 0));
  EXPECT_TRUE(isBad(table, 1));
  EXPECT_FALSE(isBad(table, 2)) << "a row without a tone";
}

}  // namespace
}  // namespace drape::report
