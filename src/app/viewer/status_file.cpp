#include "app/viewer/status_file.hpp"

#include "app/choice_json.hpp"
#include "app/error_sources_json.hpp"
#include "app/output_file.hpp"
#include "app/vector_json.hpp"
#include "messages/error.hpp"
#include "render/picking.hpp"
#include "scene/cloth_material.hpp"
#include "session/solver_warning.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/bounds.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto interval = std::chrono::milliseconds(50);
constexpr std::size_t pickBudget = 400'000;  // maximum number of triangles to test for one file
constexpr std::size_t wantedPoints = 5;
constexpr double margin = 12.0;  // from the edges of the picture [window units]

Json toJson(const ui::UiRect& rect) {
  return {{"x", rect.x}, {"y", rect.y}, {"width", rect.width}, {"height", rect.height}, {"visible", rect.visible}};
}

Json toJson(const ui::UiRects& rects) {
  Json json = Json::object();
  for (const auto& [name, rect] : rects) {
    json[name] = toJson(rect);
  }
  return json;
}

Json toJson(const settings::Settings& settings) {
  Json json = Json::object();
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    std::visit([&](const auto& value) { json[std::string(info.key)] = value; }, settings::settingValue(settings, info));
  }
  return json;
}

Json toJson(const std::optional<session::AttachmentStatus>& attachment) {
  if (!attachment) {
    return nullptr;
  }
  return {{"triangle", attachment->triangle},
          {"target", vectorJson(attachment->target)},
          {"point", vectorJson(attachment->point)},
          {"distance", (attachment->target - attachment->point).norm()},
          {"pinned", attachment->pinned}};
}

Json toJson(const std::optional<session::GhostStatus>& ghost) {
  if (!ghost) {
    return nullptr;
  }
  return {{"distance", ghost->meanDistance}, {"step_seconds", ghost->stepSeconds}};
}

Json toJson(const std::optional<figure::FigureOptions>& figure) {
  if (!figure) {
    return nullptr;
  }
  Json json{{"motion", figure->motion->name}, {"speed", figure->speed}};
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (const std::optional<double>& size = figure->proportions.*each.value) {
      json[std::string(each.key)] = *size;
    }
  }
  return json;
}

Json contactsOf(const session::Snapshot& snapshot) {
  const sim::contact::ContactReport& contact = snapshot.stepReport.contact;
  return {{"bodies", contact.bodyContacts},         {"itself", contact.selfContacts},
          {"overlaps", contact.overlaps},           {"intersections", contact.intersections},
          {"drawn", snapshot.contactPoints.size()}, {"drawn_intersections", snapshot.intersections.size()}};
}

/// The centre of a body as it is drawn [m].
Vec3 middleOf(const sim::contact::Body& body, const session::BodyStatus& status) {
  const auto* mesh = std::get_if<std::shared_ptr<const sim::contact::MeshShape>>(&body.shape);
  if (mesh == nullptr) {
    return status.pose.position;  // every other shape is symmetric
  }
  const std::vector<Vec3>& positions = status.vertices.empty() ? (*mesh)->positions : status.vertices;
  return status.pose.toWorld(sim::boundsOf(positions).center());
}

/// Finds places in the picture with and without cloth, with a limited number of triangle tests.
class PlaceFinder {
 public:
  explicit PlaceFinder(const ViewerStatus& status)
      : status_(status),
        view_(status.panels.view()),
        triangles_(status.snapshot.model->triangles),
        picks_(pickBudget / std::max<std::size_t>(1, triangles_.size()) + 2) {}

  [[nodiscard]] Json clothPoints() {
    Json points = Json::array();
    const std::size_t candidates = std::min<std::size_t>(40, triangles_.size());
    for (std::size_t i = 0; i < candidates && points.size() < wantedPoints; ++i) {
      // A stride near the golden ratio spreads the candidates over the cloth.
      const std::size_t triangle = (i * 618'034 + triangles_.size() / 2) % triangles_.size();
      const Vec2 place = projected(centreOf(triangle));
      const auto hit = free(place) ? hitAt(place) : std::nullopt;
      if (hit && hit->triangle == static_cast<int>(triangle)) {
        points.push_back(
            {{"x", place.x()}, {"y", place.y()}, {"triangle", triangle}, {"point", vectorJson(hit->point)}});
      }
    }
    return points;
  }

  [[nodiscard]] Json bodies() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < status_.snapshot.bodies.size(); ++i) {
      const session::BodyStatus& status = status_.snapshot.bodies[i];
      const sim::contact::Body& body = (*status_.snapshot.scene->bodies)[i];
      const Vec2 place = projected(middleOf(body, status));
      list.push_back({{"name", body.name},
                      {"on", status.on},
                      {"position", vectorJson(status.pose.position)},
                      {"shift", vectorJson(status.shift)},
                      {"figure", toJson(status.figure)},
                      {"clip", clipOf(i)},
                      {"x", place.x()},
                      {"y", place.y()}});
    }
    return list;
  }

  [[nodiscard]] Json freePoint() {
    static constexpr std::array<std::pair<double, double>, 6> places{
        {{0.06, 0.9}, {0.94, 0.9}, {0.06, 0.12}, {0.94, 0.12}, {0.5, 0.94}, {0.06, 0.5}}};
    for (const auto& [x, y] : places) {
      const Vec2 place(view_.x + x * view_.width, view_.y + y * view_.height);
      if (free(place) && !hitAt(place)) {
        return {{"x", place.x()}, {"y", place.y()}};
      }
    }
    return nullptr;
  }

 private:
  /// The clip of its file that moves a body.
  [[nodiscard]] Json clipOf(std::size_t body) const {
    const std::vector<scene::BodyDescription>& described = status_.snapshot.scene->description.bodies;
    const bool hasClip = body < described.size() && described[body].animation;
    return hasClip ? Json(described[body].animation->clip) : Json(nullptr);
  }

  [[nodiscard]] Vec3 centreOf(std::size_t triangle) const {
    Vec3 sum = Vec3::Zero();
    for (const int vertex : triangles_[triangle]) {
      sum += status_.snapshot.positions[vertex];
    }
    return sum / 3.0;
  }

  [[nodiscard]] Vec2 projected(const Vec3& point) const {
    return status_.camera.project(point, static_cast<int>(view_.width), static_cast<int>(view_.height)) +
           Vec2(view_.x, view_.y);
  }

  [[nodiscard]] bool free(const Vec2& place) const {
    const bool inside = place.x() > view_.x + margin && place.x() < view_.x + view_.width - margin &&
                        place.y() > view_.y + margin && place.y() < view_.y + view_.height - margin;
    return inside && !status_.panels.covers(place);
  }

  [[nodiscard]] std::optional<render::Hit> hitAt(const Vec2& place) {
    if (picks_ == 0) {
      return render::Hit{.triangle = -1};  // out of budget: the result is unknown
    }
    --picks_;
    const render::Ray ray = status_.camera.rayThrough(place.x() - view_.x, place.y() - view_.y,
                                                      static_cast<int>(view_.width), static_cast<int>(view_.height));
    return render::pick(ray, status_.snapshot.positions, triangles_);
  }

  const ViewerStatus& status_;
  ui::UiRect view_;
  const std::vector<Triangle>& triangles_;
  std::size_t picks_;
};

std::string messageOf(const ViewerStatus& status) {
  const text::Catalogue& texts = status.panels.language().texts;
  if (!status.stats.error.empty()) {
    return texts(status.stats.error);
  }
  return texts(status.stats.notice.empty() ? status.snapshot.message : status.stats.notice);
}

Json describeSimulation(const session::Snapshot& snapshot) {
  return {{"scene", snapshot.scene->description.name},
          {"vertices", snapshot.model->vertexCount()},
          {"pins", ui::countPins(*snapshot.model)},
          {"paused", snapshot.paused},
          {"placed", snapshot.placedStart != nullptr},
          {"step", snapshot.step},
          {"time", snapshot.time},
          {"settings", toJson(snapshot.settings)},
          {"energy", snapshot.energy.total()},
          {"max_stretch", snapshot.maxStretch},
          {"attachment", toJson(snapshot.attachment)},
          {"ghost", toJson(snapshot.ghost)},
          {"contacts", contactsOf(snapshot)},
          {"choice", app::toJson(snapshot.stepReport.choice, snapshot.scene->cloths, snapshot.settings)},
          {"warning", session::solverWarning(snapshot.settings, *snapshot.model).english()}};
}

Json colourMapOf(const ViewerStatus& status) {
  const fields::ShownField* shown = status.stats.field;
  if (shown == nullptr || shown->field == nullptr) {
    return nullptr;
  }
  return {{"field", shown->field->name},
          {"shown", shown->isShown()},
          {"low", shown->range.low},
          {"high", shown->range.high},
          {"problem", shown->problem}};
}

Json timelineOf(const session::Snapshot& snapshot) {
  if (!snapshot.timeline) {
    return nullptr;
  }
  return {{"begin", snapshot.timeline->begin},
          {"end", snapshot.timeline->end},
          {"states", snapshot.timeline->states},
          {"megabytes", snapshot.timeline->megabytes}};
}

Json exportOf(const ui::UiStats& stats) {
  if (!stats.exporting) {
    return nullptr;
  }
  return {{"file", stats.exporting->file}, {"share", stats.exporting->share}};
}

Json dressingOf(const ui::UiStats& stats) {
  if (!stats.dressing) {
    return nullptr;
  }
  return {{"words", stats.dressing->words.english()}, {"share", stats.dressing->share}};
}

Json sewingOf(const ui::UiStats& stats) {
  if (!stats.sewing) {
    return nullptr;
  }
  const ui::SewingView& sewing = *stats.sewing;
  Json places = Json::array();
  for (const Vec2& place : sewing.places) {
    places.push_back({{"x", place.x()}, {"y", place.y()}});
  }
  return {{"kind", sewing.kind == ui::SewingKind::Seam ? "seam" : "band"},
          {"hovers", !sewing.border.points.empty()},
          {"sides", sewing.sides.size()},
          {"pairs", sewing.pairs.size()},
          {"problem", sewing.problem.english()},
          {"places", places}};
}

/// All seams: the vertices that they join, and whether they are welded.
Json seamsOf(const session::Snapshot& snapshot) {
  Json list = Json::array();
  for (std::size_t i = 0; i < snapshot.seams->size(); ++i) {
    list.push_back({{"pairs", (*snapshot.seams)[i].pairs.size()}, {"welded", snapshot.isWelded[i] != 0}});
  }
  return list;
}

/// The lengths of all elastic bands.
Json bandsOf(const session::Snapshot& snapshot) {
  Json list = Json::array();
  for (const std::vector<scene::BandDescription>& ofCloth : snapshot.sewing->bands) {
    for (const scene::BandDescription& band : ofCloth) {
      list.push_back(band.length);
    }
  }
  return list;
}

Json placingOf(const ui::UiStats& stats, const scene::Scene& scene) {
  if (!stats.placing) {
    return nullptr;
  }
  static constexpr std::array tools{"move", "turn", "scale"};
  const ui::PlacingView& placing = *stats.placing;
  return {{"thing", scene::nameOf(scene.description, placing.thing)},
          {"tool", tools[static_cast<std::size_t>(placing.tool)]},
          {"middle", vectorJson(placing.middle)},
          {"rotation", vectorJson(placing.placement.rotation)},
          {"scale", placing.placement.scale},
          {"unit", placing.reading ? Json(placing.reading->unit) : Json(nullptr)},
          {"up", placing.reading ? Json(placing.reading->up) : Json(nullptr)},
          {"builds", placing.isBuilding}};
}

/// The corners of the box around the cloth [m].
Json boundsOfCloth(const session::Snapshot& snapshot) {
  const Eigen::AlignedBox3d box = sim::boundsOf(snapshot.positions);
  return {{"min", vectorJson(box.min())}, {"max", vectorJson(box.max())}};
}

Json errorsOf(const ui::ErrorComparisonView& errors) {
  return {{"share", errors.share ? Json(*errors.share) : Json(nullptr)}, {"sources", app::toJson(errors.sources)}};
}

Json piercingOf(const ui::UiStats& stats) {
  if (!stats.piercing) {
    return nullptr;
  }
  return {{"words", stats.piercing->text.english()}, {"pairs", stats.piercing->pairs}};
}

Json describeAll(const ViewerStatus& status) {
  Json json = describeSimulation(status.snapshot);
  const scene::CameraPose& pose = status.camera.pose();
  json["camera"] = {{"position", vectorJson(pose.position)},
                    {"focal_point", vectorJson(pose.focalPoint)},
                    {"view_angle", pose.viewAngle},
                    {"orthographic", status.camera.isOrthographic()},
                    {"turns", status.stats.camera.turns}};
  json["window"] = {{"width", status.display.width},
                    {"height", status.display.height},
                    {"density", status.display.density},
                    {"scale", status.display.scale}};
  json["view"] = toJson(status.panels.view());
  json["panels"] = status.panels.panelsVisible();
  json["help"] = status.panels.helpVisible();
  json["theme"] = ui::themes()[static_cast<std::size_t>(status.panels.theme())].name;
  json["language"] = status.panels.language().name;
  json["widgets"] = toJson(status.panels.widgets());
  json["buttons"] = toJson(status.panels.buttons());
  json["colour_map"] = colourMapOf(status);
  json["picked"] = status.panels.picked().vertices();
  json["timeline"] = timelineOf(status.snapshot);
  const ui::SelectionView& selection = status.stats.selection;
  json["selection"] = {{"on", selection.mode != ui::SelectionMode::Off},
                       {"vertices", selection.points.size()},
                       {"pinned", selection.pinned}};
  json["placing"] = placingOf(status.stats, *status.snapshot.scene);
  json["sewing"] = sewingOf(status.stats);
  json["seams"] = seamsOf(status.snapshot);
  json["bands"] = bandsOf(status.snapshot);
  json["cloth_bounds"] = boundsOfCloth(status.snapshot);
  json["export"] = exportOf(status.stats);
  json["dressing"] = dressingOf(status.stats);
  json["piercing"] = piercingOf(status.stats);
  json["errors"] = errorsOf(status.stats.errors);
  PlaceFinder places(status);
  json["free_point"] = places.freePoint();
  json["cloth_points"] = places.clothPoints();
  json["bodies"] = places.bodies();
  json["loading"] = status.stats.loading.english();
  json["loading_share"] = status.stats.loadingShare;
  json["message"] = messageOf(status);
  json["status"] = status.panels.status();
  return json;
}

}  // namespace

void StatusFile::noteInput() {
  inputBefore_ = std::exchange(lastInput_, std::chrono::steady_clock::now());
}

void StatusFile::update(const ViewerStatus& status) {
  const auto now = std::chrono::steady_clock::now();
  if (file_.empty() || now < next_) {
    return;
  }
  next_ = now + interval;
  Json json{{"sequence", ++sequence_},
            {"frame", status.frame},
            {"picture", status.picture},
            {"input_seconds", std::chrono::duration<double>(inputBefore_.time_since_epoch()).count()},
            {"first_frame_seconds", status.firstFrameSeconds}};
  json.update(describeAll(status));
  if (!replaceFile(file_, jsonText(json, 1) + '\n')) {
    throw messages::InputError("cannot write the status file " + file_.string() + "; check that its folder exists");
  }
}

}  // namespace drape::app
