#pragma once

#include "io/file_mesh.hpp"
#include "io/import_watch.hpp"
#include "sim/model/vector.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// An OBJ file reduced to what a mesh needs, in a form that the parsing library does not misread.
struct ObjText {
  std::string text;        ///< lines that begin with v, vt, f, o, g and usemtl
  int facesSkipped = 0;    ///< points and lines, left out
  int unusedVertices = 0;  ///< vertices that no face uses
  std::vector<std::string> warnings;
  FileMesh mesh;  ///< without `particle`
};

/// Checks every line of an OBJ file (plainText) and reduces it: three coordinates a vertex, no normals, no comments, no
/// continued lines. Throws InputError with the line for all that would give a wrong mesh: coordinates that are not
/// finite numbers, faces with corners that do not exist, an end in the middle of a line, no faces at all. Data that
/// only the picture needs, and lines that OBJ does not define, are replaced or left out with a warning. Source: B1.
/// Object Files
/// (.obj), Wavefront Technologies, Advanced Visualizer manual, appendix B.
[[nodiscard]] ObjText checkObj(std::string_view text, const ImportWatch& watch);

/// The number, from 1, and the line of the vertex nearest to `position`: "vertex 500 (line 512)".
[[nodiscard]] std::string nameObjVertex(std::string_view text, const Vec3& position);

}  // namespace drape::io
