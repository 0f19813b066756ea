#include "scene/found_mesh.hpp"

#include "io/animation_import.hpp"
#include "scene/garment_on_body.hpp"
#include "scene/mesh_file.hpp"
#include "scene/unit_guess.hpp"
#include "scene/up_guess.hpp"

#include <fmt/core.h>

namespace drape::scene {

using text::Sentence;

FoundMesh foundIn(const io::ImportedMesh& mesh) {
  const std::array<double, 3>& size = mesh.summary.size;
  return {.format = mesh.format,
          .extent = Vec3(size[0], size[1], size[2]),
          .upOfShape = upOfShape(mesh.cloth),
          .fullness = fullnessOf(mesh.cloth),
          .pieces = mesh.summary.components,
          .vertices = mesh.summary.vertices,
          .triangles = mesh.summary.triangles,
          .clips = {}};
}

namespace {

/// The clips in a file that is read as a mesh, too. What is wrong with them does no harm to the mesh.
std::vector<io::ClipFacts> clipsBeside(const std::string& file, const io::ImportOptions& options) {
  try {
    return io::importBindPose(file, options).clips;
  } catch (const messages::InputError&) {
    return {};
  }
}

}  // namespace

FoundMesh findMesh(const std::string& file, const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.use = io::MeshUse::Body;  // any size
  options.outliers = io::OutlierRule::LeaveOut;
  options.watch = watch;
  const MeshFileSource source = wearSource(file);
  if (!source.builtIn && io::isOnlyAnimationFile(file)) {
    io::BindPose pose = io::importBindPose(file, options);
    FoundMesh found = foundIn(pose.mesh);
    found.clips = std::move(pose.clips);
    found.isOnlyAnimation = true;
    return found;
  }
  io::ImportedMesh mesh = readMesh(source, options);
  if (source.builtIn) {
    mesh.format = {1.0, 'y'};
  }
  FoundMesh found = foundIn(mesh);
  if (mesh.summary.hasSkin) {
    found.clips = clipsBeside(file, options);
  }
  return found;
}

MeshReading readingOf(const FoundMesh& found, const ReadingChoice& choice, io::MeshUse use) {
  return readingOf({found.format, found.extent, [&] { return found.upOfShape; }, found.fullness}, choice, use);
}

MeshReading readingBeside(const FoundMesh& found, const ReadingChoice& choice, const MeshReading& cloth) {
  MeshReading own = readingOf(found, choice, io::MeshUse::Body);
  const bool isUnitUnknown = own.unitReason == ReadingReason::Unknown;
  const bool isUpUnknown = own.upReason == ReadingReason::Unknown;
  if (!isUnitUnknown && !isUpUnknown) {
    return own;
  }
  MeshReading reading = readingOf(found, {isUnitUnknown ? cloth.unit : choice.unit, isUpUnknown ? cloth.up : choice.up},
                                  io::MeshUse::Body);
  reading.unitReason = isUnitUnknown ? ReadingReason::LikeCloth : own.unitReason;
  reading.upReason = isUpUnknown ? ReadingReason::LikeCloth : own.upReason;
  return reading;
}

Sentence sizeInWords(const MeshReading& reading) {
  return Sentence("{} m (width x height x depth)",
                  fmt::format("{:.3g} x {:.3g} x {:.3g}", reading.size[0], reading.size[1], reading.size[2]));
}

Sentence countsInWords(const FoundMesh& found) {
  return Sentence(
      text::plural(found.pieces, "{} piece, {} vertices, {} triangles", "{} pieces, {} vertices, {} triangles"),
      found.pieces, found.vertices, found.triangles);
}

Sentence unitReasonInWords(const FoundMesh& found, const MeshReading& reading, io::MeshUse use) {
  switch (reading.unitReason) {
    case ReadingReason::Chosen:
      return Sentence("chosen");
    case ReadingReason::Format:
      return Sentence("as the file format prescribes");
    case ReadingReason::Shape:
      return use != io::MeshUse::Body  ? Sentence("the size of a garment")
             : isTorso(found.fullness) ? Sentence("the size of a torso")
                                       : Sentence("the size of a person");
    case ReadingReason::LikeCloth:
      return Sentence("a guess: as for the cloth");
    case ReadingReason::Unknown:
      break;
  }
  return use == io::MeshUse::Cloth && isFlat(found.extent) ? Sentence("a guess: a flat sheet can have any size")
                                                           : Sentence("a guess: no unit gives a usual size");
}

Sentence upReasonInWords(const MeshReading& reading) {
  switch (reading.upReason) {
    case ReadingReason::Chosen:
      return Sentence("chosen");
    case ReadingReason::Format:
      return Sentence("as the file format prescribes");
    case ReadingReason::Shape:
      return Sentence("by its shape");
    case ReadingReason::LikeCloth:
      return Sentence("a guess: as for the cloth");
    case ReadingReason::Unknown:
      break;
  }
  return Sentence("a guess: its shape does not show it");
}

std::vector<Sentence> inWords(const FoundMesh& found, const MeshReading& reading, io::MeshUse use) {
  return {Sentence("size: {}", sizeInWords(reading)),
          Sentence("unit: {} ({})", unitInWords(reading.unit), unitReasonInWords(found, reading, use)),
          Sentence("up axis: {} ({})", reading.up, upReasonInWords(reading)), countsInWords(found)};
}

}  // namespace drape::scene
