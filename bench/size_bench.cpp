// The cost of a spring in a small cloth and in one that is larger than all caches.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

#include <algorithm>

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

/// Smallest memory traffic of a step on a large grid: it reads positions, velocities, masses, areas, pins, rest lengths
/// and the layout (70 bytes a vertex), and writes p_i, positions and velocities (36 bytes, and 12 read before p_i is
/// overwritten).
constexpr double bytesPerVertex = 118.0;

/// A loop with the same memory traffic as a step on the largest grid and almost no arithmetic.
Batch stream(int n) {
  struct Arrays {
    std::vector<float> a, b, c;
  };
  // Two reads, one write and the read before it: 16 bytes an element.
  const double elements = bytesPerVertex * n * n / 16.0;
  const auto size = static_cast<std::size_t>(elements);
  auto arrays = std::make_shared<Arrays>(
      Arrays{std::vector<float>(size, 1.0F), std::vector<float>(size, 2.0F), std::vector<float>(size, 3.0F)});
  return {springsOf(n), [arrays] {
            return threadSeconds([&] {
              for (std::size_t i = 0; i < arrays->a.size(); ++i) {
                arrays->a[i] = arrays->b[i] + 1.5F * arrays->c[i];
              }
            });
          }};
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
  const std::string memoryFloor = "118 bytes a vertex streamed, 1025x1025";
  suite.add({"size", memoryFloor, "ns/(spring step)"}, [] { return stream(1025); });
  suite.addRatio({"size", "grid 1025x1025 / memory floor", "size/grid 1025x1025", "size/" + memoryFloor});
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
