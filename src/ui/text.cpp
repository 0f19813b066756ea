#include "ui/text.hpp"

#include <fmt/core.h>
#include <algorithm>

namespace drape::ui {

bool isTooSlow(const session::Snapshot& snapshot) {
  constexpr double nearEnough = 0.9;
  return !snapshot.paused && snapshot.realTimeFactor > 0.0 &&
         snapshot.realTimeFactor < nearEnough * snapshot.settings.playback.speed;
}

std::string describePace(const session::Snapshot& snapshot, const text::Catalogue& texts) {
  if (snapshot.paused) {
    return texts("paused");
  }
  if (snapshot.realTimeFactor <= 0.0) {
    return texts("not timed");  // no clock is running, as in a capture, or it has just started
  }
  const bool slow = isTooSlow(snapshot);
  if (!slow && snapshot.settings.playback.speed == 1.0) {
    return texts("real time");
  }
  const std::string factor = snapshot.realTimeFactor < 0.095 ? fmt::format("{:.2g}", snapshot.realTimeFactor)
                                                             : fmt::format("{:.1f}", snapshot.realTimeFactor);
  return texts(slow ? "{} \u00D7 real time: too slow" : "{} \u00D7 real time", factor);
}

text::Sentence slownessInWords(const session::Snapshot& snapshot) {
  constexpr double largeFraction = 0.5;
  const sim::contact::ContactReport& contact = snapshot.stepReport.contact;
  if (snapshot.stepReport.secondsOfContact() > largeFraction * snapshot.stepSeconds) {
    return text::Sentence(contact.selfSeconds > contact.bodySeconds
                              ? "The simulation is slower than real time, mostly because of contact of the cloth with "
                                "itself. Fewer vertices make it faster"
                              : "The simulation is slower than real time, mostly because of contact with bodies. Fewer "
                                "vertices make it faster");
  }
  return text::Sentence("The simulation is slower than real time on this machine. Fewer vertices make it faster");
}

int countPins(const sim::ClothModel& model) {
  return static_cast<int>(std::count(model.pinned.begin(), model.pinned.end(), true));
}

std::string shortened(std::string_view text, std::size_t limit) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts && ++characters > limit) {
      return std::string(text.substr(0, i)) + "\u2026";
    }
  }
  return std::string(text);
}

std::string clipName(const io::ClipFacts& clip, const text::Catalogue& texts) {
  const std::string seconds = fmt::format("{:.3g}", clip.duration);
  return clip.name.empty() ? texts("clip without a name ({} s)", seconds) : texts("{} ({} s)", clip.name, seconds);
}

}  // namespace drape::ui
