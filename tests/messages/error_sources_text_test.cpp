#include "messages/error_sources_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace drape::messages {
namespace {

std::string english(const sim::ErrorSources& sources) {
  return inWords(sources).english();
}

TEST(ErrorSourcesText, namesTheLargestSource) {
  EXPECT_EQ(english({.time = 0.5, .method = 2e-5, .mesh = 3e-3, .material = 4e-4, .start = 1e-6}),
            "Most of the error comes from the mesh: about 3 mm after 0.5 s");
  EXPECT_EQ(english({.time = 0.5, .method = 2e-2, .mesh = 3e-3, .material = 4e-4, .start = 1e-6}),
            "Most of the error comes from the method: about 20 mm after 0.5 s");
  EXPECT_EQ(english({.time = 0.2, .method = 2e-5, .mesh = 3e-4, .material = 4e-3, .start = 1e-6}),
            "A material that is stiffer by a tenth changes most: about 4 mm after 0.2 s");
}

TEST(ErrorSourcesText, saysWhereNothingCanBeKnown) {
  EXPECT_EQ(english({.time = 0.5, .method = 2e-5, .mesh = 3e-3, .material = 4e-4, .start = 1e-2}),
            "The motion cannot be known: starts 1 \u00B5m apart are about 10 mm apart after 0.5 s");
  EXPECT_EQ(english({.time = 0.5, .method = std::numeric_limits<double>::infinity(), .mesh = 3e-3, .material = 4e-4}),
            "Most of the error comes from the method: the cloth blew up before 0.5 s");
}

}  // namespace
}  // namespace drape::messages
