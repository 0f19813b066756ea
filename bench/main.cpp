#include "bench/suite.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iostream>

/// Measures the cost of steps and prints one table. See docs/guide/performance.md.
int main(int argc, char** argv) {
  CLI::App app{"Measures what steps cost, and prints one table of times and ratios."};
  std::string jsonFile;
  std::string filter = "all";
  int repetitions = 20;
  double seconds = 0.02;
  app.add_option("--json", jsonFile, "Write the table as JSON to this file as well");
  app.add_option("--filter", filter, "Only what matches this regular expression, e.g. '^step/'")->capture_default_str();
  app.add_option("--repetitions", repetitions, "Times that each is repeated, in a random order")->capture_default_str();
  app.add_option("--seconds", seconds, "How long a repetition takes at least [s]")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    drape::bench::Suite suite;
    drape::bench::addStepGroup(suite);
    drape::bench::addInstructionsGroup(suite);
    drape::bench::addFloorGroup(suite);
    drape::bench::addIrregularGroup(suite);
    drape::bench::addSizeGroup(suite);
    drape::bench::addThreadsGroup(suite);
    drape::bench::addMemoryGroup(suite);
    drape::bench::addViewerGroup(suite);
    drape::bench::addSelfCollisionGroup(suite);
    drape::bench::addBodyContactGroup(suite);
    drape::bench::addContactGroup(suite);
    drape::bench::addAutoGroup(suite);
    drape::bench::addBulletGroup(suite);
    const drape::bench::Results results = suite.run(filter, repetitions, seconds);
    std::cout << results.markdown();
    if (!jsonFile.empty()) {
      std::ofstream file(jsonFile);
      file << results.json();
      if (!file) {
        throw std::runtime_error("cannot write " + jsonFile);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "drape_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
