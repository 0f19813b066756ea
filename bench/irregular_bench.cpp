// A garment and an irregular sheet, compared with a grid. Times are per spring.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

namespace drape::bench {
namespace {

constexpr int batch = 20;
constexpr int side = 53;  // a grid with 8216 springs

void addCloth(Suite& suite, const char* name, ModelPtr (*make)()) {
  const auto add = [&](const char* what, sim::StepParameters (*parameters)()) {
    suite.add({"irregular", std::string(name) + what, "ns/(spring step)"}, [=]() -> Batch {
      auto runner = std::make_shared<SliceRunner<float>>(make(), Method::OneIteration, parameters());
      return {batch * static_cast<double>(runner->model().springs.size()),
              [runner] { return batchSeconds(*runner, batch); }};
    });
  };
  add("", fullStep);
  add(", without air and damping", stillAir);
}

}  // namespace

void addIrregularGroup(Suite& suite) {
  addCloth(suite, "grid 53x53", [] { return grid(side); });
  addCloth(suite, "T-shirt", tshirt);
  addCloth(suite, "irregular sheet 53x53", [] { return irregularSheet(side); });
  const Bound bound{Bound::Side::AtMost, 1.9};
  for (const char* name : {"T-shirt", "irregular sheet 53x53"}) {
    for (const char* what : {"", ", without air and damping"}) {
      const std::string over = std::string(name) + what;
      suite.addRatio(
          {"irregular", over + " / grid", "irregular/" + over, "irregular/grid 53x53" + std::string(what), bound});
    }
  }
}

}  // namespace drape::bench
