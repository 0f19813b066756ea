#include "render/camera.hpp"
#include "scene/framing.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>

namespace drape::render {
namespace {

constexpr int width = 640;
constexpr int height = 480;

Camera slantedCamera() {
  scene::CameraPose pose;
  pose.position = {1.3, 2.1, 2.7};
  pose.focalPoint = {0.2, 0.9, -0.1};
  pose.viewAngle = 40.0;
  return Camera(pose);
}

Vec2 projectWithMatrices(const Camera& camera, const Vec3& point) {
  Eigen::Vector4f homogeneous;
  homogeneous << point.cast<float>(), 1.0F;
  const Eigen::Vector4f clip =
      camera.projectionMatrix(static_cast<double>(width) / height) * (camera.viewMatrix() * homogeneous);
  const Vec2 place(static_cast<double>(clip.x() / clip.w()), static_cast<double>(clip.y() / clip.w()));
  return {0.5 * (1.0 + place.x()) * width, 0.5 * (1.0 - place.y()) * height};
}

TEST(Camera, FocalPointIsInTheMiddle) {
  const Camera camera = slantedCamera();
  const Vec2 place = camera.project(camera.pose().focalPoint, width, height);
  EXPECT_NEAR(place.x(), 0.5 * width, 1e-9);
  EXPECT_NEAR(place.y(), 0.5 * height, 1e-9);
}

TEST(Camera, ProjectAgreesWithTheMatrices) {
  const Camera camera = slantedCamera();
  for (const Vec3& point : {Vec3(0.0, 1.0, 0.0), Vec3(0.5, 0.2, 0.3), Vec3(-0.6, 1.4, -2.0)}) {
    const Vec2 direct = camera.project(point, width, height);
    const Vec2 matrices = projectWithMatrices(camera, point);
    EXPECT_NEAR(direct.x(), matrices.x(), 1e-2);
    EXPECT_NEAR(direct.y(), matrices.y(), 1e-2);
  }
}

TEST(Camera, RayThroughAPixelProjectsBackToIt) {
  const Camera camera = slantedCamera();
  for (const Vec2& pixel : {Vec2(0.0, 0.0), Vec2(320.0, 240.0), Vec2(123.4, 456.7), Vec2(639.5, 0.5)}) {
    const Ray ray = camera.rayThrough(pixel.x(), pixel.y(), width, height);
    EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
    const Vec2 back = camera.project(ray.origin + 1.7 * ray.direction, width, height);
    EXPECT_NEAR(back.x(), pixel.x(), 1e-9);
    EXPECT_NEAR(back.y(), pixel.y(), 1e-9);
  }
}

TEST(Camera, AnOrthographicViewAgreesWithItsMatricesAndItsRays) {
  Camera camera = slantedCamera();
  const Vec3 focus = camera.pose().focalPoint;
  const Vec3 beside = focus + Vec3(0.3, 0.2, -0.1);
  camera.useOrthographic(true);
  for (const Vec3& point : {focus, beside, Vec3(1.5, 2.3, 3.0)}) {
    const Vec2 place = camera.project(point, width, height);
    EXPECT_LT((place - projectWithMatrices(camera, point)).norm(), 1e-2);
    const Ray ray = camera.rayThrough(place.x(), place.y(), width, height);
    EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9);
    EXPECT_GT((point - ray.origin).dot(ray.direction), 0.0) << "also behind the camera";
    EXPECT_LT((camera.pointAtDepthOf(point, place.x(), place.y(), width, height) - point).norm(), 1e-9);
  }
}

TEST(Camera, AnOrthographicViewShowsTheFocalPlaneAtTheSameSizeAndDepthDoesNotMatter) {
  Camera camera = slantedCamera();
  const scene::CameraBasis basis = scene::basisOf(camera.pose());
  const Vec3 beside = camera.pose().focalPoint + 0.4 * basis.right;
  const Vec2 before = camera.project(beside, width, height);
  camera.useOrthographic(true);
  EXPECT_LT((camera.project(beside, width, height) - before).norm(), 1e-9);
  EXPECT_LT((camera.project(beside + 0.7 * basis.back, width, height) - before).norm(), 1e-9);
}

TEST(Camera, UpIsUpAndRightIsRight) {
  const Camera camera = slantedCamera();
  const Vec3 focal = camera.pose().focalPoint;
  EXPECT_LT(camera.project(focal + Vec3(0.0, 0.1, 0.0), width, height).y(), 0.5 * height);
  const Vec3 right = Vec3::UnitY().cross(camera.pose().position - focal).normalized();
  EXPECT_GT(camera.project(focal + 0.1 * right, width, height).x(), 0.5 * width);
}

TEST(Camera, OrbitKeepsDistanceAndFocalPoint) {
  Camera camera = slantedCamera();
  const scene::CameraPose before = camera.pose();
  camera.orbit(0.7, -0.3);
  EXPECT_EQ(camera.pose().focalPoint, before.focalPoint);
  EXPECT_NEAR((camera.pose().position - before.focalPoint).norm(), (before.position - before.focalPoint).norm(), 1e-12);
  camera.orbit(-0.7, 0.3);
  EXPECT_LT((camera.pose().position - before.position).norm(), 1e-12);
}

TEST(Camera, PositiveYawGoesRightAndPositivePitchUp) {
  Camera camera;
  camera.orbit(0.2, 0.1);
  EXPECT_GT(camera.pose().position.x(), 0.0);
  EXPECT_GT(camera.pose().position.y(), scene::CameraPose{}.position.y());
}

TEST(Camera, OrbitNeverGoesOverThePoles) {
  for (const double pitch : {100.0, -100.0, 1.58, -1.58}) {
    Camera camera = slantedCamera();
    for (int i = 0; i < 5; ++i) {
      camera.orbit(0.1, pitch);
    }
    // The up direction of the screen still has an upward part in the world.
    EXPECT_GT(camera.viewMatrix()(1, 1), 0.0F);
    EXPECT_TRUE(camera.pose().position.allFinite());
  }
}

TEST(Camera, LookingStraightDownIsDefined) {
  scene::CameraPose pose;
  pose.position = {0.0, 3.0, 0.0};
  pose.focalPoint = {0.0, 0.0, 0.0};
  const Camera camera(pose);
  EXPECT_TRUE(camera.viewMatrix().allFinite());
  EXPECT_GT(camera.project({0.5, 0.0, 0.0}, width, height).x(), 0.5 * width);
}

TEST(Camera, PanMovesByFractionsOfTheView) {
  Camera camera = slantedCamera();
  const Vec3 focal = camera.pose().focalPoint;
  camera.pan(0.25, 0.5);
  const Vec2 place = camera.project(focal, width, height);
  EXPECT_NEAR(place.x(), 0.5 * width - 0.25 * height, 1e-9);
  EXPECT_NEAR(place.y(), height, 1e-9);
}

TEST(Camera, ZoomIsClamped) {
  Camera camera = slantedCamera();
  const auto distance = [&camera] { return (camera.pose().position - camera.pose().focalPoint).norm(); };
  const double before = distance();
  camera.zoom(0.5);
  EXPECT_NEAR(distance(), 0.5 * before, 1e-12);
  camera.zoom(1e-9);
  EXPECT_NEAR(distance(), scene::minViewDistance, 1e-9);
  camera.zoom(1e12);
  EXPECT_NEAR(distance(), scene::maxViewDistance, 1e-6);
}

TEST(Camera, RecentreKeepsDirectionAndDistance) {
  Camera camera = slantedCamera();
  const Vec3 offset = camera.pose().position - camera.pose().focalPoint;
  camera.recentre({1.0, 2.0, 3.0});
  EXPECT_EQ(camera.pose().focalPoint, Vec3(1.0, 2.0, 3.0));
  EXPECT_LT((camera.pose().position - camera.pose().focalPoint - offset).norm(), 1e-12);
}

TEST(Camera, SidesLookAlongTheAxes) {
  Camera camera = slantedCamera();
  const auto back = [&camera] { return (camera.pose().position - camera.pose().focalPoint).normalized(); };
  camera.lookFrom(Camera::Side::Front);
  EXPECT_GT(back().z(), 0.999);
  camera.lookFrom(Camera::Side::Right);
  EXPECT_GT(back().x(), 0.999);
  camera.lookFrom(Camera::Side::Top);
  EXPECT_GT(back().y(), 0.999);
}

class CameraFrame : public testing::TestWithParam<double> {};

TEST_P(CameraFrame, BoxFitsAndFillsTheView) {
  const double aspect = GetParam();
  const int wide = static_cast<int>(std::lround(height * aspect));
  const Vec3 min(-0.3, 0.1, -0.9);
  const Vec3 max(0.5, 1.6, 0.2);
  Camera camera = slantedCamera();
  camera.frame(min, max, aspect);
  double fill = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? max.x() : min.x(), (corner & 2) != 0 ? max.y() : min.y(),
                     (corner & 4) != 0 ? max.z() : min.z());
    const Vec2 place = camera.project(point, wide, height);
    const double across = std::abs(2.0 * place.x() / wide - 1.0);
    const double upwards = std::abs(2.0 * place.y() / height - 1.0);
    EXPECT_LE(across, 1.0);
    EXPECT_LE(upwards, 1.0);
    fill = std::max({fill, across, upwards});
  }
  EXPECT_GT(fill, 0.75);
}

INSTANTIATE_TEST_SUITE_P(Aspects, CameraFrame, testing::Values(0.5, 1.0, 16.0 / 9.0));

TEST(Camera, FramingAPointIsDefined) {
  Camera camera = slantedCamera();
  camera.frame({1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 1.5);
  EXPECT_TRUE(camera.pose().position.allFinite());
  EXPECT_GT((camera.pose().position - camera.pose().focalPoint).norm(), 0.0);
}

TEST(Camera, PointAtDepthLiesUnderThePixelAndAsDeep) {
  const Camera camera = slantedCamera();
  const Vec3 reference(0.3, 1.2, 0.4);
  const Vec3 point = camera.pointAtDepthOf(reference, 100.0, 300.0, width, height);
  const Vec2 place = camera.project(point, width, height);
  EXPECT_NEAR(place.x(), 100.0, 1e-9);
  EXPECT_NEAR(place.y(), 300.0, 1e-9);
  const Vec3 forward = (camera.pose().focalPoint - camera.pose().position).normalized();
  EXPECT_NEAR(forward.dot(point - reference), 0.0, 1e-12);
}

TEST(Camera, PointsBehindTheCameraProjectOutside) {
  const Camera camera;
  const Vec2 place = camera.project({0.5, 1.5, 10.0}, width, height);
  EXPECT_TRUE(std::abs(place.x()) > 1e6 || std::abs(place.y()) > 1e6);
}

}  // namespace
}  // namespace drape::render
