#include "scene/mesh_reading.hpp"

#include "scene/boundary_loops.hpp"
#include "scene/mesh_placement.hpp"
#include "scene/unit_guess.hpp"
#include "scene/up_guess.hpp"
#include "sim/model/bounds.hpp"
#include "sim/model/enclosed_volume.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace drape::scene {
namespace {

constexpr std::string_view guessed = "auto";

double largestOf(const std::array<double, 3>& size) {
  return *std::max_element(size.begin(), size.end());
}

/// Whether this is a plausible size of cloth, also of a curtain or a patch.
bool isUsualSize(double metres) {
  return metres >= 0.25 * smallestGarment && metres <= 2.0 * largestGarment;
}

void scale(io::ImportedMesh& mesh, double factor) {
  for (Vec3& position : mesh.cloth.positions) {
    position *= factor;
  }
  if (mesh.render.uvsInMetres) {
    for (Vec2& uv : mesh.render.uvs) {
      uv *= factor;
    }
  }
  for (double& extent : mesh.summary.size) {
    extent *= factor;
  }
}

void turn(io::ImportedMesh& mesh, const std::string& up) {
  for (Vec3& position : mesh.cloth.positions) {
    position = turnedUpright(position, up);
  }
  const Vec3 size =
      turnedUpright(Vec3(mesh.summary.size[0], mesh.summary.size[1], mesh.summary.size[2]), up).cwiseAbs();
  mesh.summary.size = {size.x(), size.y(), size.z()};
}

/// The unit of the reading, and plausible alternatives.
void readUnit(const std::string& choice, const ReadingEvidence& evidence, io::MeshUse use, MeshReading& reading) {
  const double largestExtent = evidence.extent.maxCoeff();
  const std::optional<double>& prescribed = evidence.format.metresPerUnit;
  const UnitGuess guess = guessUnit(largestExtent, use, evidence.fullness);
  const bool shows = guess.isUsual && !(use == io::MeshUse::Cloth && isFlat(evidence.extent));
  reading.unitReason = choice != guessed ? ReadingReason::Chosen
                       : prescribed      ? ReadingReason::Format
                       : shows           ? ReadingReason::Shape
                                         : ReadingReason::Unknown;
  reading.unit = choice != guessed ? choice : prescribed ? wordForUnit(*prescribed) : guess.unit;
  reading.metresPerUnit = metresPerUnit(reading.unit);
  if (!isGuess(reading.unitReason) && isUsualSize(reading.metresPerUnit * largestExtent)) {
    return;
  }
  constexpr std::size_t maxAlternatives = 3;
  std::vector<std::string> others{guess.unit};
  others.insert(others.end(), guess.others.begin(), guess.others.end());
  others.emplace_back("m");  // the coordinates taken as they are
  for (const std::string& unit : others) {
    const bool known = std::any_of(reading.alternatives.begin(), reading.alternatives.end(),
                                   [&](const ReadingAlternative& each) { return each.value == unit; });
    if (!known && unit != reading.unit && reading.alternatives.size() < maxAlternatives) {
      reading.alternatives.push_back({"unit", unit});
    }
  }
}

void readUp(const std::string& choice, const ReadingEvidence& evidence, MeshReading& reading) {
  if (choice != guessed || evidence.format.up) {
    reading.upReason = choice != guessed ? ReadingReason::Chosen : ReadingReason::Format;
    reading.up = choice != guessed ? choice : std::string(1, *evidence.format.up);
    return;
  }
  const std::string shown = evidence.upOfShape();
  reading.upReason = shown.empty() ? ReadingReason::Unknown : ReadingReason::Shape;
  reading.up = shown.empty() ? "y" : shown;
  for (const char* axis : {"y", "z"}) {
    if (reading.up != axis) {
      reading.alternatives.push_back({"up", axis});
    }
  }
}

/// Two decimals for the sizes of garments, otherwise three digits.
std::string lengthText(double metres) {
  const bool usual = metres >= 0.1 && metres < 10.0;
  return usual ? fmt::format("{:.2f} m", metres) : fmt::format("{:.3g} m", metres);
}

}  // namespace

double metresPerUnitOf(const settings::Settings::Mesh& settings) {
  return settings.unit == guessed ? 1.0 : metresPerUnit(settings.unit);
}

std::string upOfShape(const sim::ClothMesh& mesh) {
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  const UpGuess guess = guessUp(mesh, findPieces(mesh));
  return guess.margin > 0.0 ? axes[static_cast<std::size_t>(guess.axis)] : "";
}

double fullnessOf(const sim::ClothMesh& mesh) {
  const Eigen::AlignedBox3d box = sim::boundsOf(mesh.positions);
  const double volume = sim::enclosedVolume(mesh.positions, mesh.triangles, box.center());
  const double largest = mesh.positions.empty() ? 0.0 : box.sizes().maxCoeff();
  return largest > 0.0 ? std::abs(volume) / (largest * largest * largest) : 0.0;
}

MeshReading readingOf(const ReadingEvidence& evidence, const ReadingChoice& choice, io::MeshUse use) {
  MeshReading reading;
  readUnit(choice.unit, evidence, use, reading);
  readUp(choice.up, evidence, reading);
  const Vec3 size = reading.metresPerUnit * turnedUpright(evidence.extent, reading.up).cwiseAbs();
  reading.size = {size.x(), size.y(), size.z()};
  return reading;
}

MeshReading readUpright(const settings::Settings::Mesh& settings, io::ImportedMesh& mesh, io::MeshUse use) {
  const std::array<double, 3>& size = mesh.summary.size;
  const ReadingEvidence evidence{mesh.format, Vec3(size[0], size[1], size[2]) / metresPerUnitOf(settings),
                                 [&] { return upOfShape(mesh.cloth); },
                                 use == io::MeshUse::Body ? fullnessOf(mesh.cloth) : 0.0};
  MeshReading reading = readingOf(evidence, {settings.unit, settings.up}, use);
  if (settings.unit == guessed) {
    scale(mesh, reading.metresPerUnit);
  }
  if (reading.up != "y") {
    turn(mesh, reading.up);
  }
  reading.size = mesh.summary.size;
  return reading;
}

Vec3 rotationToY(std::string_view up) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  if (up == "x") {
    return {0.0, 0.0, quarter};
  }
  return {up == "z" ? -quarter : up == "-z" ? quarter : up == "-y" ? 2.0 * quarter : 0.0, 0.0, 0.0};
}

text::Sentence inWords(const MeshReading& reading) {
  // For a sheet that lies flat, the larger side is more informative than its height.
  const bool flat = reading.size[1] < 0.05 * largestOf(reading.size);
  const text::Sentence size = flat ? text::Sentence("{} x {}", lengthText(reading.size[0]), lengthText(reading.size[2]))
                                   : text::Sentence("{} tall", lengthText(reading.size[1]));
  return text::Sentence("Read as {}, {} up: {}.", unitInWords(reading.unit), reading.up, size);
}

}  // namespace drape::scene
