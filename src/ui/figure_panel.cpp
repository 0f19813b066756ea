// The rows of the section Scene for figures: what they do, and their size.
#include "figure/moving_figure.hpp"
#include "messages/error.hpp"
#include "text/number_text.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/printf.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace drape::ui {
namespace {

using figure::FigureOptions;

constexpr double arrivalTime = 1.0;  // until a choice that does not arrive is forgotten [s]

/// A number of a figure, as a row shows it.
struct FigureNumber {
  std::string key;
  Wording title;
  std::string unit;
  Wording help;
  SliderRange range;
  double value = 0.0;
  double sceneValue = 0.0;
};

/// What the user chose last, until the snapshot has it.
const FigureOptions& presentOf(PanelContext& context, std::size_t body, const FigureOptions& inForce) {
  std::optional<PendingFigure>& pending = context.memory.pendingFigure;
  const bool isThis = pending && pending->scene == context.snapshot.scene && pending->body == body;
  if (isThis && (pending->figure == inForce || ImGui::GetTime() - pending->since > arrivalTime)) {
    pending.reset();
    return inForce;
  }
  return isThis ? pending->figure : inForce;
}

void choose(PanelContext& context, std::size_t body, const FigureOptions& figure) {
  context.memory.pendingFigure = PendingFigure{context.snapshot.scene, body, figure, ImGui::GetTime()};
  context.output.commands.emplace_back(session::SetFigureCommand{static_cast<int>(body), figure});
}

SliderInput sliderOf(const FigureNumber& number) {
  const auto nearest = [&number](double value) -> settings::SettingValue {
    return std::clamp(value, number.range.min, number.range.max);
  };
  const auto typed = [&number, nearest](const std::string& text) {
    const auto value = text::parseNumber(text);
    if (!value || !std::isfinite(*value)) {
      throw messages::UsageError(number.title.english() + " must be a number, not '" + text + "'");
    }
    return nearest(*value);
  };
  return {number.key, number.range, numberFormat("%.4g", number.unit), nearest, typed};
}

void explain(const PanelContext& context, const FigureNumber& number, const UiRect& row) {
  const std::string format = numberFormat("%.4g", number.unit);
  beginExplanation(context, &row);
  ImGui::TextWrapped("%s", context.texts(number.help).c_str());
  ImGui::Spacing();
  mutedText(
      context.texts("Range: {} to {}", fmt::sprintf(format, number.range.min), fmt::sprintf(format, number.range.max)));
  mutedText(context.texts("In the scene: {}", fmt::sprintf(format, number.sceneValue)));
  mutedText(context.texts("Ctrl+click types a value. A right click restores the scene's value."));
  endExplanation();
}

/// The row of a number. @return the new value when the user changed it; infinite: that of the scene
std::optional<double> numberRow(PanelContext& context, const FigureNumber& number) {
  ImGui::PushID(number.key.c_str());
  const UiRect row = beginRow(context, number.title, number.value != number.sceneValue);
  const Edit edit = numberSlider(context, sliderOf(number), number.value);
  context.widgets[number.key] = lastItemRect();
  std::optional<double> changed;
  if (edit.changed) {
    changed = std::get<double>(edit.value);
  } else if (hoversRow(row) && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && number.value != number.sceneValue) {
    changed = HUGE_VAL;
  }
  if (hoversRow(row) && hoveredLongEnough(context, number.key)) {
    explain(context, number, row);
  }
  ImGui::PopID();
  return changed;
}

void motionRow(PanelContext& context, std::size_t body, const std::string& key, const FigureOptions& now,
               const FigureOptions& inScene) {
  ImGui::PushID(key.c_str());
  const UiRect row = beginRow(context, "Motion", now.motion != inScene.motion);
  const std::string title = context.texts(now.motion->title);
  const float width = widthBesideArrow();
  if (ImGui::BeginCombo("##motion", fitted(title, width).c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const figure::Motion& motion : figure::motions()) {
      if (ImGui::Selectable(labelOf(context, motion.title, motion.name).c_str(), &motion == now.motion) &&
          &motion != now.motion) {
        FigureOptions changed = now;
        changed.motion = &motion;
        choose(context, body, changed);
      }
      context.buttons[key + "=" + std::string(motion.name)] = lastItemRect();
    }
    ImGui::EndCombo();
  }
  context.widgets[key] = lastItemRect();
  if (hoversRow(row)) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && now.motion != inScene.motion) {
      FigureOptions changed = now;
      changed.motion = inScene.motion;
      choose(context, body, changed);
    }
    explainItem(context, key, "What the figure does. It goes over from what it does now within a second.");
  }
  ImGui::PopID();
}

void speedRow(PanelContext& context, std::size_t body, const std::string& name, const FigureOptions& now,
              const FigureOptions& inScene) {
  const FigureNumber number{name + ".speed",
                            "Speed",
                            "-",
                            "Speed of the motion. 1 is the speed that the guide lists.",
                            {figure::minSpeed, figure::maxSpeed, false},
                            now.speed,
                            inScene.speed};
  if (const std::optional<double> changed = numberRow(context, number)) {
    FigureOptions next = now;
    next.speed = std::isfinite(*changed) ? *changed : inScene.speed;
    choose(context, body, next);
  }
}

std::string withCapital(std::string_view word) {
  std::string text(word);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// A measure that nobody set is that of the figure as it is built.
void measureRow(PanelContext& context, std::size_t body, const std::string& name, const figure::ProportionInfo& measure,
                const FigureOptions& now, const FigureOptions& inScene, const figure::Proportions& built) {
  const double asBuilt = (built.*measure.value).value_or(measure.min);
  const FigureNumber number{
      name + "." + std::string(measure.key),
      withCapital(measure.key),
      "m",
      text::Sentence("{}. The figure takes this size within a second.", text::Sentence(withCapital(measure.title))),
      {measure.min, measure.max, false},
      (now.proportions.*measure.value).value_or(asBuilt),
      (inScene.proportions.*measure.value).value_or(asBuilt)};
  if (const std::optional<double> changed = numberRow(context, number)) {
    FigureOptions next = now;
    next.proportions.*measure.value =
        std::isfinite(*changed) ? std::optional(*changed) : inScene.proportions.*measure.value;
    choose(context, body, next);
  }
}

std::shared_ptr<const figure::MovingFigure> builtFigure(const sim::contact::Body& body) {
  const auto* mesh = std::get_if<std::shared_ptr<const sim::contact::MeshShape>>(&body.shape);
  return mesh == nullptr ? nullptr : figure::asFigure((*mesh)->deformation);
}

}  // namespace

void figureRows(PanelContext& context) {
  const std::vector<sim::contact::Body>& bodies = *context.snapshot.scene->bodies;
  const auto count = std::ranges::count_if(context.snapshot.bodies,
                                           [](const session::BodyStatus& status) { return status.figure.has_value(); });
  for (std::size_t i = 0; i < bodies.size() && i < context.snapshot.bodies.size(); ++i) {
    const auto built = builtFigure(bodies[i]);
    const std::optional<FigureOptions>& inForce = context.snapshot.bodies[i].figure;
    if (!built || !inForce) {
      continue;
    }
    if (count > 1) {
      mutedText(bodies[i].name);
    }
    const std::string name = "body." + bodies[i].name;
    const FigureOptions now = presentOf(context, i, *inForce);
    motionRow(context, i, name + ".motion", now, built->options());
    speedRow(context, i, name, now, built->options());
    for (const figure::ProportionInfo& measure : figure::proportionTable()) {
      measureRow(context, i, name, measure, now, built->options(), built->built());
    }
  }
}

}  // namespace drape::ui
