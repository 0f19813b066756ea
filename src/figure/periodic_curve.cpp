#include "figure/periodic_curve.hpp"

#include <algorithm>
#include <cmath>

namespace drape::figure {

double fractionOf(double number) {
  return number - std::floor(number);
}

double smoothStep(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

CurveKey PeriodicCurve::key(int index) const {
  const auto count = static_cast<int>(keys_.size());
  const int turn = index < 0 ? -1 : index / count;
  const CurveKey& found = keys_[index - turn * count];
  return {found.phase + turn, found.value};
}

double PeriodicCurve::slope(int index) const {
  const CurveKey before = key(index - 1);
  const CurveKey after = key(index + 1);
  return (after.value - before.value) / (after.phase - before.phase);
}

double PeriodicCurve::at(double phase) const {
  double at = fractionOf(phase);
  if (at < keys_.front().phase) {
    at += 1.0;  // between the last key and the first of the next period
  }
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), at,
                                     [](double wanted, const CurveKey& each) { return wanted < each.phase; });
  const auto k = static_cast<int>(next - keys_.begin()) - 1;
  const CurveKey from = key(k);
  const CurveKey to = key(k + 1);
  const double length = to.phase - from.phase;
  const double s = (at - from.phase) / length;
  const double rest = 1.0 - s;
  return from.value + s * s * (3.0 - 2.0 * s) * (to.value - from.value) +
         length * s * rest * (rest * slope(k) - s * slope(k + 1));
}

}  // namespace drape::figure
