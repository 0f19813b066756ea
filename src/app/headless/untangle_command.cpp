#include "sim/stepping/untangling.hpp"

#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/output_file.hpp"
#include "app/progress_line.hpp"
#include "app/used_files.hpp"
#include "intersection/intersections.hpp"
#include "io/obj_writer.hpp"
#include "messages/error.hpp"
#include "sim/model/cloth_model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct UntangleArguments {
  SceneArguments scene;
  std::string output;
  double maxSeconds = 20.0;
};

/// The positions as an OBJ file has them: with six decimals.
std::vector<Vec3> roundedToFile(std::vector<Vec3> positions) {
  constexpr double perMetre = 1e6;
  for (Vec3& position : positions) {
    position = (perMetre * position.array()).round() / perMetre;
  }
  return positions;
}

std::vector<intersection::TrianglePair> intersectingPairsIn(const sim::ClothModel& model,
                                                            const std::vector<Vec3>& positions) {
  return intersection::intersectingPairs({roundedToFile(positions), model.triangles});
}

/// "12 pairs of triangles".
std::string pairsText(std::size_t pairs) {
  return fmt::format("{} {} of triangles", pairs, pairs == 1 ? "pair" : "pairs");
}

/// Moves the cloth until the exact intersection test finds nothing, or the time is over.
/// @return the number of pairs that remain
std::size_t untangle(sim::Untangling& untangling, const sim::ClothModel& model, std::size_t pairs, double maxSeconds) {
  ProgressLine progress;
  const std::size_t before = pairs;
  while (pairs > 0 && untangling.time() < maxSeconds) {
    untangling.step();
    if (untangling.isDone() || untangling.time() + sim::Untangling::stepSeconds > maxSeconds) {
      pairs = intersectingPairsIn(model, untangling.positions()).size();
    }
    progress.show(fmt::format("untangling {}", pairsText(before)), untangling.time(), maxSeconds);
  }
  return pairs;
}

/// "vertices moved by 0.2 mm on average and 4.1 mm at most".
std::string motionText(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
  double sum = 0.0;
  double max = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    const double moved = (after[v] - before[v]).norm();
    sum += moved;
    max = std::max(max, moved);
  }
  constexpr double mmPerMetre = 1000.0;
  return fmt::format("vertices moved by {:.1f} mm on average and {:.1f} mm at most",
                     mmPerMetre * sum / static_cast<double>(before.size()), mmPerMetre * max);
}

void requireObjName(const std::filesystem::path& file) {
  if (file.extension() != ".obj") {
    throw messages::UsageError("the output '" + file.string() + "' must be a file with the extension .obj");
  }
}

void run(const UntangleArguments& arguments) {
  requireObjName(arguments.output);
  const auto scene = arguments.scene.load();
  const std::vector<Vec3>& start = scene->start.positions;
  UsedFiles(*scene).write(arguments.output, "the output");
  OutputFile file(arguments.output, "the mesh");
  const auto free = withPins(*scene->model, std::vector<bool>(start.size(), false));
  const std::vector<intersection::TrianglePair> pairs = intersectingPairsIn(*free, start);
  const std::size_t before = pairs.size();
  sim::Untangling untangling(withSprings(*free), start, scene->settings.step);
  untangling.openFlatLayers(pairs);
  const std::size_t after = untangle(untangling, *free, before, arguments.maxSeconds);
  file.writeText(io::objText(untangling.positions(), scene->renderMesh, "Untangled by Drape; metres, y is up"));
  if (after > 0) {
    throw messages::InputError(fmt::format(
        "{} of {} still intersect after {:.2g} s; {} has the positions at that time. Try a larger --max-seconds, or a "
        "smaller thickness (--set cloth_thickness=0.001).",
        after, pairsText(before), untangling.time(), arguments.output));
  }
  std::cout << arguments.output << ": "
            << (before == 0 ? "no triangles intersected; the shape is unchanged"
                            : fmt::format("{} intersected, now none; {}", pairsText(before),
                                          motionText(start, untangling.positions())))
            << '\n';
}

}  // namespace

void addUntangleCommand(CLI::App& app) {
  constexpr double longest = 1e4;  // [s]
  auto arguments = std::make_shared<UntangleArguments>();
  CLI::App* command = app.add_subcommand("untangle", "Removes the intersections of a garment with itself");
  arguments->scene.addTo(*command);
  command->add_option("output", arguments->output, "The mesh without intersections (OBJ, metres, y is up)")
      ->type_name("OUT.obj")
      ->required()
      ->check(notEmpty());
  command->add_option("--max-seconds", arguments->maxSeconds, "Stop after this simulated time [s]")
      ->check(numberFrom(0.01, longest));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace drape::app
