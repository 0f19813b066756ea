#include "report/validation/closed_forms.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace drape::report::validation {
namespace {

/// Slope, curvature and position along the elastica, from its tip. The slope phi = pi / 2 - theta is that from the
/// vertical, which turns the equation into phi'' = Gamma t sin(phi) with t the distance from the tip.
struct ElasticaPoint {
  double phi = 0.0;
  double curvature = 0.0;
  double along = 0.0;
  double down = 0.0;
};

ElasticaPoint advanced(const ElasticaPoint& point, const ElasticaPoint& rate, double step) {
  return {.phi = point.phi + step * rate.phi,
          .curvature = point.curvature + step * rate.curvature,
          .along = point.along + step * rate.along,
          .down = point.down + step * rate.down};
}

/// The elastica at the clamp, from its slope at the tip; Runge-Kutta of order 4. It ends early where phi exceeds pi /
/// 2: behind that point it would turn upwards.
ElasticaPoint clampOfElastica(double gamma, double phi) {
  constexpr int steps = 1000;
  constexpr double h = 1.0 / steps;
  const auto rate = [gamma](double t, const ElasticaPoint& at) {
    return ElasticaPoint{.phi = at.curvature,
                         .curvature = gamma * t * std::sin(at.phi),
                         .along = std::sin(at.phi),
                         .down = std::cos(at.phi)};
  };
  ElasticaPoint point{.phi = phi};
  for (int i = 0; i < steps && point.phi <= 0.5 * std::numbers::pi; ++i) {
    const double t = i * h;
    const ElasticaPoint first = rate(t, point);
    const ElasticaPoint second = rate(t + 0.5 * h, advanced(point, first, 0.5 * h));
    const ElasticaPoint third = rate(t + 0.5 * h, advanced(point, second, 0.5 * h));
    const ElasticaPoint fourth = rate(t + h, advanced(point, third, h));
    point = advanced(point, first, h / 6.0);
    point = advanced(point, second, h / 3.0);
    point = advanced(point, third, h / 3.0);
    point = advanced(point, fourth, h / 6.0);
  }
  return point;
}

/// The zero of a function that is negative below it and positive above it, by bisection.
double zeroOf(const std::function<double(double)>& function, double low, double high) {
  constexpr int halvings = 64;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double ElasticaTip::chordAngle() const {
  return std::atan2(down, along);
}

ElasticaTip heavyElasticaTip(double gamma) {
  // The slope at the clamp rises with that at the tip as long as it stays below pi / 2.
  constexpr double horizontal = 0.5 * std::numbers::pi;
  const double tip =
      zeroOf([gamma](double phi) { return clampOfElastica(gamma, phi).phi - horizontal; }, 0.0, horizontal);
  const ElasticaPoint clamp = clampOfElastica(gamma, tip);
  return {.along = clamp.along, .down = clamp.down};
}

double gammaOfChordAngle(double angle) {
  constexpr double largest = 200.0;
  return zeroOf([angle](double gamma) { return heavyElasticaTip(gamma).chordAngle() - angle; }, 0.0, largest);
}

double bendingLength(double bending, double weight) {
  return std::cbrt(bending / weight);
}

double peirceOverhang(double bending, double weight) {
  static const double gamma = gammaOfChordAngle(peirceAngle);
  return bendingLength(bending, weight) * std::cbrt(gamma);
}

double peirceFormula(double overhang, double angle) {
  return overhang * std::cbrt(std::cos(0.5 * angle) / (8.0 * std::tan(angle)));
}

double stretchUnderLoad(double force, double modulus) {
  // The law is convex above 1, so Newton's method from above falls to the solution.
  double stretch = 1.0 + force / modulus;
  constexpr int iterations = 60;
  for (int i = 0; i < iterations; ++i) {
    const double excess = 0.5 * stretch * (stretch * stretch - 1.0) - force / modulus;
    stretch -= excess / (1.5 * stretch * stretch - 0.5);
  }
  return stretch;
}

double stretchAcross(double stretch, double poisson) {
  return std::sqrt(1.0 - poisson * (stretch * stretch - 1.0));
}

double elongationByWeight(double weight, double length, double modulus) {
  // The integral of lambda over the forces f = w X from 0 to w L, by parts: [lambda f] minus that of f over lambda.
  const double force = weight * length;
  const double stretch = stretchUnderLoad(force, modulus);
  const double square = stretch * stretch - 1.0;
  return ((stretch - 1.0) * force - 0.125 * modulus * square * square) / weight;
}

double catenarySag(double length, double span) {
  // With x = span / (2 a), sinh(x) / x = length / span.
  constexpr double largest = 50.0;
  const double x = zeroOf([&](double at) { return std::sinh(at) / at - length / span; }, 1e-9, largest);
  return span / (2.0 * x) * (std::cosh(x) - 1.0);
}

double bucklingLoad(double bending, double length) {
  return std::numbers::pi * std::numbers::pi * bending / (length * length);
}

double pictureFrameEnergy(const sim::fabric::Material& material, double angle) {
  const double shear = std::sin(angle);  // 2 E_12; E_11 and E_22 vanish
  return 0.5 * material.shear * shear * shear;
}

double simpleShearEnergy(const sim::fabric::Material& material, double shear) {
  const double across = 0.5 * shear * shear;  // E_22, because lines along weft become longer
  return 0.5 * material.shear * shear * shear + 0.5 * material.stretchWeft * across * across;
}

double biasModulus(const sim::fabric::Material& material) {
  const double warp = material.stretchWarp;
  const double weft = material.stretchWeft;
  const double coupling = material.poisson * std::sqrt(warp * weft);
  const double determinant = warp * weft - coupling * coupling;
  return 4.0 / ((warp + weft - 2.0 * coupling) / determinant + 1.0 / material.shear);
}

double membraneFrequency(double modulus, double stretch, double density, double side, int m, int n) {
  const double tension = 0.5 * modulus * (stretch * stretch - 1.0);
  return 0.5 * std::sqrt(tension / density) * std::hypot(m, n) / side;
}

namespace {

constexpr double cantileverRoot = 1.8751040687119611;  // the smallest x with cos(x) cosh(x) = -1

}  // namespace

double cantileverFrequency(double bending, double density, double length) {
  return 0.5 * std::numbers::inv_pi * cantileverRoot * cantileverRoot * std::sqrt(bending / density) /
         (length * length);
}

double cantileverMode(double share) {
  const double ratio =
      (std::cosh(cantileverRoot) + std::cos(cantileverRoot)) / (std::sinh(cantileverRoot) + std::sin(cantileverRoot));
  const double at = cantileverRoot * share;
  return 0.5 * (std::cosh(at) - std::cos(at) - ratio * (std::sinh(at) - std::sin(at)));
}

double slidingAcceleration(double slope, double friction, double gravity) {
  return gravity * (slope - friction) / std::sqrt(1.0 + slope * slope);
}

double terminalSpeed(double density, double airDensity, double drag, double gravity) {
  return std::sqrt(2.0 * density * gravity / (airDensity * drag));
}

double addedMassOfSquare(double airDensity, double side) {
  return 0.579 * 0.25 * std::numbers::pi * airDensity * side;
}

double TerminalFall::distance(double time) const {
  return inertia * speed * speed / gravity * std::log(std::cosh(gravity * time / (inertia * speed)));
}

}  // namespace drape::report::validation
