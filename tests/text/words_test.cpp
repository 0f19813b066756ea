#include "text/words.hpp"

#include <gtest/gtest.h>

namespace drape::text {
namespace {

TEST(NearestWord, isTheOneThatWasMeant) {
  const std::vector<std::string> words{"run", "measure", "capture"};
  EXPECT_EQ(nearestWord("Run", words), "run");
  EXPECT_EQ(nearestWord("mesure", words), "measure");
  EXPECT_EQ(nearestWord("capt", words), "capture") << "the word starts with it";
  EXPECT_EQ(nearestWord("simulate", words), "");
  EXPECT_EQ(nearestWord("run", {}), "");
}

}  // namespace
}  // namespace drape::text
