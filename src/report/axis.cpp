#include "report/axis.hpp"

#include "report/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::report {
namespace {

/// With more labels the axis is crowded.
constexpr int maxLabels = 8;

/// "10" with a raised exponent; plain numbers near one.
std::string decadeLabel(int exponent) {
  if (exponent >= -2 && exponent <= 3) {
    return text::figure(std::pow(10.0, exponent), 4);
  }
  constexpr std::array<const char*, 10> raised{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                               "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += raised.at(static_cast<std::size_t>(digit - '0'));
  }
  return text;
}

}  // namespace

Axis::Axis(Scale scale, const std::vector<double>& values) : scale_(scale) {
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  for (const double value : values) {
    if (takes(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  if (scale == Scale::Linear) {
    lowest <= highest ? makeLinear(lowest, highest) : makeLinear(0.0, 1.0);
  } else {
    lowest <= highest ? makeLogarithmic(lowest, highest) : makeLogarithmic(1.0, 10.0);
  }
}

bool Axis::takes(double value) const {
  return std::isfinite(value) && (scale_ == Scale::Linear || value > 0.0);
}

double Axis::share(double value) const {
  return ((scale_ == Scale::Linear ? value : std::log10(value)) - begin_) / (end_ - begin_);
}

void Axis::makeLinear(double lowest, double highest) {
  if (highest == lowest) {
    const double margin = lowest == 0.0 ? 1.0 : std::abs(lowest);
    lowest -= 0.5 * margin;
    highest += 0.5 * margin;
  }
  const double step = text::nextRoundNumber((highest - lowest) / (maxLabels - 2));
  const double first = std::floor(lowest / step + 1e-9);
  const double last = std::ceil(highest / step - 1e-9);
  begin_ = first * step;
  end_ = last * step;
  for (double k = first; k <= last; k += 1.0) {
    ticks_.push_back({k * step, text::figure(k * step, 6)});
  }
}

void Axis::makeLogarithmic(double lowest, double highest) {
  const int first = static_cast<int>(std::floor(std::log10(lowest) + 1e-9));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(highest) - 1e-9)));
  begin_ = first;
  end_ = last;
  const int every = (last - first) / maxLabels + 1;
  for (int exponent = first; exponent <= last; ++exponent) {
    const double decade = std::pow(10.0, exponent);
    const bool labelled = (exponent - first) % every == 0;
    ticks_.push_back({decade, labelled ? decadeLabel(exponent) : std::string()});
    for (int factor = 2; factor < 10 && exponent < last && every == 1; ++factor) {
      ticks_.push_back({factor * decade, {}});
    }
  }
}

}  // namespace drape::report
