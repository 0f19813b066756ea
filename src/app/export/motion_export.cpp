#include "app/export/motion_export.hpp"

#include "app/command_line.hpp"
#include "app/export/frame_name.hpp"
#include "app/export/frame_rate.hpp"
#include "app/export/output_name.hpp"
#include "app/output_file.hpp"
#include "messages/error.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <iostream>
#include <numeric>
#include <utility>

namespace drape::app {

using io::animation::Format;
using io::animation::Frame;

struct MotionExport::Output {
  std::string name;  ///< for messages
  std::vector<std::size_t> cloths;
  ExportCoordinates coordinates = ExportCoordinates::Scene;
  bool isSequence = false;       ///< otherwise it holds the last state only
  bool isFrameSequence = false;  ///< a sequence with a file for each frame
  std::unique_ptr<io::animation::Writer> writer;
  std::size_t vertices = 0;
  int frames = 0;

  void add(const session::Simulation& simulation, const std::vector<Vec3>& positions) {
    Frame frame;
    for (const std::size_t cloth : cloths) {
      frame.push_back(
          exportedShape(*simulation.cloth().pieces(), positions, simulation.scene().cloths[cloth], coordinates));
    }
    writer->add(frame);
    ++frames;
  }
};

namespace {

constexpr std::string_view frameWord = "{frame";
constexpr std::string_view clothWord = "{cloth}";

bool isSequence(const std::string& file) {
  return io::animation::formatOf(file).holdsFrames || file.find(frameWord) != std::string::npos;
}

/// The coordinates of an export: those of the file, unless the scene has several cloths or the format has its own.
ExportCoordinates coordinatesFor(const std::string& chosen, const Format& format, const std::string& file,
                                 const session::Simulation& simulation, std::size_t cloths) {
  if (format.isInMetres) {
    if (chosen == "file") {
      std::cerr << "note: " << file << " is in metres, y up, as its format prescribes\n";
    }
    return ExportCoordinates::Scene;
  }
  if (chosen.empty()) {
    return usualCoordinates(simulation.scene(), format, cloths);
  }
  return chosen == "file" && canHoldFileCoordinates(simulation.scene(), format) ? ExportCoordinates::File
                                                                                : ExportCoordinates::Scene;
}

}  // namespace

void ExportArguments::addTo(CLI::App& app) {
  app.add_option("--export", files,
                 "Write the cloth to a file: .obj, .ply, .pc2, .mdd, .glb, .usda, .csv; may be repeated")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  app.add_option("--rate", rate, "Frames per second of exports; default 30")
      ->check(numberFrom(minFrameRate, maxFrameRate));
  app.add_option("--coordinates", coordinates,
                 "Of exports: those of the mesh file, or of the scene (metres, y up); default: file for one cloth")
      ->check(CLI::IsMember({"file", "scene"}));
}

bool ExportArguments::hasFrames() const {
  return std::ranges::any_of(files, isSequence);
}

double ExportArguments::frameRate() const {
  return rate.value_or(usualFrameRate);
}

MotionExport::MotionExport(const ExportArguments& arguments, const session::Simulation& simulation, std::int64_t steps)
    : arguments_(arguments) {
  if (arguments.hasFrames()) {
    stepsPerFrame_ = stepsPerFrame(arguments.frameRate(), simulation.settings().step.timeStep);
    constexpr std::int64_t maxFrames = 1000000000;
    const std::int64_t now = simulation.stepIndex();
    const std::int64_t first = (now + stepsPerFrame_ - 1) / stepsPerFrame_;
    frames_.first = static_cast<int>(std::min(first, maxFrames));
    frames_.count =
        static_cast<int>(std::clamp<std::int64_t>((now + steps) / stepsPerFrame_ - first + 1, 1, maxFrames));
  }
  open(simulation);
  sample(simulation);
}

MotionExport::MotionExport(ExportArguments arguments, const session::Simulation& simulation, FrameRange frames)
    : arguments_(std::move(arguments)), frames_(frames) {
  open(simulation);
}

void MotionExport::open(const session::Simulation& simulation) {
  for (const std::string& file : arguments_.files) {
    add(withSettings(file, simulation.settings()), simulation);
  }
}

MotionExport::~MotionExport() = default;

/// A file for all cloths, or one for each.
void MotionExport::add(const std::string& file, const session::Simulation& simulation) {
  const Format& format = io::animation::formatOf(file);
  const std::vector<scene::ClothPart>& cloths = simulation.scene().cloths;
  if (file.find(clothWord) == std::string::npos) {
    if (cloths.size() > 1 && !format.holdsObjects) {
      throw messages::UsageError("--export " + file + ": the scene has " + std::to_string(cloths.size()) +
                                 " cloths, and a ." + std::string(format.extension) +
                                 " file holds one mesh; write one file for each with {cloth} in the name");
    }
    std::vector<std::size_t> all(cloths.size());
    std::iota(all.begin(), all.end(), 0);
    addOutput(file, all, simulation);
    return;
  }
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    addOutput(withCloth(file, exportedName(simulation.scene(), cloths[i])), {i}, simulation);
  }
}

void MotionExport::addOutput(const std::string& file, const std::vector<std::size_t>& cloths,
                             const session::Simulation& simulation) {
  const Format& format = io::animation::formatOf(file);
  Output output;
  output.name = file;
  output.cloths = cloths;
  output.isSequence = isSequence(file);
  output.coordinates = coordinatesFor(arguments_.coordinates, format, file, simulation, cloths.size());
  output.isFrameSequence = output.isSequence && !format.holdsFrames;
  const FramePattern pattern(file, output.isFrameSequence ? frames_.count : 1, "--export");
  if (const auto folder = std::filesystem::path(pattern.name(0)).parent_path(); !folder.empty()) {
    makeFolder(folder);
  }
  io::animation::Clip clip = clipOf(simulation.scene(), cloths, output.coordinates);
  clip.rate = arguments_.frameRate();
  clip.firstFrame = output.isSequence ? frames_.first : 0;
  clip.frames = output.isSequence ? frames_.count : 1;
  for (const io::animation::Object& object : clip.objects) {
    output.vertices += object.mesh->positions.size();
  }
  output.writer = io::animation::makeWriter([pattern](int frame) { return pattern.name(frame); }, clip);
  outputs_.push_back(std::move(output));
}

void MotionExport::sample(const session::Simulation& simulation) {
  if (simulation.blewUp() || simulation.stepIndex() % stepsPerFrame_ != 0) {
    return;
  }
  addFrame(simulation, simulation.state().positions);
}

void MotionExport::addFrame(const session::Simulation& simulation, const std::vector<Vec3>& positions) {
  for (Output& output : outputs_) {
    if (output.isSequence) {
      output.add(simulation, positions);
    }
  }
}

void MotionExport::finish(const session::Simulation& simulation, const std::vector<Vec3>& last) {
  for (Output& output : outputs_) {
    if (!output.isSequence) {
      output.add(simulation, last);
    }
    if (output.frames > 0) {
      output.writer->finish();
    }
  }
}

std::vector<std::filesystem::path> MotionExport::files() const {
  std::vector<std::filesystem::path> names;
  for (const Output& output : outputs_) {
    const int frames = output.isFrameSequence ? frames_.count : 1;
    const FramePattern pattern(output.name, frames, "--export");
    for (int frame = 0; frame < frames; ++frame) {
      names.emplace_back(pattern.name(frames_.first + frame));
    }
  }
  return names;
}

std::vector<std::string> MotionExport::summary() const {
  std::vector<std::string> lines;
  for (const Output& output : outputs_) {
    lines.push_back(fmt::format("{}: {} vertices, {}", output.name, output.vertices,
                                output.isSequence
                                    ? fmt::format("{} {}", output.frames, output.frames == 1 ? "frame" : "frames")
                                    : "the last state"));
  }
  return lines;
}

}  // namespace drape::app
