#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace drape::ui {

/// What an export contains.
enum class ExportKind {
  Frame,   ///< the cloth as it is
  Motion,  ///< the cloth in several frames
  Film     ///< pictures
};

/// A format of exports.
struct ExportFormat {
  ExportKind kind = ExportKind::Frame;
  std::string_view name;    ///< unique, for tests
  std::string_view title;   ///< in the list
  std::string_view ending;  ///< of the file, with the dot
  bool isSequence = false;  ///< one file for each frame; the name has a placeholder for its number
};

/// All formats, those of one kind side by side.
[[nodiscard]] std::span<const ExportFormat> exportFormats();

/// Write the cloth, its motion, or a film of it to new files.
struct ExportRequest {
  /// Where the motion begins: at the start of the scene, as after a reset, or at the present state.
  enum class Start { Scene, Present };

  const ExportFormat* format = &exportFormats().front();
  std::string file;  ///< its ending may be missing; empty: a free name in the current folder
  Start start = Start::Scene;
  double from = 0.0;   ///< time of the first frame, from the start [s]
  double to = 4.0;     ///< of the last one [s]
  double rate = 30.0;  ///< frames per second
  int width = 1280;    ///< of pictures [pixels]
  int height = 720;    ///< [pixels]
  bool turns = false;  ///< whether the camera turns once around the cloth
};

/// The limits of what a user can ask for.
inline constexpr double longestExport = 3600.0;  // [s]
inline constexpr double minExportRate = 0.1;     // frames per second
inline constexpr double maxExportRate = 1000.0;

/// The sizes of the pictures of a film [pixels].
struct PictureSize {
  int width = 0;
  int height = 0;
};
inline constexpr std::array<PictureSize, 5> pictureSizes{
    {{640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}, {1080, 1080}}};

/// An export that is under way.
struct ExportProgress {
  std::string file;           ///< that it writes
  double share = 0.0;         ///< from 0 to 1
  double secondsLeft = -1.0;  ///< negative: not known yet [s]
};

}  // namespace drape::ui
