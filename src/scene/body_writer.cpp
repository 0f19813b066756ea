#include "scene/body_writer.hpp"

#include "io/point_cache_import.hpp"
#include "scene/keyframe_file.hpp"
#include "scene/placement_file.hpp"
#include "settings/surface_fields.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <variant>

namespace drape::scene {
namespace {

/// A path relative to the folder where the file lies below it, or an absolute path.
std::string fileName(const std::string& path, const std::filesystem::path& folder) {
  const std::filesystem::path file = std::filesystem::absolute(path).lexically_normal();
  const std::filesystem::path relative = file.lexically_relative(folder.lexically_normal());
  const bool isBelow = !relative.empty() && *relative.begin() != "..";
  return isBelow ? relative.string() : file.string();
}

void writeShape(const sim::contact::PlaneShape& plane, TomlText& toml) {
  toml.text("shape", "plane");
  toml.number("size", 2.0 * plane.halfSize);
}

void writeShape(const sim::contact::SphereShape& sphere, TomlText& toml) {
  toml.text("shape", "sphere");
  toml.number("radius", sphere.radius);
}

void writeShape(const sim::contact::CapsuleShape& capsule, TomlText& toml) {
  toml.text("shape", "capsule");
  toml.number("radius", capsule.radius);
  toml.number("length", 2.0 * capsule.halfLength);
}

void writeShape(const sim::contact::BoxShape& box, TomlText& toml) {
  toml.text("shape", "box");
  toml.value("size", vectorText(2.0 * box.half));
}

void writeShape(const std::shared_ptr<const sim::contact::MeshShape>& /*mesh*/, TomlText& /*toml*/) {}

void writeFigure(const figure::FigureOptions& figure, TomlText& toml) {
  toml.text("shape", "figure");
  toml.text("motion", figure.motion->name);
  toml.number("speed", figure.speed);
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (const std::optional<double>& size = figure.proportions.*each.value) {
      toml.number(each.key, *size);
    }
  }
}

/// "loop" of frames, of an animation or of a cache; the key of the table itself belongs to the keyframes.
std::string loopText(const BodyDescription& body) {
  return body.frameLoop ? "true" : "false";
}

void writeMesh(const BodyDescription& body, const std::filesystem::path& folder, TomlText& toml) {
  MeshFileSource mesh = body.meshes.front();
  mesh.path = body.framePattern.empty() ? mesh.path : body.framePattern;
  toml.text("shape", "mesh");
  toml.text("mesh", meshName(mesh, folder));
  if (body.scale != 1.0) {
    toml.number("scale", body.scale);
  }
  if (body.animation) {
    const std::string clip = body.animation->clip.empty() ? "" : "clip = " + quotedText(body.animation->clip) + ", ";
    const std::string blend =
        body.animation->blend > 0.0 ? ", blend = " + text::exactNumber(body.animation->blend) : "";
    toml.value("animation", fmt::format("{{ {}rate = {}, loop = {}{} }}", clip, text::exactNumber(body.animation->rate),
                                        loopText(body), blend));
  } else if (body.cache) {
    const std::string rate =
        io::hasOwnTimes(body.cache->path) ? "" : "rate = " + text::exactNumber(body.cache->rate) + ", ";
    toml.value("cache", fmt::format("{{ file = {}, {}loop = {} }}", quotedText(fileName(body.cache->path, folder)),
                                    rate, loopText(body)));
  } else if (!body.framePattern.empty()) {
    const int last = body.firstFrame + static_cast<int>(body.meshes.size()) - 1;
    toml.value("frames", fmt::format("{{ first = {}, last = {}, rate = {}, loop = {} }}", body.firstFrame, last,
                                     rateText(body.frameTime), loopText(body)));
  }
}

void writeMotion(const sim::contact::BodyMotion& motion, TomlText& toml) {
  if (motion.keyframes.size() == 1) {
    const sim::contact::Keyframe& only = motion.keyframes.front();
    toml.value("position", vectorText(only.position));
    if (!only.rotation.isZero(0.0)) {
      toml.value("rotation", degreesText(only.rotation));
    }
  } else {
    writeKeyframes(motion, toml);
  }
  if (!motion.spin.isZero(0.0)) {
    toml.value("spin", degreesText(motion.spin));
  }
}

}  // namespace

std::string meshName(const MeshFileSource& source, const std::filesystem::path& folder) {
  return source.builtIn ? "builtin:" + source.path : fileName(source.path, folder);
}

void writeSurface(const sim::contact::SurfaceProperties& surface, TomlText& toml) {
  if (surface == sim::contact::SurfaceProperties()) {
    return;
  }
  for (const settings::SurfaceField& field : settings::surfaceFields()) {
    toml.number(field.key, surface.*field.value);
  }
}

void writeBody(const BodyDescription& body, const std::filesystem::path& folder, TomlText& toml) {
  toml.table("[[bodies]]");
  toml.text("name", body.body.name);
  if (body.figure) {
    writeFigure(*body.figure, toml);
  } else if (!body.meshes.empty()) {
    writeMesh(body, folder, toml);
  } else {
    std::visit([&](const auto& shape) { writeShape(shape, toml); }, body.body.shape);
  }
  writeMotion(body.body.motion, toml);
  writePlacement(body.placement, toml);
  writeSurface(body.body.surface, toml);
  if (!body.body.drawn) {
    toml.flag("drawn", false);
  }
}

}  // namespace drape::scene
