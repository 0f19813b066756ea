#include "scene/body_reader.hpp"

#include "io/point_cache_import.hpp"
#include "messages/error.hpp"
#include "scene/keyframe_file.hpp"
#include "scene/placement_file.hpp"
#include "settings/surface_fields.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace drape::scene {
namespace {

constexpr double smallest = 1e-4;  // [m] of a body
constexpr double manyTurns = 1e6;  // [degrees], or degrees per second

/// The keys of a shape, besides those of every body.
struct ShapeKeys {
  std::string_view shape;
  std::vector<std::string_view> keys;
};

std::vector<std::string_view> figureKeys() {
  std::vector<std::string_view> keys{"motion", "speed"};
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    keys.push_back(each.key);
  }
  return keys;
}

const std::vector<ShapeKeys>& shapes() {
  static const std::vector<ShapeKeys> list{{"plane", {"size"}},
                                           {"sphere", {"radius"}},
                                           {"capsule", {"radius", "length"}},
                                           {"box", {"size"}},
                                           {"mesh", {"mesh", "scale", "frames", "animation", "cache"}},
                                           {"figure", figureKeys()}};
  return list;
}

/// Allows only the keys of this shape.
void checkKeys(const TomlReader& table, const std::string& shape) {
  std::vector<std::string_view> keys{"name", "shape",     "position", "rotation", "placement",
                                     "spin", "keyframes", "loop",     "drawn"};
  keys.insert(keys.end(), surfaceKeys.begin(), surfaceKeys.end());
  std::string known;
  for (const ShapeKeys& each : shapes()) {
    known += (known.empty() ? "" : ", ") + std::string(each.shape);
    if (each.shape == shape) {
      keys.insert(keys.end(), each.keys.begin(), each.keys.end());
      table.allowOnly(keys);
      return;
    }
  }
  table.failAt("shape", "bodies.shape must be one of " + known + (shape.empty() ? "" : ", not \"" + shape + "\""));
}

double length(const TomlReader& table, std::string_view key, double usual) {
  return table.number(key, smallest, farAway).value_or(usual);
}

sim::contact::BodyShape readShape(const TomlReader& table, const std::string& shape) {
  if (shape == "plane") {
    return sim::contact::PlaneShape{0.5 * length(table, "size", 2.0 * sim::contact::PlaneShape{}.halfSize)};
  }
  if (shape == "sphere") {
    return sim::contact::SphereShape{length(table, "radius", sim::contact::SphereShape{}.radius)};
  }
  if (shape == "capsule") {
    return sim::contact::CapsuleShape{length(table, "radius", sim::contact::CapsuleShape{}.radius),
                                      0.5 * length(table, "length", 2.0 * sim::contact::CapsuleShape{}.halfLength)};
  }
  const Vec3 size = table.vector("size").value_or(Vec3::Ones());
  if (!(size.minCoeff() >= smallest && size.maxCoeff() <= farAway)) {
    table.failAt("size", "bodies.size must be three lengths from 0.0001 to 10000");
  }
  return sim::contact::BoxShape{0.5 * size};
}

/// One file per frame: "walk_####.obj" becomes "walk_0001.obj" and so on.
void readFrames(const TomlReader& frames, const MeshFileSource& pattern, BodyDescription& body) {
  frames.allowOnly({"first", "last", "rate", "loop"});
  const std::size_t digits = pattern.path.find('#', pattern.path.find_last_of('/') + 1);
  const std::size_t end = pattern.path.find_first_not_of('#', digits);
  if (digits == std::string::npos) {
    frames.fail("the mesh of a body with frames needs a number pattern: mesh = \"walk_####.obj\"");
  }
  const int first = frames.integer("first", 0, 1'000'000).value_or(1);
  const auto last = frames.integer("last", first + 1, first + 10'000);
  if (!last) {
    frames.fail("bodies.frames needs last, the number of the last file");
  }
  body.framePattern = pattern.path;
  body.firstFrame = first;
  const std::size_t width = (end == std::string::npos ? pattern.path.size() : end) - digits;
  for (int frame = first; frame <= *last; ++frame) {
    MeshFileSource source = pattern;
    source.path.replace(digits, width, fmt::format("{:0{}}", frame, width));
    body.meshes.push_back(std::move(source));
  }
  body.frameTime = 1.0 / frames.number("rate", 0.001, 1e4).value_or(30.0);
  body.frameLoop = frames.flag("loop").value_or(false);
}

/// A clip of the skeletal animation in one file.
void readAnimation(const TomlReader& table, const MeshFileSource& mesh, BodyDescription& body) {
  table.allowOnly({"clip", "rate", "loop", "blend"});
  if (mesh.builtIn) {
    table.fail("an animation is read from a file; no built-in mesh has one");
  }
  body.animation = AnimationSource{table.text("clip").value_or(""), table.number("rate", 1.0, 1000.0).value_or(60.0),
                                   table.number("blend", 0.0, 60.0).value_or(0.0)};
  body.frameLoop = table.flag("loop").value_or(false);
  body.meshes.push_back(mesh);
}

/// A vertex cache that moves the vertices of a mesh file.
void readCache(const TomlReader& table, const MeshFileSource& mesh, const std::filesystem::path& folder,
               BodyDescription& body) {
  table.allowOnly({"file", "rate", "loop"});
  const std::string name = table.text("file").value_or("");
  if (!io::isPointCache(name)) {
    table.fail("a vertex cache is a .pc2 or an .mdd file: cache = { file = \"walk.pc2\" }");
  }
  if (io::hasOwnTimes(name) && table.has("rate")) {
    table.fail("an MDD file has its own times; leave rate out");
  }
  body.cache = CacheSource{(folder / name).string(), table.number("rate", 0.001, 1e4).value_or(CacheSource{}.rate),
                           table.place("file")};
  body.frameLoop = table.flag("loop").value_or(false);
  body.meshes.push_back(mesh);
}

void readMesh(const TomlReader& table, const std::filesystem::path& folder, BodyDescription& body) {
  if (!table.has("mesh")) {
    table.fail("a body of shape \"mesh\" needs mesh = \"file.obj\"");
  }
  const MeshFileSource mesh = meshSource(table, folder);
  body.scale = table.number("scale", 1e-6, 1e6).value_or(1.0);
  const auto animation = table.table("animation");
  if (table.has("animation") + table.has("frames") + table.has("cache") > 1) {
    table.fail("a body has either frames or an animation or a cache");
  }
  if (animation) {
    readAnimation(*animation, mesh, body);
  } else if (const auto frames = table.table("frames")) {
    readFrames(*frames, mesh, body);
  } else if (const auto cache = table.table("cache")) {
    readCache(*cache, mesh, folder, body);
  } else {
    body.meshes.push_back(mesh);
  }
}

void readFigure(const TomlReader& table, BodyDescription& body) {
  figure::FigureOptions options;
  if (const std::optional<std::string> name = table.text("motion")) {
    const figure::Motion* motion = figure::findMotion(*name);
    if (motion == nullptr) {
      table.fail("bodies.motion must be one of " + figure::motionNames() + ", not \"" + *name + "\"");
    }
    options.motion = motion;
  }
  options.speed = table.number("speed", figure::minSpeed, figure::maxSpeed).value_or(options.speed);
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    options.proportions.*each.value = table.number(each.key, each.min, each.max);
  }
  body.figure = options;
  body.meshes = {MeshFileSource{"figure.obj", true, table.place()}};
}

sim::contact::BodyMotion readMotion(const TomlReader& table) {
  sim::contact::BodyMotion motion;
  const sim::contact::Keyframe start{0.0, table.vector("position").value_or(Vec3::Zero()),
                                     degree * table.vector("rotation", manyTurns).value_or(Vec3::Zero())};
  motion.spin = degree * table.vector("spin", manyTurns).value_or(Vec3::Zero());
  readKeyframes(table, start, motion);
  return motion;
}

BodyDescription readBody(const TomlReader& table, const std::filesystem::path& folder, std::size_t number) {
  const std::string shape = table.text("shape").value_or("");
  checkKeys(table, shape);
  BodyDescription description;
  sim::contact::Body& body = description.body;
  body.name = table.text("name").value_or("body " + std::to_string(number));
  if (shape == "mesh") {
    readMesh(table, folder, description);
  } else if (shape == "figure") {
    readFigure(table, description);
  } else {
    body.shape = readShape(table, shape);
  }
  body.motion = readMotion(table);
  description.placement = readPlacement(table);
  description.writtenPlacement = description.placement;
  if (description.figure && description.placement.scale != 1.0) {
    table.fail("a figure has its size by height, chest, waist, hip and shoulder; its placement cannot have a scale");
  }
  body.drawn = table.flag("drawn").value_or(true);
  readSurface(table, body);
  return description;
}

}  // namespace

MeshFileSource meshSource(const TomlReader& table, const std::filesystem::path& folder) {
  constexpr std::string_view builtin = "builtin:";
  const std::optional<std::string> written = table.text("mesh");
  const std::string name = written.value_or("");
  const std::string place = table.place("mesh");
  if (name.empty() || name == builtin) {
    throw messages::InputError(place + ": mesh " + (written ? "has no name" : "is missing") +
                               "; write mesh = \"file.obj\" or mesh = \"builtin:skirt.obj\"");
  }
  if (name.starts_with(builtin)) {
    return {name.substr(builtin.size()), true, place};
  }
  return {(folder / name).string(), false, place};
}

void readSurface(const TomlReader& table, sim::contact::Body& body) {
  sim::contact::SurfaceProperties surface = body.surface;
  for (const settings::SurfaceField& field : settings::surfaceFields()) {
    surface.*field.value = table.number(field.key, field.min, field.max).value_or(surface.*field.value);
  }
  if (!table.has("kinetic_friction")) {
    surface.kineticFriction = std::min(surface.kineticFriction, surface.staticFriction);
  }
  if (surface.kineticFriction > surface.staticFriction) {
    table.failAt("kinetic_friction", "kinetic_friction must not be larger than static_friction");
  }
  body.surface = surface;
}

std::vector<BodyDescription> readBodies(const TomlReader& scene, const std::filesystem::path& folder) {
  std::vector<BodyDescription> bodies;
  for (const TomlReader& table : scene.tables("bodies")) {
    BodyDescription next = readBody(table, folder, bodies.size() + 1);
    const bool taken = std::any_of(bodies.begin(), bodies.end(),
                                   [&](const BodyDescription& other) { return other.body.name == next.body.name; });
    if (taken) {
      table.fail("there are two bodies with the name \"" + next.body.name + "\"");
    }
    bodies.push_back(std::move(next));
  }
  return bodies;
}

}  // namespace drape::scene
