#pragma once

#include "app/output_file.hpp"
#include "io/animation/animation.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drape::app {

/// The coordinates of an export.
enum class ExportCoordinates {
  File,  ///< of the mesh file of each cloth: its unit, its axes, its own position
  Scene  ///< metres, y up, as the scene is drawn
};

/// The name of a cloth in exported files: letters, digits, "_", "-" and ".". A scene of one cloth gives its own name.
[[nodiscard]] std::string exportedName(const scene::Scene& scene, const scene::ClothPart& cloth);

/// Whether a format can hold the coordinates of the mesh file: it does not prescribe its own, and knows the up axis.
[[nodiscard]] bool canHoldFileCoordinates(const scene::Scene& scene, const io::animation::Format& format);

/// The coordinates of an export without a choice of the user: those of the mesh file, unless there are several cloths
/// or the format cannot hold them.
/// @param cloths their number in the file
[[nodiscard]] ExportCoordinates usualCoordinates(const scene::Scene& scene, const io::animation::Format& format,
                                                 std::size_t cloths);

/// The cloths of a scene as objects of an animation, with unit and up axis.
/// @param cloths indices into the cloths of the scene
[[nodiscard]] io::animation::Clip clipOf(const scene::Scene& scene, const std::vector<std::size_t>& cloths,
                                         ExportCoordinates coordinates);

/// The vertices of the mesh file of a cloth: each is where its vertex of the cloth is. Those that are not part of the
/// cloth stay where the file has them.
/// @param model of the scene  @param positions of the model [m]
[[nodiscard]] io::animation::Shape exportedShape(const sim::ClothModel& model, const std::vector<Vec3>& positions,
                                                 const scene::ClothPart& cloth, ExportCoordinates coordinates);

/// Writes all cloths of a scene to a file, in one frame. Throws UsageError when the format is unknown or cannot
/// hold several cloths, and InputError when the file exists and may not be replaced, or cannot be written.
/// @param model, positions of the cloth [m]
void exportFrame(const scene::Scene& scene, const sim::ClothModel& model, const std::vector<Vec3>& positions,
                 const std::filesystem::path& file, Existing existing = Existing::Refused);

}  // namespace drape::app
