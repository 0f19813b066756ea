#pragma once

#include "figure/moving_figure.hpp"
#include "io/clip_facts.hpp"
#include "io/mesh_import.hpp"
#include "scene/cloth_part.hpp"
#include "scene/mesh_reading.hpp"
#include "scene/pin_path.hpp"
#include "scene/placement.hpp"
#include "settings/settings.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/seams.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace drape::scene {

/// A view of the scene.
struct CameraPose {
  Vec3 position{0.0, 1.2, 3.0};    ///< [m]
  Vec3 focalPoint{0.0, 0.8, 0.0};  ///< [m]
  double viewAngle = 35.0;         ///< vertical [degrees]
  bool isOrthographic = false;     ///< without perspective; the focal plane has the same size as with it

  bool operator==(const CameraPose&) const = default;
};

/// A rectangular sheet; its size and resolution are settings.
struct GridSource {
  enum class Plane { Horizontal, Vertical } plane = Plane::Horizontal;
};

/// A mesh file, on disk or built in.
struct MeshFileSource {
  std::string path;  ///< as given; for a built-in file its name below assets
  bool builtIn = false;
  std::string where = {};  ///< file and line of the scene file that names it, for messages; otherwise empty
};

/// Pleats: the start is compressed along x to `gather` of its width, in `count` folds.
struct Pleats {
  int count = 8;
  double gather = 0.7;
};

/// The share of the height that the pins `top` of a mesh without a scene cover [-].
inline constexpr double topOfBareMesh = 0.03;

/// A selection of pinned vertices. All parts add up.
struct PinSelection {
  struct Box {
    Vec3 min = Vec3::Zero();  ///< [m]
    Vec3 max = Vec3::Zero();  ///< [m]
  };
  std::vector<int> vertices;         ///< by index
  std::vector<Vec3> nearest;         ///< the vertex nearest to each point of the rest shape [m]
  std::vector<Box> boxes;            ///< all vertices of the rest shape inside a box
  std::optional<double> top;         ///< all vertices within this share of the height from the top [-]
  std::vector<std::string> corners;  ///< of a grid: "top_left", "top_right", "bottom_left", "bottom_right"
  std::vector<std::string> edges;    ///< of a grid: "top", "bottom", "left", "right"
  int every = 1;                     ///< only every n-th vertex along edges, and the last
  std::string body;                  ///< the body that moves the pins; empty: none
  std::optional<sim::contact::BodyMotion> motion;  ///< of pins without a body; empty: they are fixed in space
  std::string where;               ///< file and line of the table, for messages; empty without a scene file
  std::string whereVertices = {};  ///< of its key `vertices`
};

/// The clip of a file with a skeletal animation, which becomes the frames of a body.
struct AnimationSource {
  std::string clip;    ///< its name; empty: the only one
  double rate = 60.0;  ///< frames a second [1/s]
  double blend = 0.0;  ///< time in which the body goes from the pose of its mesh (bind pose) into the clip [s]
  std::string openedClip = clip;  ///< the one with which the body was opened
};

/// A vertex cache (PC2 or MDD), which becomes the motion of a body's vertices.
struct CacheSource {
  std::string path;        ///< as given
  double rate = 30.0;      ///< of a PC2, frames a second [1/s]
  std::string where = {};  ///< file and line of the scene file that names it, for messages; otherwise empty
};

/// A body of a scene file; its meshes are not loaded yet.
struct BodyDescription {
  sim::contact::Body body;                      ///< without the shape when that is a mesh
  std::vector<MeshFileSource> meshes;           ///< one, or one per frame; empty for other shapes
  std::string framePattern;                     ///< of the names of the frames: "walk_####.obj"; empty: no frames
  int firstFrame = 0;                           ///< the number of the first one
  std::optional<AnimationSource> animation;     ///< of the only mesh
  std::optional<CacheSource> cache;             ///< of the only mesh
  std::optional<figure::FigureOptions> figure;  ///< of a body that is the figure; its mesh is the only one
  double scale = 1.0;                           ///< of the meshes [-]
  double frameTime = 1.0 / 30.0;                ///< time between two frames [s]
  bool frameLoop = false;                       ///< whether the frames repeat
  bool readLikeCloth = false;                   ///< whether the meshes use the unit and the up axis of the cloth
  /// The unit and the up axis of the mesh, never "auto", where the body has its own ones. Absent: as the cloth if
  /// readLikeCloth, else metres with y up.
  std::optional<ReadingChoice> reading;
  std::optional<ReadingChoice> openedReading;  ///< the one with which the body was opened
  Placement placement;                         ///< of the body with its whole motion
  Placement writtenPlacement;                  ///< the one in the scene file
};

/// The ground as a body for contact. The renderer draws the ground separately.
[[nodiscard]] sim::contact::Body groundBody();

/// A stand as a body for contact, without its shape. The renderer draws the stand separately.
[[nodiscard]] sim::contact::Body standBody();

/// A fixed object of a scene, such as a pole.
struct StandDescription {
  MeshFileSource mesh;
  std::optional<sim::contact::Body> body = standBody();  ///< absent: it is drawn, but has no contact
};

/// The files of a scene. Either `scene` or `cloth` must be set.
struct SceneParts {
  std::string scene = {};                ///< a built-in scene, a scene file or a mesh file; empty: only the next two
  std::string cloth = {};                ///< a mesh file for the cloth; empty: the cloth of the scene
  std::vector<std::string> bodies = {};  ///< mesh files of additional bodies
  /// Vertex caches of these bodies: each for the body whose file has the same name without the ending, or for the only
  /// body.
  std::vector<std::string> caches = {};
  /// Whether the cloth is a garment that a body is to wear: it has no pins, and each body has its own unit and axes.
  /// Then `cloth` and the only one of `bodies` may also be built-in ones, see openGarmentOnBody.
  bool dressed = false;
  /// Whether the garment is only placed on the body at first, so that the user moves it before the dressing.
  bool placed = false;
  ReadingChoice clothReading = {};               ///< of the file in `cloth`, or of the mesh file in `scene`
  std::vector<ReadingChoice> bodyReadings = {};  ///< of `bodies`; those that are left out are all "auto"
  /// The clips that move the bodies, see animatedBodyOfFile; absent or left out: the body stands.
  std::vector<std::optional<std::string>> bodyClips = {};
};

/// An elastic band along an open border, as it is written in a scene file.
struct BandDescription {
  Vec3 nearest = Vec3::Zero();  ///< the band is along the border that comes nearest to this point [m]
  double length = 1.0;          ///< its rest length over that of the border [-]
  std::string where = {};       ///< file and line, for messages
  /// Instead of `nearest`, by index: a vertex of the border, or the points of a part of it as in BorderDescription.
  std::vector<int> vertices = {};

  /// Without the place in the file.
  friend bool operator==(const BandDescription& a, const BandDescription& b) {
    return a.nearest == b.nearest && a.length == b.length && a.vertices == b.vertices;
  }
};

/// The range of the length of a band [-].
inline constexpr double minBandLength = 0.3;
inline constexpr double maxBandLength = 1.5;

/// A cloth as it is written in a scene file: the table [cloth], or one of the tables [[cloths]].
struct ClothDescription {
  std::string name;  ///< unique in the scene; empty for [cloth]
  std::variant<GridSource, MeshFileSource> source;
  /// A file with the same vertices, where they are at the start: in the unit and the axes of the mesh, moved by
  /// position, rotation and placement. It does not change the rest shape. Empty: the start is the rest shape.
  std::optional<MeshFileSource> start;
  Vec3 position = Vec3::Zero();  ///< added to the mesh [m]
  Vec3 rotation = Vec3::Zero();  ///< applied to the mesh first, about its own origin: axis times angle [rad]
  /// Of the cloth at its start. Its scale is that of the rest shape, too. Pins, bands and seams refer to the cloth
  /// before it, and so does the direction of warp.
  Placement placement;
  Placement writtenPlacement;  ///< the one in the scene file
  std::optional<Pleats> pleats;
  std::vector<BandDescription> bands;
  bool frozen = false;             ///< every vertex is pinned where it starts
  std::vector<PinSelection> pins;  ///< one per table of pins; a vertex belongs to the first one that selects it
  std::vector<OwnSetting> own;     ///< settings of this cloth, in the order in which they are assigned
};

/// A path along the open border of a cloth, as it is written in a scene file: from the first point to the last one, on
/// the shorter way or through the point between them. A single point is the start of the whole border.
struct BorderDescription {
  std::string cloth;          ///< its name; empty: the only cloth
  std::vector<int> vertices;  ///< the points by index, or
  std::vector<Vec3> nearest;  ///< as the vertices of the border that are nearest to points of the rest shape [m]

  bool operator==(const BorderDescription&) const = default;
};

/// A seam as it is written in a scene file: one table of [[seams]].
struct SeamDescription {
  /// The two sides. With `pairs` only their cloths are used.
  std::array<BorderDescription, 2> sides;
  std::vector<std::array<int, 2>> pairs;  ///< vertices by index; empty: the pairs follow from the sides
  double duration = 1.0;                  ///< [s]
  std::string where;                      ///< file and line, for messages
  bool isReversed = false;                ///< whether the second side runs the other way

  /// Without the place in the file.
  friend bool operator==(const SeamDescription& a, const SeamDescription& b) {
    return a.sides == b.sides && a.pairs == b.pairs && a.duration == b.duration && a.isReversed == b.isReversed;
  }
};

/// The range of the duration of a seam [s].
inline constexpr double minSeamDuration = 0.02;
inline constexpr double maxSeamDuration = 600.0;

/// A scene as it is written in its file (docs/guide/scenes.md), before anything is built.
struct SceneDescription {
  SceneParts parts;   ///< what it was opened from
  std::string name;   ///< "flag", or the file's name
  std::string title;  ///< "A flag in the wind"
  std::string help;
  std::vector<ClothDescription> cloths = std::vector<ClothDescription>(1);  ///< at least one
  std::vector<SeamDescription> seams;
  std::optional<CameraPose> camera;  ///< absent: the cloth fills the view
  std::optional<StandDescription> stand;
  std::vector<BodyDescription> bodies;
  std::optional<double> groundHeight;                       ///< absent: groundHeightOf chooses it [m]
  bool groundBelowCloth = false;                            ///< an automatic height is always below the cloth
  std::optional<sim::contact::Body> ground = groundBody();  ///< absent: the cloth falls through the ground
  bool opened = false;                                      ///< a mesh file that was opened without a scene
  settings::Settings settings;                              ///< the defaults with the scene's values
  std::vector<std::string> notes;                           ///< about the scene file, for the user

  /// The first cloth, which is the only one of most scenes.
  [[nodiscard]] ClothDescription& cloth() { return cloths.front(); }
  [[nodiscard]] const ClothDescription& cloth() const { return cloths.front(); }
};

/// The surface of a stand.
struct Decor {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<Triangle> triangles;
};

/// A hint for the user, and the change of a setting that helps.
struct Advice {
  text::Sentence text;  ///< the problem and the remedy, in one or two sentences
  std::string key;      ///< of the setting; empty when no setting helps
  std::string value;
  text::Sentence button;  ///< the text of a button for the change: "Pin by shape"
};

/// A scene that is ready to run. Immutable; the simulation, the renderer and the panels share it.
struct Scene {
  SceneDescription description;
  settings::Settings settings;  ///< the settings with which it was built
  std::shared_ptr<const sim::ClothModel> model;
  /// One per vertex, without the placements of the cloths [m]: seams and elastic bands refer to them.
  std::vector<Vec3> restPositions;
  sim::ClothState start;
  std::shared_ptr<const std::vector<sim::Seam>> seams = std::make_shared<std::vector<sim::Seam>>();  ///< never null
  io::RenderMesh renderMesh;
  std::vector<ClothPart> cloths = std::vector<ClothPart>(1);  ///< at least one, in the order of the description
  io::MeshSummary summary;
  std::optional<MeshReading> reading;  ///< of the first cloth from a mesh file that is not built in
  std::optional<Advice> pinAdvice;     ///< when the pins fix all vertices or none
  std::optional<Decor> stand;
  std::shared_ptr<const std::vector<sim::contact::Body>> bodies =
      std::make_shared<std::vector<sim::contact::Body>>();  ///< never null
  /// The clips in the files of bodies with an animation, by body of the description; empty for other bodies.
  std::vector<std::vector<io::ClipFacts>> clips;
  std::vector<PinPath> pinPaths;  ///< of pins that move without a body; a vertex is in one of them at most
  CameraPose camera;
  double groundHeight = 0.0;  ///< [m]
};

/// The name and the description of a built-in scene.
struct SceneInfo {
  std::string name;
  std::string title;
  std::string help;
};

/// The built-in scenes; the first is the default.
[[nodiscard]] std::vector<SceneInfo> sceneList();

/// Reads a built-in scene ("flag"), a scene file ("mine.toml") or a mesh file ("shirt.obj"). Throws InputError.
/// @param own the user's fabrics, which the settings of the scene may name
[[nodiscard]] SceneDescription openScene(const std::string& nameOrPath, const settings::OwnFabrics& own = {});

/// Builds mesh, model and start from a description with these settings. Throws InputError, and Cancelled when the watch
/// cancels.
[[nodiscard]] std::shared_ptr<const Scene> buildScene(const SceneDescription& description,
                                                      const settings::Settings& settings,
                                                      const io::ImportWatch& watch = {});

}  // namespace drape::scene
