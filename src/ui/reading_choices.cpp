// How a mesh file is read: the choices of its unit and of its up axis.
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace drape::ui {
namespace {

std::string wordChoice(PanelContext& context, const std::string& name, std::span<const Segment> words,
                       const std::string& present) {
  const auto found = std::ranges::find(words, present, &Segment::word);
  const auto chosen = static_cast<std::size_t>(found - words.begin());
  const std::size_t next = segments(context, name, words, chosen);
  return next < words.size() ? std::string(words[next].word) : present;
}

}  // namespace

std::string unitChoice(PanelContext& context, const std::string& name, const std::string& unit) {
  static constexpr std::array<Segment, 5> units{
      {{"m", "m", true}, {"cm", "cm", true}, {"mm", "mm", true}, {"inch", "inch"}, {"foot", "foot"}}};
  return wordChoice(context, name, units, unit);
}

std::string upChoice(PanelContext& context, const std::string& name, const std::string& up) {
  static constexpr std::array<Segment, 3> axes{{{"x", "x", true}, {"y", "y", true}, {"z", "z", true}}};
  return wordChoice(context, name, axes, up);
}

}  // namespace drape::ui
