#include "session/open_seams.hpp"

#include "sim/forces/diagnostics.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>

namespace drape::session {
namespace {

constexpr double lateAfter = 2.0;  // in durations of the seam
constexpr double mmPerMetre = 1000.0;

}  // namespace

text::Sentence tightSewingInWords(const sim::ClothModel& model, const sim::ClothState& state) {
  constexpr double percent = 100.0;
  const double strain = sim::strainOfTightest(model, state.positions);
  return strain > sim::tooTight
             ? text::Sentence(
                   "Where it is tightest the sewn cloth is stretched by {} %: its pieces are too small for "
                   "the body, or their unit is another one.",
                   text::roundedFigure(percent * strain))
             : text::Sentence();
}

text::Sentence lateSeamsInWords(std::span<const sim::Seam> open, const sim::ClothState& state) {
  long long late = 0;
  double maxDistance = 0.0;
  Vec3 place = Vec3::Zero();
  for (const sim::Seam& seam : open) {
    if (seam.pairs.empty() || state.time < seam.start + lateAfter * seam.duration) {
      continue;
    }
    ++late;
    for (const sim::SeamPair& pair : seam.pairs) {
      const double distance = (state.positions[pair.b] - state.positions[pair.a]).norm();
      if (distance > maxDistance) {
        maxDistance = distance;
        place = 0.5 * (state.positions[pair.a] + state.positions[pair.b]);
      }
    }
  }
  if (late == 0) {
    return {};
  }
  return text::Sentence(
      text::plural(late,
                   "{} seam is still open: its sides are up to {} mm apart, near ({}) m. Something between them, or "
                   "cloth that is too tight, keeps them apart.",
                   "{} seams are still open: their sides are up to {} mm apart, near ({}) m. Something between them, "
                   "or cloth that is too tight, keeps them apart."),
      late, text::roundedFigure(mmPerMetre * maxDistance),
      fmt::format("{:.2f}, {:.2f}, {:.2f}", place.x(), place.y(), place.z()));
}

}  // namespace drape::session
