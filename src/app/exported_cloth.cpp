#include "app/exported_cloth.hpp"

#include "messages/error.hpp"
#include "sim/model/normals.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace drape::app {
namespace {

/// The up axis for formats that know only y and z.
bool canBeNamed(const std::string& up) {
  return up == "y" || up == "z";
}

/// The name with letters, digits, "_", "-" and "." only.
std::string plainName(std::string name) {
  std::ranges::replace_if(
      name,
      [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string_view("_-.").find(c) == std::string::npos;
      },
      '_');
  return name.empty() ? "cloth" : name;
}

}  // namespace

bool canHoldFileCoordinates(const scene::Scene& scene, const io::animation::Format& format) {
  return !format.isInMetres && (format.extension != "usda" || canBeNamed(scene.cloths.front().placement.up));
}

ExportCoordinates usualCoordinates(const scene::Scene& scene, const io::animation::Format& format, std::size_t cloths) {
  const bool isOne = scene.cloths.size() == 1 || cloths == 1;
  return isOne && canHoldFileCoordinates(scene, format) ? ExportCoordinates::File : ExportCoordinates::Scene;
}

std::string exportedName(const scene::Scene& scene, const scene::ClothPart& cloth) {
  return plainName(cloth.name.empty() ? scene.description.name : cloth.name);
}

io::animation::Clip clipOf(const scene::Scene& scene, const std::vector<std::size_t>& cloths,
                           ExportCoordinates coordinates) {
  io::animation::Clip clip;
  for (const std::size_t index : cloths) {
    const scene::ClothPart& cloth = scene.cloths[index];
    clip.objects.push_back({exportedName(scene, cloth), cloth.file});
  }
  const scene::MeshPlacement& placement = scene.cloths[cloths.front()].placement;
  if (coordinates == ExportCoordinates::File) {
    clip.metresPerUnit = placement.metresPerUnit;
    clip.up = canBeNamed(placement.up) ? placement.up.front() : 'y';
  }
  clip.comment =
      "Made with Drape from " + (cloths.size() > 1 ? plainName(scene.description.name) : clip.objects.front().name);
  return clip;
}

io::animation::Shape exportedShape(const sim::ClothModel& model, const std::vector<Vec3>& positions,
                                   const scene::ClothPart& cloth, ExportCoordinates coordinates) {
  const bool inFile = coordinates == ExportCoordinates::File;
  std::vector<Vec3> normals;
  for (int v = 0; v < cloth.vertexCount; ++v) {
    const Vec3 normal = sim::vertexNormal(model, positions, cloth.firstVertex + v);
    normals.push_back(normal.isZero() ? Vec3(Vec3::UnitY()) : normal);
  }
  io::animation::Shape shape;
  for (std::size_t v = 0; v < cloth.file->particle.size(); ++v) {
    const int particle = cloth.file->particle[v];
    const Vec3 place =
        particle < 0 ? cloth.placement.toScene(cloth.file->positions[v]) : positions[cloth.firstVertex + particle];
    const Vec3 normal = particle < 0 ? Vec3(Vec3::UnitY()) : normals[particle];
    shape.positions.push_back(inFile ? cloth.placement.toFile(place) : place);
    shape.normals.push_back(inFile ? cloth.placement.directionInFile(normal) : normal);
  }
  return shape;
}

void exportFrame(const scene::Scene& scene, const sim::ClothModel& model, const std::vector<Vec3>& positions,
                 const std::filesystem::path& file, Existing existing) {
  const io::animation::Format& format = io::animation::formatOf(file);
  if (scene.cloths.size() > 1 && !format.holdsObjects) {
    throw messages::UsageError("the scene has " + std::to_string(scene.cloths.size()) + " cloths, and a ." +
                               std::string(format.extension) + " file holds one mesh; choose .obj or .glb");
  }
  requireFree(file, existing);
  std::vector<std::size_t> all(scene.cloths.size());
  std::iota(all.begin(), all.end(), 0);
  const ExportCoordinates coordinates = usualCoordinates(scene, format, all.size());
  const auto writer = io::animation::makeWriter([&](int) { return file; }, clipOf(scene, all, coordinates));
  io::animation::Frame frame;
  for (const scene::ClothPart& cloth : scene.cloths) {
    frame.push_back(exportedShape(model, positions, cloth, coordinates));
  }
  writer->add(frame);
  writer->finish();
}

}  // namespace drape::app
