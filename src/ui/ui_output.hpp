#pragma once

#include "fields/shown_field.hpp"
#include "scene/scene_parts.hpp"
#include "session/command.hpp"
#include "settings/settings.hpp"
#include "sim/measures/error_sources.hpp"
#include "sim/model/vector.hpp"
#include "text/sentence.hpp"
#include "ui/export_request.hpp"
#include "ui/found_file.hpp"
#include "ui/placing_view.hpp"
#include "ui/sewing_view.hpp"
#include "ui/theme_choice.hpp"
#include "ui/ui_rect.hpp"
#include "ui/wording.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace drape::ui {

/// Open another scene: a built-in name, a scene file or a mesh file.
struct OpenSceneRequest {
  std::string nameOrPath;
};

/// Open a scene that consists of several files.
struct OpenPartsRequest {
  scene::SceneParts parts;
};

/// Files that were dropped on the window together.
struct DroppedRequest {
  std::vector<std::string> files;
};

/// Rebuild the running scene, because a setting that its mesh depends on changed, or a placement.
struct RebuildSceneRequest {
  settings::Settings settings;                                 ///< all of them, with the change
  std::optional<scene::Placements> placements = std::nullopt;  ///< empty: the present ones
};

/// A choice of the user in the mode Place.
struct PlacingRequest {
  enum class Kind {
    Choose,    ///< another thing
    UseTool,   ///< another tool
    Preview,   ///< shows a placement while the user still changes it
    Place,     ///< gives the thing a placement
    Read,      ///< reads the file of the thing in another unit or with another up axis
    Keep,      ///< the placement that was shown last
    OnGround,  ///< lets the lowest point of the thing touch the ground
    Restore,   ///< the placement of the scene file
    End        ///< of the mode
  };
  Kind kind = Kind::End;
  scene::Placeable thing = {};
  PlacingTool tool = PlacingTool::Move;
  scene::Placement placement = {};
  scene::ReadingChoice reading = {};  ///< of Read; without "auto"
};

/// A choice of the user in the mode Sew.
struct SewingRequest {
  enum class Kind {
    UseKind,    ///< of what is made: seams or elastic bands
    UseExtent,  ///< how much of a border a click picks
    Flip,       ///< the direction of the second side
    Sew,        ///< the picked borders
    SetBand,    ///< along the picked border
    Clear,      ///< the picked borders
    End         ///< of the mode
  };
  Kind kind = Kind::End;
  SewingKind sewing = SewingKind::Seam;
  BorderExtent extent = BorderExtent::Corners;
  double length = 1.0;  ///< of a band over its border at rest [-]
};

/// Save a fabric of the user, and give it to the cloth.
struct SaveFabricRequest {
  enum class Place { List, Scene };  ///< the user's list, or the file of the running scene
  settings::OwnFabric fabric;
  Place place = Place::List;
};

/// Write the cloth as it is to a new file.
struct SaveClothRequest {
  std::string path;  ///< its extension gives the format; empty: an OBJ with a free name in the current folder
};

/// Write the scene as it is to a scene file.
struct SaveSceneRequest {
  std::string path;         ///< empty: the file that it was saved to before, or a free name in the current folder
  bool mayReplace = false;  ///< whether the user wants to replace a file of this name
};

/// Use other colours for the panels.
struct ThemeRequest {
  Theme theme = Theme::Dark;
};

/// Show the window in another language.
struct LanguageRequest {
  std::string name;  ///< of one of locale::languages()
};

/// Mark a vertex of the cloth, or remove its mark.
struct PickVertexRequest {
  int vertex = 0;
};

/// Actions of the program, not of the simulation.
enum class UiAction {
  TogglePanels,
  ToggleHelp,
  Screenshot,
  SaveCloth,  ///< SaveClothRequest without a path
  SaveScene,  ///< SaveSceneRequest without a path
  OpenFile,   ///< by a dialog
  Search,     ///< over settings, commands and scenes
  Undo,
  Redo,
  NextTheme,
  SelectRectangle,  ///< the next drags select vertices
  SelectBorder,     ///< the next clicks select borders
  PinSelected,      ///< vertices
  ReleaseSelected,
  TogglePinsSelected,  ///< release them if all are pinned, else pin them
  EndSelection,
  Sew,               ///< starts the mode that sews borders
  SetBand,           ///< the same for elastic bands
  Place,             ///< starts the mode that moves, turns and scales things, or takes its next tool
  ToggleProjection,  ///< perspective or orthographic
  ToggleTurntable,
  RecallView1,  ///< a kept view of this scene; the four are in order
  RecallView2,
  RecallView3,
  RecallView4,
  KeepView1,
  KeepView2,
  KeepView3,
  KeepView4,
  ShowExport,        ///< the panel of exports
  CancelExport,      ///< that is under way
  Dress,             ///< a body of the scene with the cloth
  PlaceOnBody,       ///< puts the cloth where a body of the scene would wear it, with all intersections
  CancelDressing,    ///< that is under way
  CompareErrors,     ///< of the motion since the start, by their sources
  CancelComparison,  ///< that is under way
  SaveProbes,        ///< the values at the picked vertices
  FrameCloth,
  ViewFront,
  ViewRight,
  ViewTop,
  ResetAll,           ///< restore settings, pins, bodies and cloth of the scene
  Stop,               ///< dressing or reading a file; without these, says how to quit
  Quit,               ///< asks before changes are lost
  QuitAndLoseChanges  ///< without asking
};

using UiRequest = std::variant<OpenSceneRequest, OpenPartsRequest, DroppedRequest, RebuildSceneRequest,
                               SaveFabricRequest, SaveClothRequest, SaveSceneRequest, ThemeRequest, LanguageRequest,
                               PickVertexRequest, PlacingRequest, SewingRequest, ExportRequest, UiAction>;

/// The requests of the user in one frame. Panels and input only add to it; they never change the running state.
struct UiOutput {
  std::vector<session::Command> commands;  ///< for the simulation, in order
  std::vector<UiRequest> requests;         ///< for the program, in order
  Wording hint;                            ///< for the status line, or empty
};

/// How a drag or a click in the picture selects vertices.
enum class SelectionMode { Off, Rectangle, Border };

/// The selected vertices, for the picture.
struct SelectionView {
  SelectionMode mode = SelectionMode::Off;
  std::optional<UiRect> rectangle;  ///< that is being dragged [window units]
  std::vector<int> vertices;        ///< that are selected, sorted
  std::vector<Vec2> points;         ///< of these vertices [window units]
  int pinned = 0;                   ///< how many of them are pinned
};

/// The number of views that are kept for a scene.
inline constexpr std::size_t keptViewCount = 4;

/// The state of the camera, for the panels.
struct CameraStatus {
  bool isOrthographic = false;
  bool turns = false;                         ///< as a turntable
  std::array<bool, keptViewCount> hasView{};  ///< which views are kept
};

/// Bodies that pass through the cloth.
struct PiercingNotice {
  Wording text;           ///< which part of which body, and how many pairs of triangles; without a full stop
  std::size_t pairs = 0;  ///< of triangles of cloth and bodies that intersect
};

/// Dressing that is under way.
struct DressingProgress {
  Wording words;       ///< what it does
  double share = 0.0;  ///< of that, from 0 to 1
};

/// A comparison of the sources of error.
struct ErrorComparisonView {
  std::optional<double> share;             ///< of the work that is done, from 0 to 1; empty: none is under way
  std::vector<sim::ErrorSources> sources;  ///< of the last comparison of this scene, at ascending times; may be empty
};

/// Data of the panels besides the snapshot.
struct UiStats {
  double frameSeconds = 0.0;             ///< between two drawn frames, recently [s]
  Wording loading;                       ///< the job in the background, or empty
  double loadingShare = -1.0;            ///< its progress from 0 to 1; negative: unknown
  Wording error;                         ///< the last error, in words, or empty
  int failures = 0;                      ///< number of errors so far; distinguishes two errors with the same words
  Wording notice;                        ///< the last message, or empty
  std::vector<std::string> recentFiles;  ///< that were opened before, the newest first
  std::span<const FoundFile> found;      ///< the mesh files that the user is asked about
  SelectionView selection;
  std::optional<PlacingView> placing;  ///< empty: the mode Place is off
  std::optional<SewingView> sewing;    ///< empty: the mode Sew is off
  CameraStatus camera;
  std::optional<PiercingNotice> piercing;    ///< empty: no body passes through the cloth
  std::optional<DressingProgress> dressing;  ///< empty: no dressing is under way
  ErrorComparisonView errors;
  std::optional<ExportProgress> exporting;    ///< empty: no export is under way
  const fields::ShownField* field = nullptr;  ///< the colour map of this picture; null: there is none
  fields::SnapshotFields* fields = nullptr;   ///< computes the values at picked vertices; null: none can be picked
};

}  // namespace drape::ui
