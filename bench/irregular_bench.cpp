// A garment and an irregular sheet, against a grid with about as many springs.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

namespace drape::bench {
namespace {

constexpr int batch = 20;
constexpr int likeTshirt = 53;  // a grid with 8216 springs

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
  addCloth(suite, "grid 53x53", [] { return grid(likeTshirt); });
  addCloth(suite, "T-shirt", tshirt);
  addCloth(suite, "irregular sheet 53x53", [] { return irregularSheet(likeTshirt); });
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
