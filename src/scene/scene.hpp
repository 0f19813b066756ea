#pragma once

#include "io/mesh_import.hpp"
#include "scene/mesh_reading.hpp"
#include "settings/settings.hpp"
#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/body.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace drape {

/// Where one looks from. The vertical angle of view is in degrees.
struct CameraPose {
  Vec3 position{0.0, 1.2, 3.0};    ///< [m]
  Vec3 focalPoint{0.0, 0.8, 0.0};  ///< [m]
  double viewAngle = 35.0;         ///< vertical [degrees]
};

/// A rectangular sheet; its size and resolution are settings.
struct GridSource {
  enum class Plane { Horizontal, Vertical } plane = Plane::Horizontal;
};

/// A mesh file: on disk, or one of those that are built in.
struct MeshFileSource {
  std::string path;  ///< as given; for a built-in file its name below assets
  bool builtIn = false;
  std::string where = {};  ///< file and line that name it, for messages; empty when no scene file does
};

/// Pleats: the start is pressed together along x to `gather` of its width, in `count` folds.
struct Pleats {
  int count = 8;
  double gather = 0.7;
};

/// How much of a mesh without a scene is held at its top, as a share of its height [-].
inline constexpr double topOfBareMesh = 0.03;

/// Which vertices are held. All the parts that are present add up.
struct PinSelection {
  struct Box {
    Vec3 min = Vec3::Zero();  ///< [m]
    Vec3 max = Vec3::Zero();  ///< [m]
  };
  std::vector<int> vertices;         ///< by index
  std::vector<Vec3> nearest;         ///< the vertex nearest to each point of the rest shape [m]
  std::vector<Box> boxes;            ///< all vertices of the rest shape inside a box
  std::optional<double> top;         ///< all vertices within this fraction of the height from the top [-]
  std::vector<std::string> corners;  ///< of a grid: "top_left", "top_right", "bottom_left", "bottom_right"
  std::vector<std::string> edges;    ///< of a grid: "top", "bottom", "left", "right"
  int every = 1;                     ///< along edges only every n-th vertex, and the last
  std::string body;                  ///< that carries them along; empty: they stay where they are
  std::string where;                 ///< file and line of the table, for messages; empty when no scene file has it
};

/// A body as it is written down: all but its mesh, which is still in files.
struct BodyDescription {
  Body body;                           ///< without the shape when that is a mesh
  std::vector<MeshFileSource> meshes;  ///< of a mesh: one, or one for each frame; empty for other shapes
  double scale = 1.0;                  ///< of the meshes [-]
  double frameTime = 1.0 / 30.0;       ///< from one frame to the next [s]
  bool frameLoop = false;              ///< after the last frame comes the first one
  bool readLikeCloth = false;          ///< the meshes are in the cloth's unit, with its axis up
};

/// The ground as the cloth meets it. The renderer draws the ground apart from the bodies.
[[nodiscard]] Body groundToTouch();

/// A stand as the cloth meets it, without its shape. The renderer draws the stand apart from the bodies.
[[nodiscard]] Body standToTouch();

/// A thing that stands in a scene, such as a pole. It does not move.
struct StandDescription {
  MeshFileSource mesh;
  std::optional<Body> body = standToTouch();  ///< absent: it is drawn, and the cloth passes through it
};

/// A scene as it is written down (docs/guide/scenes.md), before anything is built.
struct SceneDescription {
  std::string name;   ///< "flag", or the file's name
  std::string title;  ///< "A flag in the wind"
  std::string help;
  std::variant<GridSource, MeshFileSource> source;
  Vec3 position = Vec3::Zero();  ///< added to the mesh [m]
  Vec3 rotation = Vec3::Zero();  ///< of the mesh before that, about its own origin: axis times angle [rad]
  std::optional<Pleats> pleats;
  PinSelection pins;
  std::optional<CameraPose> camera;  ///< absent: chosen so that the cloth fills the view
  std::optional<StandDescription> stand;
  std::vector<BodyDescription> bodies;
  std::optional<double> groundHeight;            ///< absent: groundHeightOf chooses [m]
  bool groundBelowCloth = false;                 ///< an absent height is always below the cloth
  std::optional<Body> ground = groundToTouch();  ///< absent: the cloth falls through the ground
  bool opened = false;                           ///< a mesh file that was opened by itself, without a scene
  Settings settings;                             ///< the defaults with the scene's own values
  std::vector<std::string> notes;                ///< about the scene file, for the user
};

/// The surface of a stand.
struct Decor {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<Triangle> triangles;
};

/// Something that a user should know, and the change of a setting that would help.
struct Advice {
  std::string text;  ///< what is the matter and what helps, one or two sentences
  std::string key;   ///< of the setting; empty when no setting helps
  std::string value;
  std::string button;  ///< what a button that makes the change says: "Pin by shape"
};

/// A scene that is ready to run. Immutable; shared by the simulation, the renderer and the panels.
struct Scene {
  SceneDescription description;
  Settings settings;  ///< in force when it was built
  std::shared_ptr<const ClothModel> model;
  ClothState start;
  RenderMesh renderMesh;
  MeshSummary summary;
  std::optional<MeshReading> reading;  ///< of a mesh file that is not built in
  std::optional<Advice> pinAdvice;     ///< when the pins leave nothing to move, or hold nothing
  std::optional<Decor> stand;
  std::shared_ptr<const std::vector<Body>> bodies = std::make_shared<std::vector<Body>>();  ///< never null
  CameraPose camera;
  double groundHeight = 0.0;  ///< [m]
};

/// A built-in scene's name and what it shows.
struct SceneInfo {
  std::string name;
  std::string title;
  std::string help;
};

/// The built-in scenes; the first is what the program shows when nothing is asked for.
[[nodiscard]] std::vector<SceneInfo> sceneList();

/// Reads a built-in scene ("flag"), a scene file ("mine.toml") or a mesh file ("shirt.obj"). Throws InputError.
[[nodiscard]] SceneDescription openScene(const std::string& nameOrPath);

/// Builds mesh, model and start from a description under the given settings. Throws InputError; and Cancelled when the
/// watch asks for it.
[[nodiscard]] std::shared_ptr<const Scene> buildScene(const SceneDescription& description, const Settings& settings,
                                                      const ImportWatch& watch = {});

}  // namespace drape
