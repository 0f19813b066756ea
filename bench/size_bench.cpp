// What a spring costs in a small cloth and in one that no cache holds.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

#include <algorithm>
#include <array>

namespace drape::bench {
namespace {

/// A grid's number of springs.
double springsOf(int n) {
  return (3.0 * n - 1.0) * (n - 1.0);
}

void addCloth(Suite& suite, const std::string& name, int n, ModelPtr (*make)(int)) {
  // About as many springs a batch for every size.
  const int batch = std::clamp(static_cast<int>(2e5 / springsOf(n)), 2, 50);
  suite.add({"size", name, "ns/(spring step)"}, [=]() -> Batch {
    auto runner = std::make_shared<SliceRunner<float>>(make(n), Method::OneIteration, fullStep());
    return {batch * static_cast<double>(runner->model().springs.size()),
            [runner, batch] { return batchSeconds(*runner, batch); }};
  });
}

std::string sized(const char* what, int n) {
  return std::string(what) + " " + std::to_string(n) + "x" + std::to_string(n);
}

}  // namespace

void addSizeGroup(Suite& suite) {
  for (const int n : {17, 33, 65, 101, 257, 513, 1025}) {
    addCloth(suite, sized("grid", n), n, grid);
  }
  for (const int n : {101, 1025}) {
    addCloth(suite, sized("numbered at random", n), n, shuffledGrid);
    addCloth(suite, sized("irregular sheet", n), n, irregularSheet);
  }
  const auto ratio = [&](const std::string& over, const std::string& under, double bound) {
    suite.addRatio({"size", over + " / " + under, "size/" + over, "size/" + under, Bound{Bound::Side::AtMost, bound}});
  };
  ratio("grid 1025x1025", "grid 101x101", 1.5);
  for (const int n : {101, 1025}) {
    ratio(sized("numbered at random", n), sized("grid", n), 2.0);
    ratio(sized("irregular sheet", n), sized("grid", n), 2.0);
  }
}

}  // namespace drape::bench
