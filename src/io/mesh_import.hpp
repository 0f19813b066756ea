#pragma once

#include "sim/cloth_model.hpp"
#include "sim/vector.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// A mesh as a file holds it, after triangulation: a vertex is split wherever its texture coordinates differ.
struct RawMesh {
  std::vector<Vec3> positions;      ///< in the file's unit
  std::vector<Vec2> uvs;            ///< one a position, or empty when the file has none
  std::vector<Triangle> triangles;  ///< indices into positions
  int facesSkipped = 0;             ///< points and lines, which a cloth has no use for
};

/// What a mesh is drawn from: vertices split at texture seams, each riding on a particle of the cloth.
struct RenderMesh {
  std::vector<int> particle;        ///< for each render vertex the cloth vertex that carries it
  std::vector<Vec2> uvs;            ///< one a render vertex
  std::vector<Triangle> triangles;  ///< indices into `particle`; triangle t is the cloth's triangle t
};

/// What was found in a mesh and done to it.
struct MeshSummary {
  std::string source;      ///< file name or "grid"
  int verticesInFile = 0;  ///< after the import, split at seams
  int vertices = 0;        ///< particles after the weld
  int triangles = 0;
  int springs = 0;               ///< edges
  int degenerateFaces = 0;       ///< dropped: no area
  int duplicateFaces = 0;        ///< dropped: the same three vertices as an earlier face
  int facesSkipped = 0;          ///< dropped: points and lines
  int isolatedVertices = 0;      ///< dropped: used by no face
  int components = 0;            ///< pieces that hang together by edges
  int boundaryLoops = 0;         ///< closed chains of edges with one face
  int nonManifoldEdges = 0;      ///< edges with more than two faces
  int misorientedEdges = 0;      ///< edges whose two faces run in the same direction
  std::array<double, 3> size{};  ///< extent of the bounding box [m]
  std::vector<std::string> warnings;
};

/// What the specification of a file format says about coordinates. Empty where it leaves them to the author, as OBJ,
/// PLY and STL do.
struct FormatFacts {
  std::optional<double> metresPerUnit;  ///< length of the file's unit [m]
  std::optional<char> up;               ///< the axis that points up: 'x', 'y' or 'z'
};

/// A mesh ready to become a cloth.
struct ImportedMesh {
  ClothMesh cloth;
  RenderMesh render;
  MeshSummary summary;
  FormatFacts format;
};

/// How to read a mesh.
struct ImportOptions {
  double metresPerUnit = 1.0;
  double weldTolerance = 1e-6;  ///< vertices nearer than this times the bounding box's diagonal become one particle
  double timeLimit = 0.0;       ///< reading may take this long [s]; 0: ten seconds and one for each 2 MiB of the file
};

/// The endings of the formats that are offered, lower case, without the dot.
[[nodiscard]] std::vector<std::string> meshFormats();

/// True when the file's ending, in capitals or not, is that of a format that is offered.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& file);

/// What a format, given by its ending without the dot in small letters, says about unit and up axis.
[[nodiscard]] FormatFacts factsOfFormat(std::string_view format);

/// Reads a mesh file. The parsing happens in a child process with limits on memory and time, so that a file that
/// crashes or stalls the parser costs a message. Throws InputError (missing, a directory, unknown format, too large,
/// not a mesh, no faces, NaN, crash, time-out), naming file, place and remedy.
[[nodiscard]] ImportedMesh importMesh(const std::filesystem::path& file, const ImportOptions& options);

/// The same for a file that is already in memory. `name` is for messages and its ending tells the format.
[[nodiscard]] ImportedMesh importMeshFromMemory(std::string_view name, std::string_view bytes,
                                                const ImportOptions& options);

/// Welds, cleans and measures a raw mesh. Throws InputError when nothing usable is left.
[[nodiscard]] ImportedMesh weldMesh(const RawMesh& raw, std::string_view name, const ImportOptions& options);

/// One line a fact, for a terminal or a panel.
[[nodiscard]] std::vector<std::string> describe(const MeshSummary& summary);

}  // namespace drape
