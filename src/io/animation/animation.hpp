#pragma once

#include "io/file_mesh.hpp"
#include "sim/model/vector.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io::animation {

/// An object of an animation: a cloth.
struct Object {
  std::string name;                      ///< not empty
  std::shared_ptr<const FileMesh> mesh;  ///< never null
};

/// What all frames of an animation have in common.
struct Clip {
  std::vector<Object> objects;  ///< at least one
  double rate = 30.0;           ///< frames per second
  int firstFrame = 0;           ///< the number of the first frame; frame 0 is at time 0
  int frames = 1;               ///< the planned number; fewer may follow
  double metresPerUnit = 1.0;   ///< of the positions [m]
  char up = 'y';                ///< the axis of the positions that points up; 'y' or 'z' for USD and glTF
  std::string comment;          ///< one line about the origin, for formats with comments
};

/// One object in one frame.
struct Shape {
  std::vector<Vec3> positions;  ///< one per vertex of the object's mesh
  std::vector<Vec3> normals;    ///< likewise, of length 1
};
/// One shape per object.
using Frame = std::vector<Shape>;

/// Writes the frames of an animation to one file, or to one per frame. The file is written beside its name and renamed
/// at the end, so that a file of that name is complete. An unfinished file is removed. All functions throw InputError
/// when the file cannot be written.
class Writer {
 public:
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  virtual ~Writer() = default;

  virtual void add(const Frame& frame) = 0;
  /// Ends the file after at least one frame. Call it once.
  virtual void finish() = 0;
};

/// The number of objects and of frames that a file of a format can hold.
struct Format {
  std::string_view extension;  ///< lower case, without the dot
  bool holdsFrames = false;    ///< whether one file holds all frames; otherwise each frame has its own
  bool holdsObjects = false;   ///< whether one file holds several objects
  bool isInMetres = false;     ///< the format prescribes metres, y up
};

/// The format of a file by its extension, in any case. Throws UsageError with the list of the formats.
[[nodiscard]] const Format& formatOf(const std::filesystem::path& file);

/// The file of a frame by its number. Formats that hold all frames use that of the first frame.
using FileOfFrame = std::function<std::filesystem::path(int)>;

/// A writer of the format that the extension names. Throws UsageError as formatOf, and InputError when the file cannot
/// be opened or the format cannot hold the clip.
[[nodiscard]] std::unique_ptr<Writer> makeWriter(const FileOfFrame& files, const Clip& clip);

/// The writers of the formats.
[[nodiscard]] std::unique_ptr<Writer> makeObjWriter(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makePlyWriter(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makeCsvWriter(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makePc2Writer(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makeMddWriter(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makeGlbWriter(const FileOfFrame& files, const Clip& clip);
[[nodiscard]] std::unique_ptr<Writer> makeUsdaWriter(const FileOfFrame& files, const Clip& clip);

}  // namespace drape::io::animation
