// The work of the drawing thread for each new snapshot: normals and curvatures of all vertices, and their upload to the
// graphics card (here OSMesa).
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "render/osmesa_context.hpp"
#include "render/smooth_mesh.hpp"

namespace drape::bench {
namespace {

constexpr int side = 225;  // 100,352 triangles

struct Drawn {
  sim::ClothMesh mesh;
  std::vector<Vec3> positions;
  render::SurfaceShapes shapes;
};

std::shared_ptr<Drawn> drawn() {
  auto result = std::make_shared<Drawn>();
  result->mesh = gridMesh(side);
  result->positions = waving(*grid(side)).positions;
  return result;
}

}  // namespace

void addViewerGroup(Suite& suite) {
  suite.add({"viewer", "normals and curvatures, 100,352 triangles", "ms/frame"}, []() -> Batch {
    return {1.0, [input = drawn()] {
              return threadSeconds([&] { input->shapes.compute(input->positions, input->mesh.triangles); });
            }};
  });
  suite.add({"viewer", "the same with the upload (SmoothMesh)", "ms/frame", Bound{Bound::Side::AtMost, 2.0}},
            []() -> Batch {
              struct Card {
                render::OsmesaContext context;
                render::SmoothMesh mesh;
              };
              auto card = std::make_shared<Card>();
              const auto input = drawn();
              card->mesh.setTopology({input->mesh.triangles, input->mesh.triangles, {}, {}});
              return {1.0, [card, input] { return threadSeconds([&] { card->mesh.setPositions(input->positions); }); }};
            });
}

}  // namespace drape::bench
