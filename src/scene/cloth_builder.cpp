#include "scene/cloth_builder.hpp"

#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "scene/cloth_material.hpp"
#include "scene/cloth_start.hpp"
#include "scene/elastic_bands.hpp"
#include "scene/grid_mesh.hpp"
#include "scene/mass.hpp"
#include "scene/mesh_file.hpp"
#include "scene/pin_selection.hpp"
#include "scene/shape_pins.hpp"
#include "scene/subdivision.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

namespace drape::scene {
namespace {

io::ImportOptions importOptions(const settings::Settings& settings, const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.metresPerUnit = metresPerUnitOf(settings.mesh);
  options.weldTolerance = settings.mesh.weldTolerance;
  options.outliers = outlierRule(settings);
  options.watch = watch;
  return options;
}

/// The mesh of one cloth, the layout of a grid, and how a file was read.
struct Source {
  io::ImportedMesh mesh;
  std::optional<GridLayout> grid;
  std::optional<MeshReading> reading;
};

Source makeSource(const ClothDescription& cloth, const settings::Settings& settings, const io::ImportWatch& watch) {
  if (const auto* grid = std::get_if<GridSource>(&cloth.source)) {
    const GridLayout layout = layoutOf(settings.grid);
    return {makeGrid(layout, grid->plane), layout, std::nullopt};
  }
  const auto& file = std::get<MeshFileSource>(cloth.source);
  Source source{readMesh(file, importOptions(settings, watch)), std::nullopt, std::nullopt};
  source.reading = readUpright(settings.mesh, source.mesh);
  return source;
}

/// What moves pins which the settings choose: that of the cloth's pins, if all have the same.
PinGroup motionOfAll(const std::vector<PinSelection>& pins) {
  const bool areAlike = std::all_of(
      pins.begin(), pins.end(), [&](const auto& p) { return p.body == pins[0].body && p.motion == pins[0].motion; });
  return !pins.empty() && areAlike ? PinGroup{{}, pins[0].body, pins[0].motion} : PinGroup{};
}

std::vector<PinSelection> pinsInForce(const ClothDescription& cloth, const settings::Settings& settings) {
  if (settings.mesh.pins == "scene") {
    return cloth.pins;
  }
  PinSelection pins;
  if (settings.mesh.pins == "top") {
    pins.top = topOfBareMesh;
  }
  const PinGroup all = motionOfAll(cloth.pins);
  pins.body = all.body;
  pins.motion = all.motion;
  return {pins};
}

std::vector<int> selectedBy(const PinSelection& pins, const Source& source) {
  return selectPins(pins, source.mesh.cloth.positions, source.grid ? &*source.grid : nullptr);
}

/// The pins of a cloth in groups, by the indices of its own mesh. Each vertex is in the first group that selects it.
std::vector<PinGroup> choosePins(const ClothDescription& cloth, const settings::Settings& settings,
                                 const Source& source) {
  if (cloth.frozen) {
    PinGroup all;
    all.vertices.resize(source.mesh.cloth.positions.size());
    std::iota(all.vertices.begin(), all.vertices.end(), 0);
    return {all};
  }
  if (settings.mesh.pins == "shape") {
    PinGroup group = motionOfAll(cloth.pins);
    group.vertices = pinsByShape(source.mesh.cloth);
    return {group};
  }
  std::vector<PinGroup> groups;
  std::vector<char> isTaken(source.mesh.cloth.positions.size(), 0);
  for (const PinSelection& pins : pinsInForce(cloth, settings)) {
    PinGroup& group = groups.emplace_back();
    group.body = pins.body;
    group.motion = pins.motion;
    for (const int vertex : selectedBy(pins, source)) {
      if (std::exchange(isTaken[vertex], 1) == 0) {
        group.vertices.push_back(vertex);
      }
    }
  }
  return groups;
}

/// Moves the mesh to its position in the scene.
void placeCloth(const ClothDescription& cloth, std::vector<Vec3>& positions) {
  const sim::contact::Pose pose = sim::contact::poseOf(cloth.position, cloth.rotation);
  for (Vec3& position : positions) {
    position = pose.toWorld(position);
  }
}

/// How the coordinates of a file with the start become those of the scene.
MeshPlacement startPlacementOf(const ClothDescription& description, const std::optional<MeshReading>& reading) {
  const sim::contact::Pose placement = description.placement.pose();
  if (!reading) {
    return {.pose = placement};  // a grid has the coordinates of the scene before its placement
  }
  const sim::contact::Pose own = sim::contact::poseOf(description.position, description.rotation);
  return {reading->metresPerUnit,
          reading->up,
          {(placement.rotation * own.rotation).normalized(), placement.toWorld(own.position)},
          1.0};
}

/// The positions of a file with the start, before the placement of the cloth. @param source not divided
std::vector<Vec3> startInScene(const ClothDescription& cloth, const Source& source, const io::ImportWatch& watch) {
  const MeshPlacement inScene = startPlacementOf(cloth, source.reading);
  const sim::contact::Pose placement = cloth.placement.pose();
  std::vector<Vec3> start = startOfFile(*cloth.start, *source.mesh.file, source.mesh.cloth.positions.size(), watch);
  for (Vec3& position : start) {
    position = placement.toLocal(inScene.toScene(position));
  }
  return start;
}

/// Adds the middles of the edges between positions.
void appendMiddles(std::span<const Midpoint> midpoints, std::vector<Vec3>& positions) {
  for (const Midpoint& midpoint : midpoints) {
    const Vec3 middle = 0.5 * (positions[midpoint.a] + positions[midpoint.b]);
    positions.push_back(middle);
  }
}

std::vector<Vec3> startPositions(const ClothDescription& cloth, const Source& source) {
  std::vector<Vec3> positions = source.mesh.cloth.positions;
  if (cloth.pleats && source.grid) {
    applyPleats(*cloth.pleats, source.grid->width, positions);
  }
  placeCloth(cloth, positions);
  return positions;
}

void appendTriangles(const std::vector<Triangle>& triangles, int offset, std::vector<Triangle>& all) {
  for (const auto& [a, b, c] : triangles) {
    all.push_back({a + offset, b + offset, c + offset});
  }
}

void appendRenderMesh(const io::RenderMesh& mesh, int firstParticle, io::RenderMesh& all) {
  const auto offset = static_cast<int>(all.particle.size());
  all.uvsInMetres = mesh.uvsInMetres;
  all.uvs.insert(all.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
  std::ranges::transform(mesh.particle, std::back_inserter(all.particle), [&](int p) { return p + firstParticle; });
  appendTriangles(mesh.triangles, offset, all.triangles);
}

/// Adds the counts and warnings of a cloth to those of all. The size is set at the end.
void addSummary(const std::string& cloth, const io::MeshSummary& own, io::MeshSummary& all) {
  all.source += (all.source.empty() ? "" : " + ") + own.source;
  for (int io::MeshSummary::*const count :
       {&io::MeshSummary::verticesInFile, &io::MeshSummary::vertices, &io::MeshSummary::triangles,
        &io::MeshSummary::springs, &io::MeshSummary::degenerateFaces, &io::MeshSummary::duplicateFaces,
        &io::MeshSummary::facesSkipped, &io::MeshSummary::isolatedVertices, &io::MeshSummary::outliers,
        &io::MeshSummary::shortEdges, &io::MeshSummary::shortEdgesKept, &io::MeshSummary::components,
        &io::MeshSummary::boundaryLoops, &io::MeshSummary::nonManifoldEdges, &io::MeshSummary::misorientedEdges}) {
    all.*count += own.*count;
  }
  all.hasSkin = all.hasSkin || own.hasSkin;
  const std::string prefix = cloth.empty() ? "" : cloth + ": ";
  for (const std::string& warning : own.warnings) {
    all.warnings.push_back(prefix);
    all.warnings.back() += warning;
  }
}

/// The positions in the size of a placement.
std::vector<Vec3> sized(std::vector<Vec3> positions, double scale) {
  for (Vec3& position : positions) {
    position *= scale;
  }
  return positions;
}

/// How the coordinates of a cloth's file become those of the scene.
MeshPlacement placementOf(const ClothDescription& description, const MeshReading& reading) {
  const sim::contact::Pose own = sim::contact::poseOf(description.position, description.rotation);
  const Placement& placement = description.placement;
  if (placement.isNone()) {
    return {reading.metresPerUnit, reading.up, own};
  }
  const sim::contact::Pose pose = placement.pose();
  return {reading.metresPerUnit,
          reading.up,
          {(pose.rotation * own.rotation).normalized(), pose.toWorld(placement.scale * own.position)},
          placement.scale};
}

ClothPart partFor(const ClothDescription& description, const Source& source, const JoinedCloths& joined) {
  ClothPart part;
  part.scale = description.placement.scale;
  part.name = description.name;
  part.own = description.own;
  part.bands = bandsOf(description.bands, source.mesh.cloth);
  part.firstVertex = static_cast<int>(joined.mesh.positions.size());
  part.vertexCount = static_cast<int>(source.mesh.cloth.positions.size());
  part.firstTriangle = static_cast<int>(joined.mesh.triangles.size());
  part.triangleCount = static_cast<int>(source.mesh.cloth.triangles.size());
  part.firstRenderVertex = static_cast<int>(joined.renderMesh.particle.size());
  part.renderVertexCount = static_cast<int>(source.mesh.render.particle.size());
  part.file = source.mesh.file;
  if (source.reading) {
    part.placement = placementOf(description, *source.reading);
  }
  part.startPlacement = startPlacementOf(description, source.reading);
  part.uvs.ofGrid = source.grid.has_value();
  if (!source.grid) {
    part.uvs = patternUvsOf(source.mesh.render, sized(source.mesh.cloth.positions, part.scale));
  }
  return part;
}

/// The pins of a cloth in the scene, with the middles of the edges between them.
std::vector<PinGroup> pinsOf(const ClothDescription& description, const settings::Settings& settings, Source source,
                             std::span<const Midpoint> midpoints) {
  placeCloth(description, source.mesh.cloth.positions);
  std::vector<PinGroup> groups = choosePins(description, settings, source);
  for (PinGroup& group : groups) {
    addMidpoints(midpoints, group.vertices);
  }
  return groups;
}

void appendPins(std::vector<PinGroup> groups, int offset, std::vector<PinGroup>& all) {
  for (PinGroup& group : groups) {
    for (int& vertex : group.vertices) {
      vertex += offset;
    }
    all.push_back(std::move(group));
  }
}

void appendCloth(const ClothDescription& description, const settings::Settings& settings, Source source,
                 const io::ImportWatch& watch, JoinedCloths& joined) {
  std::vector<Vec3> start;
  if (description.start) {
    start = startInScene(description, source, watch);
  }
  SubdividedMesh divided = subdivided(source.mesh, settings.mesh.subdivide);
  std::vector<PinGroup> pins = pinsOf(description, settings, source, divided.midpoints);
  source.mesh = std::move(divided.mesh);
  if (description.start) {
    appendMiddles(divided.midpoints, start);
  } else {
    start = startPositions(description, source);
  }
  placeCloth(description, source.mesh.cloth.positions);
  const ClothPart part = partFor(description, source, joined);
  appendPins(std::move(pins), part.firstVertex, joined.pins);
  appendTriangles(source.mesh.cloth.triangles, part.firstVertex, joined.mesh.triangles);
  const std::vector<Vec3>& rest = source.mesh.cloth.positions;
  joined.mesh.positions.insert(joined.mesh.positions.end(), rest.begin(), rest.end());
  joined.unplacedStart.insert(joined.unplacedStart.end(), start.begin(), start.end());
  Placement placement = description.placement;
  placement.scale = description.start ? 1.0 : placement.scale;  // a file with the start has its own size
  const std::vector<Vec3> placed = placement.applied(start);
  joined.start.insert(joined.start.end(), placed.begin(), placed.end());
  appendRenderMesh(source.mesh.render, part.firstVertex, joined.renderMesh);
  addSummary(description.name, source.mesh.summary, joined.summary);
  const auto* file = std::get_if<MeshFileSource>(&description.source);
  const bool isOwnFile = file != nullptr && !file->builtIn;
  if (!joined.reading || (isOwnFile && !joined.showsReading)) {
    joined.reading = source.reading;
    joined.showsReading = isOwnFile;
  }
  joined.cloths.push_back(part);
}

/// The size of the box around all cloths, unless there is one, whose size is known.
void setSize(JoinedCloths& joined, const io::MeshSummary& first) {
  joined.summary.size = first.size;
  for (double& side : joined.summary.size) {
    side *= joined.cloths.front().scale;
  }
  joined.summary.shortEdge = first.shortEdge;
  if (joined.cloths.size() > 1) {
    const Vec3 size = sim::boundsOf(joined.mesh.positions).sizes();
    joined.summary.size = {size.x(), size.y(), size.z()};
  }
}

/// The rest shape in the sizes of the placements. It keeps its direction, so that warp stays where it is in the cloth.
sim::ClothMesh sizedMesh(const JoinedCloths& joined) {
  sim::ClothMesh mesh = joined.mesh;
  for (const ClothPart& cloth : joined.cloths) {
    for (int v = cloth.firstVertex; v < cloth.firstVertex + cloth.vertexCount; ++v) {
      mesh.positions[v] *= cloth.scale;
    }
  }
  return mesh;
}

/// The stiffness of the springs of each cloth over that of the scene [-].
std::vector<double> relativeStiffness(std::span<const ClothPart> cloths, const settings::Settings& settings) {
  const double common = settings.step.material.stiffness;
  std::vector<double> relative;
  for (const ClothPart& cloth : cloths) {
    const double own = settingsOf(cloth.own, settings).step.material.stiffness;
    if (own != common && !(common > 0.0)) {
      throw messages::InputError("the cloth \"" + cloth.name +
                                 "\" has its own stiffness, so the stiffness of the scene must be above 0");
    }
    relative.push_back(own == common ? 1.0 : own / common);
  }
  return relative;
}

std::shared_ptr<const sim::ClothModel> withOwnStiffness(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                                        const settings::Settings& settings) {
  const std::vector<double> ofCloth = relativeStiffness(cloths, settings);
  if (std::ranges::all_of(ofCloth, [](double relative) { return relative == 1.0; })) {
    return model.shared_from_this();
  }
  std::vector<double> relative;
  relative.reserve(model.springs.size());
  for (const sim::Spring& spring : model.springs) {
    relative.push_back(ofCloth[model.clothOf.empty() ? 0 : model.clothOf[spring.a]]);
  }
  return sim::withSpringStiffness(model, relative);
}

std::shared_ptr<const sim::ClothModel> withSeveralCloths(const sim::ClothModel& model,
                                                         std::span<const ClothPart> cloths) {
  if (cloths.size() == 1) {
    return model.shared_from_this();
  }
  std::vector<int> clothOf;
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    clothOf.insert(clothOf.end(), cloths[i].vertexCount, static_cast<int>(i));
  }
  return sim::withCloths(model, std::move(clothOf));
}

}  // namespace

std::vector<int> JoinedCloths::pinned() const {
  std::vector<int> all;
  for (const PinGroup& group : pins) {
    all.insert(all.end(), group.vertices.begin(), group.vertices.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

JoinedCloths joinCloths(const SceneDescription& description, const settings::Settings& settings,
                        const io::ImportWatch& watch) {
  JoinedCloths joined;
  const auto count = static_cast<double>(description.cloths.size());
  io::MeshSummary first;
  for (const ClothDescription& cloth : description.cloths) {
    const auto done = static_cast<double>(joined.cloths.size());
    const settings::Settings own = settingsOf(cloth.own, settings);
    Source source = makeSource(cloth, own, watch.part(done / count, (done + 1.0) / count));
    if (joined.cloths.empty()) {
      first = source.mesh.summary;
    }
    appendCloth(cloth, own, std::move(source), watch, joined);
  }
  setSize(joined, first);
  return joined;
}

std::shared_ptr<const sim::ClothModel> modelOf(const JoinedCloths& joined, const settings::Settings& settings) {
  return messages::withInputErrors([&] {
    const sim::ClothMesh mesh = sizedMesh(joined);
    const auto area = sim::restAreaOf(mesh);
    auto model = sim::buildClothModel(mesh, totalMassOf(settings, area), lumpingOf(settings), joined.pinned());
    model = withMasses(*withSeveralCloths(*model, joined.cloths), joined.cloths, settings);
    return withMaterial(*withOwnStiffness(*model, joined.cloths, settings), joined.cloths, settings);
  });
}

}  // namespace drape::scene
