#include "figure/moving_figure.hpp"

#include "figure/periodic_curve.hpp"

#include <utility>

namespace drape::figure {
namespace {

FigureShape between(const FigureShape& first, const FigureShape& second, double fraction) {
  FigureShape result;
  for (std::size_t j = 0; j < jointCount; ++j) {
    result.places[j] = (1.0 - fraction) * first.places[j] + fraction * second.places[j];
  }
  result.positions.resize(first.positions.size());
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    result.positions[v] = (1.0 - fraction) * first.positions[v] + fraction * second.positions[v];
  }
  return result;
}

class FigureDeformation final : public sim::contact::Deformation {
 public:
  FigureDeformation(const sim::contact::MeshShape& mesh, const FigureOptions& options)
      : motion_(*options.motion),
        speed_(options.speed),
        weights_(smoothWeights(mesh.positions, mesh.triangles)),
        built_{restPlaces(), mesh.positions},
        sized_(withProportions(built_, mesh.triangles, weights_, options.proportions)) {}

  void positionsAt(double time, std::vector<Vec3>& positions) const override {
    if (!(time > 0.0)) {
      positions = built_.positions;
      return;
    }
    positions.resize(built_.positions.size());
    const double share = smoothStep(time / blendTime);
    if (share < 1.0) {
      move(between(built_, sized_, share), time, share, positions);
    } else {
      move(sized_, time, share, positions);
    }
  }

 private:
  void move(const FigureShape& shape, double time, double share, std::vector<Vec3>& positions) const {
    const double phase = fractionOf(time * speed_ / motion_.period);
    const FigurePose pose = blended(FigurePose{}, motion_.pose(shape.places, phase), share);
    moveSkin(shape.places, jointPoses(shape.places, pose), weights_, shape.positions, positions);
  }

  Motion motion_;
  double speed_;
  std::vector<SkinWeights> weights_;
  FigureShape built_;
  FigureShape sized_;
};

}  // namespace

std::shared_ptr<const sim::contact::MeshShape> movingFigure(std::vector<Vec3> positions,
                                                            std::vector<Triangle> triangles,
                                                            const FigureOptions& options) {
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = std::move(positions);
  shape->triangles = std::move(triangles);
  shape->deformation = std::make_shared<FigureDeformation>(*shape, options);
  return shape;
}

}  // namespace drape::figure
