#pragma once

#include "io/clip_facts.hpp"
#include "scene/mesh_reading.hpp"
#include "text/sentence.hpp"

#include <string>
#include <vector>

namespace drape::scene {

/// What a mesh file contains, before it becomes a part of a scene: for the user to check.
struct FoundMesh {
  io::FormatFacts format = {};
  Vec3 extent = Vec3::Zero();  ///< of the box around it, in the axes and the unit of the file
  std::string upOfShape;       ///< the up axis by its shape; empty where the shape does not show it
  double fullness = 0.0;       ///< see fullnessOf
  int pieces = 0;              ///< that are connected by edges
  int vertices = 0;            ///< after the weld
  int triangles = 0;
  std::vector<io::ClipFacts> clips = {};  ///< that can move it as a body
  bool isOnlyAnimation = false;           ///< see io::isOnlyAnimationFile
};

/// @param mesh imported with one metre per unit
[[nodiscard]] FoundMesh foundIn(const io::ImportedMesh& mesh);

/// Reads a garment or a body: a mesh file, a file with a skeletal animation, or a built-in one, see isBuiltInWear.
/// Throws InputError as importMesh and importAnimation, and Cancelled. Vertices far from all others are left out.
[[nodiscard]] FoundMesh findMesh(const std::string& file, const io::ImportWatch& watch = {});

/// Unit, up axis and size of a mesh that is read so.
[[nodiscard]] MeshReading readingOf(const FoundMesh& found, const ReadingChoice& choice, io::MeshUse use);

/// The same for a body beside a cloth: where the body is no person, its unit is that of the cloth, and so is its up
/// axis where its shape shows none.
[[nodiscard]] MeshReading readingBeside(const FoundMesh& found, const ReadingChoice& choice, const MeshReading& cloth);

/// "0.52 x 0.77 x 0.25 m (width x height x depth)".
[[nodiscard]] text::Sentence sizeInWords(const MeshReading& reading);

/// "3 pieces, 1204 vertices, 2310 triangles".
[[nodiscard]] text::Sentence countsInWords(const FoundMesh& found);

/// Why it has that unit: "the size of a garment".
[[nodiscard]] text::Sentence unitReasonInWords(const FoundMesh& found, const MeshReading& reading, io::MeshUse use);

/// Why that axis is up: "by its shape".
[[nodiscard]] text::Sentence upReasonInWords(const MeshReading& reading);

/// All of that, one fact a line.
[[nodiscard]] std::vector<text::Sentence> inWords(const FoundMesh& found, const MeshReading& reading, io::MeshUse use);

}  // namespace drape::scene
