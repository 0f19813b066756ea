#include "io/garments/garments.hpp"
#include "io/obj_writer.hpp"

namespace drape::io {
namespace {

constexpr std::string_view comment = "Made by drape-make-garments. Metres, y up. Change the program, not this file.";

GarmentFile clothFile(const std::string& name, const RawMesh& raw) {
  const ImportedMesh mesh = weldMesh(raw, name, {});
  return {name, objText(mesh.cloth.positions, mesh.render, comment)};
}

/// A solid for drawing, without texture coordinates.
GarmentFile solidFile(const std::string& name, const RawMesh& raw) {
  const sim::ClothMesh mesh = weldMesh(raw, name, {}).cloth;
  RenderMesh render;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    render.particle.push_back(static_cast<int>(i));
  }
  render.triangles = mesh.triangles;
  return {name, objText(mesh.positions, render, comment)};
}

}  // namespace

std::vector<GarmentFile> garmentFiles() {
  return {clothFile("skirt.obj", makeSkirt()),
          clothFile("poncho.obj", makePoncho()),
          clothFile("tshirt.obj", makeTshirt()),
          clothFile("cape.obj", makeCape()),
          clothFile("short_tshirt.obj", makeShortTshirt()),
          clothFile("fitted_skirt.obj", makeFittedSkirt()),
          clothFile("dress.obj", makeDress()),
          clothFile("dress_pattern.obj", makeDressPattern()),
          solidFile("stand.obj", makeSkirtStand()),
          solidFile("hanger.obj", makeHangerStand()),
          solidFile("pole.obj", makeFlagPole()),
          solidFile("rail.obj", makeCurtainRail()),
          solidFile("table.obj", makeTable()),
          solidFile("mannequin.obj", makeMannequin()),
          solidFile("figure.obj", makeFigure()),
          solidFile("skater.obj", makeSkater())};
}

}  // namespace drape::io
