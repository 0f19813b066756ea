#include "report/validation/closed_forms.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>

/// Closed forms that need more than a formula: lateral buckling, and the elastica that stands on a floor.
namespace drape::report::validation {
namespace {

using Eigen::MatrixXd;
using Vector3 = Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;

/// Cubic shape functions of an element of the length h, of value and slope at its two ends, and their derivatives.
struct Cubics {
  Vector4 values;
  Vector4 slopes;
  Vector4 curvatures;

  /// @param t place in the element, 0 to 1
  Cubics(double t, double h)
      : values(1.0 - t * t * (3.0 - 2.0 * t), h * t * (1.0 - t) * (1.0 - t), t * t * (3.0 - 2.0 * t),
               h * t * t * (t - 1.0)),
        slopes(-6.0 * t * (1.0 - t) / h, (1.0 - t) * (1.0 - 3.0 * t), 6.0 * t * (1.0 - t) / h, t * (3.0 * t - 2.0)),
        curvatures((12.0 * t - 6.0) / (h * h), (6.0 * t - 4.0) / h, (6.0 - 12.0 * t) / (h * h), (6.0 * t - 2.0) / h) {}
};

/// Places and weights of Gauss's quadrature with four points on 0 to 1.
constexpr std::array<std::array<double, 2>, 4> gaussPoints{{{0.069431844202973712, 0.17392742256872693},
                                                            {0.33000947820757187, 0.32607257743127307},
                                                            {0.66999052179242813, 0.32607257743127307},
                                                            {0.93056815579702629, 0.17392742256872693}}};

}  // namespace

double lateralBucklingNumber(double warping) {
  constexpr int elements = 100;
  constexpr double h = 1.0 / elements;
  MatrixXd elastic = MatrixXd::Zero(2 * elements + 2, 2 * elements + 2);
  MatrixXd released = elastic;  // per k^2
  for (int element = 0; element < elements; ++element) {
    for (const auto& [t, weight] : gaussPoints) {
      const Cubics cubics(t, h);
      const double s = (element + t) * h;
      elastic.block<4, 4>(2 * element, 2 * element) +=
          h * weight *
          (cubics.slopes * cubics.slopes.transpose() + warping * cubics.curvatures * cubics.curvatures.transpose());
      released.block<4, 4>(2 * element, 2 * element) +=
          h * weight * std::pow(s, 4) * cubics.values * cubics.values.transpose();
    }
  }
  // At the clamp, s = 1, the strip does not twist. If it resists warping, the rate of its twist is zero there too.
  if (warping == 0.0) {
    const int slope = 2 * elements + 1;
    const int twist = 2 * elements;
    elastic.row(twist).swap(elastic.row(slope));
    elastic.col(twist).swap(elastic.col(slope));
    released.row(twist).swap(released.row(slope));
    released.col(twist).swap(released.col(slope));
  }
  const int free = 2 * elements + (warping == 0.0 ? 1 : 0);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
      released.topLeftCorner(free, free), elastic.topLeftCorner(free, free), Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  return 2.0 / std::sqrt(solver.eigenvalues().maxCoeff());
}

double lateralBucklingWeight(double bending, double twisting, double width, double length) {
  const double lateral = bending * width;
  const double torsional = 4.0 * twisting * width;
  const double warping = bending * std::pow(width, 3) / 12.0 / (torsional * length * length);
  return lateralBucklingNumber(warping) * std::sqrt(lateral * torsional) / std::pow(length, 3) / width;
}

namespace {

/// Slope, curvature and place of the standing elastica, from the floor.
using ElasticaState = Vector4;

/// The unknowns of the standing elastica: the slope at the floor and the forces p and q.
using ElasticaUnknowns = Vector3;

/// What must vanish at the clamp: slope, distance aside, and the error of the height.
Vector3 errorAtClamp(const ElasticaUnknowns& unknowns, double shortening) {
  constexpr int steps = 400;
  constexpr double h = 1.0 / steps;
  const auto rate = [&](const ElasticaState& at) {
    return ElasticaState(at[1], -unknowns[1] * std::sin(at[0]) + unknowns[2] * std::cos(at[0]), std::sin(at[0]),
                         std::cos(at[0]));
  };
  ElasticaState state(unknowns[0], 0.0, 0.0, 0.0);
  for (int i = 0; i < steps; ++i) {  // Runge-Kutta of order 4
    const ElasticaState first = rate(state);
    const ElasticaState second = rate(state + 0.5 * h * first);
    const ElasticaState third = rate(state + 0.5 * h * second);
    const ElasticaState fourth = rate(state + h * third);
    state += h / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
  }
  return {state[0], state[2], state[3] - (1.0 - shortening)};
}

/// Newton's method with differences for the derivative.
ElasticaUnknowns solvedElastica(ElasticaUnknowns unknowns, double shortening) {
  constexpr int iterations = 12;
  constexpr double difference = 1e-6;
  for (int i = 0; i < iterations; ++i) {
    const Vector3 error = errorAtClamp(unknowns, shortening);
    Eigen::Matrix3d derivative;
    for (int k = 0; k < 3; ++k) {
      ElasticaUnknowns changed = unknowns;
      changed[k] += difference;
      derivative.col(k) = (errorAtClamp(changed, shortening) - error) / difference;
    }
    unknowns -= derivative.inverse() * error;
  }
  return unknowns;
}

}  // namespace

double frictionOfPressedStrip(double shortening) {
  // The shape of small deflections is a (sin(k s) - s sin(k)) with k = tan(k); its ends approach by half the integral
  // of the squared slope, a^2 k^2 (1/2 - cos(k)^2 / 2) / 2 with sin(k) = k cos(k).
  constexpr double k = 4.493409457909064;
  constexpr int stages = 20;
  const double first = shortening / stages;
  const double slopes = 0.5 * k * k * (0.5 - 0.5 * std::cos(k) * std::cos(k));
  const double amplitude = std::sqrt(first / slopes);
  ElasticaUnknowns unknowns(amplitude * (k - std::sin(k)), k * k, -amplitude * k * k * std::sin(k));
  for (int stage = 1; stage <= stages; ++stage) {
    unknowns = solvedElastica(unknowns, stage * first);
  }
  return std::abs(unknowns[2]) / unknowns[1];
}

}  // namespace drape::report::validation
