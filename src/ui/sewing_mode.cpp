#include "ui/sewing_mode.hpp"

#include "messages/sim_error_text.hpp"
#include "scene/elastic_bands.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace drape::ui {
namespace {

constexpr double pickDistance = 14.0;  // from the mouse to a border, at scale 1 [window units]

BorderLine lineThrough(std::span<const int> vertices, bool isClosed, const session::Snapshot& snapshot,
                       const GizmoPicture& picture) {
  BorderLine line{.points = {}, .isClosed = isClosed};
  for (const int vertex : vertices) {
    line.points.push_back(picture.toWindow(snapshot.positions[vertex]));
  }
  return line;
}

std::vector<std::array<Vec2, 2>> linesBetween(std::span<const sim::SeamPair> pairs, const session::Snapshot& snapshot,
                                              const GizmoPicture& picture) {
  std::vector<std::array<Vec2, 2>> lines;
  for (const sim::SeamPair& pair : pairs) {
    lines.push_back({picture.toWindow(snapshot.positions[pair.a]), picture.toWindow(snapshot.positions[pair.b])});
  }
  return lines;
}

std::vector<SeamLines> seamsIn(const session::Snapshot& snapshot, const GizmoPicture& picture) {
  std::vector<SeamLines> seams;
  for (std::size_t i = 0; i < snapshot.seams->size(); ++i) {
    seams.push_back({linesBetween((*snapshot.seams)[i].pairs, snapshot, picture), snapshot.isWelded[i] != 0});
  }
  return seams;
}

std::size_t clothOf(const PickedBorder& side, const session::Snapshot& snapshot) {
  const std::vector<scene::ClothPart>& cloths = snapshot.scene->cloths;
  return static_cast<std::size_t>(&scene::clothWith(side.vertices.front(), cloths) - cloths.data());
}

/// Whether two bands have a common edge.
bool overlap(const scene::ElasticBand& a, const scene::ElasticBand& b) {
  const auto edges = [](const scene::ElasticBand& band) { return scene::edgesOf(band, 0); };
  const auto one = edges(a);
  return std::ranges::any_of(edges(b), [&](const auto& edge) { return std::ranges::find(one, edge) != one.end(); });
}

/// The bands of the cloth that have an edge in common with a picked border, by index.
std::vector<std::size_t> bandsAlong(const PickedBorder& side, const session::Snapshot& snapshot) {
  const std::size_t cloth = clothOf(side, snapshot);
  scene::BandDescription wanted;
  wanted.vertices = side.description.vertices;
  const std::vector<scene::BandDescription>& bands = snapshot.sewing->bands[cloth];
  std::vector<std::size_t> found;
  if (!bands.empty()) {
    const std::vector<scene::ElasticBand> present = scene::bandsOf(bands, scene::meshOf(cloth, *snapshot.scene));
    const auto picked = scene::bandsOf(std::array{wanted}, scene::meshOf(cloth, *snapshot.scene));
    for (std::size_t i = 0; i < present.size(); ++i) {
      if (overlap(present[i], picked.front())) {
        found.push_back(i);
      }
    }
  }
  return found;
}

}  // namespace

void SewingMode::start(SewingKind kind) {
  isOn_ = true;
  if (kind != kind_) {
    kind_ = kind;
    cancel();
  }
}

void SewingMode::end() {
  isOn_ = false;
  cancel();
}

bool SewingMode::cancel() {
  const bool had = !sides_.empty() || start_.has_value();
  sides_.clear();
  start_.reset();
  isReversed_ = false;
  isUpdated_ = false;
  return had;
}

void SewingMode::follow(const session::Snapshot& snapshot) {
  if (scene_ != snapshot.scene) {
    cancel();
    picker_.reset();
    scene_ = snapshot.scene;
  }
  if (isOn_ && !picker_) {
    picker_ = std::make_unique<BorderPicker>(*scene_);
    middles_ = picker_->middles();
  }
}

void SewingMode::on(const SewingRequest& request, const session::Snapshot& snapshot, UiOutput& output) {
  switch (request.kind) {
    case SewingRequest::Kind::UseKind:
      start(request.sewing);
      break;
    case SewingRequest::Kind::UseExtent:
      extent_ = request.extent;
      start_.reset();
      break;
    case SewingRequest::Kind::Flip:
      isReversed_ = !isReversed_;
      isUpdated_ = false;
      break;
    case SewingRequest::Kind::Sew:
      sew(snapshot, output);
      break;
    case SewingRequest::Kind::SetBand:
      setBand(request.length, snapshot, output);
      break;
    case SewingRequest::Kind::Clear:
      cancel();
      break;
    case SewingRequest::Kind::End:
      end();
      break;
  }
}

void SewingMode::hover(const Vec2& place, bool isOverPicture) {
  mouse_ = isOverPicture ? std::optional(place) : std::nullopt;
}

/// What a click at the spot picks; empty where it only starts a part.
std::optional<PickedBorder> SewingMode::under(const BorderSpot& spot, bool longer) const {
  switch (extent_) {
    case BorderExtent::Corners:
      return picker_->betweenCorners(spot);
    case BorderExtent::Whole:
      return picker_->whole(spot);
    case BorderExtent::Points:
      return start_ ? picker_->between(*start_, spot, longer) : std::nullopt;
  }
  return std::nullopt;
}

bool SewingMode::click(const Vec2& place, bool longer, const session::Snapshot& snapshot, const GizmoPicture& picture,
                       double scale) {
  follow(snapshot);
  const auto spot = picker_->at(place, pickDistance * scale, snapshot.positions, picture);
  if (!spot) {
    return false;
  }
  if (std::optional<PickedBorder> border = under(*spot, longer)) {
    start_.reset();
    pick(*std::move(border), snapshot);
  } else {
    start_ = spot;
  }
  return true;
}

/// A third side replaces the second one. A click on a picked side takes it back.
void SewingMode::pick(PickedBorder border, const session::Snapshot& snapshot) {
  const auto same = std::ranges::find(sides_, border.description, &PickedBorder::description);
  if (same != sides_.end()) {
    sides_.erase(same);
  } else {
    if (sides_.size() == maxSides()) {
      sides_.pop_back();
    }
    sides_.push_back(std::move(border));
  }
  chooseDirection(snapshot);
  isUpdated_ = false;
}

/// Joins the ends that are nearer to each other.
void SewingMode::chooseDirection(const session::Snapshot& snapshot) {
  isReversed_ = false;
  if (sides_.size() == 2 && !sides_[0].isClosed && !sides_[1].isClosed) {
    const auto distance = [&](int a, int b) { return (snapshot.positions[a] - snapshot.positions[b]).norm(); };
    const std::vector<int>& first = sides_[0].vertices;
    const std::vector<int>& second = sides_[1].vertices;
    isReversed_ = distance(first.front(), second.back()) + distance(first.back(), second.front()) <
                  distance(first.front(), second.front()) + distance(first.back(), second.back());
  }
}

scene::SeamDescription SewingMode::seam() const {
  scene::SeamDescription seam;
  seam.sides = {sides_[0].description, sides_[1].description};
  seam.isReversed = isReversed_;
  return seam;
}

/// Finds the pairs of the picked sides, or why they cannot be sewn. Only when something has changed: it takes as long
/// as the weld of the whole cloth.
void SewingMode::update(const session::Snapshot& snapshot) {
  if (isUpdated_ && sewing_ == snapshot.sewing && model_ == snapshot.model) {
    return;
  }
  isUpdated_ = true;
  sewing_ = snapshot.sewing;
  model_ = snapshot.model;
  pairs_.clear();
  problem_ = {};
  bandLength_.reset();
  try {
    if (kind_ == SewingKind::Seam && sides_.size() == 2) {
      pairs_ = scene::seamOf(seam(), *snapshot.scene, *snapshot.model, *snapshot.seams).pairs;
    } else if (kind_ == SewingKind::Band && !sides_.empty()) {
      const std::vector<std::size_t> bands = bandsAlong(sides_.front(), snapshot);
      if (!bands.empty()) {
        bandLength_ = snapshot.sewing->bands[clothOf(sides_.front(), snapshot)][bands.front()].length;
      }
    }
  } catch (const std::exception& error) {
    problem_ = messages::sentenceOf(error);
  }
}

void SewingMode::sew(const session::Snapshot& snapshot, UiOutput& output) {
  update(snapshot);
  if (sides_.size() < 2) {
    output.hint = "Pick two borders first";
  } else if (!problem_.empty()) {
    output.hint = problem_;
  } else {
    session::SetSewingCommand command{*snapshot.sewing};
    command.sewing.seams.push_back(seam());
    output.commands.emplace_back(std::move(command));
    cancel();
  }
}

/// Replaces the bands along the picked border.
void SewingMode::setBand(double length, const session::Snapshot& snapshot, UiOutput& output) {
  if (sides_.empty()) {
    output.hint = "Pick a border first";
    return;
  }
  session::SetSewingCommand command{*snapshot.sewing};
  const std::vector<scene::BandDescription> before = command.sewing.bands[clothOf(sides_.front(), snapshot)];
  std::vector<scene::BandDescription>& bands = command.sewing.bands[clothOf(sides_.front(), snapshot)];
  const std::vector<std::size_t> replaced = bandsAlong(sides_.front(), snapshot);
  bands.clear();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (std::ranges::find(replaced, i) == replaced.end()) {
      bands.push_back(before[i]);
    }
  }
  bands.push_back({.length = length, .vertices = sides_.front().description.vertices});
  output.commands.emplace_back(std::move(command));
}

std::optional<SewingView> SewingMode::view(const session::Snapshot& snapshot, const GizmoPicture& picture,
                                           double scale) {
  follow(snapshot);
  if (!isOn_) {
    return std::nullopt;
  }
  update(snapshot);
  SewingView view;
  view.kind = kind_;
  view.extent = extent_;
  view.problem = problem_;
  view.bandLength = bandLength_;
  const auto spot = mouse_ ? picker_->at(*mouse_, pickDistance * scale, snapshot.positions, picture) : std::nullopt;
  if (spot) {
    view.border = lineThrough(picker_->borders()[spot->border].vertices, true, snapshot, picture);
    if (const auto part = under(*spot, false)) {
      view.hovered = lineThrough(part->vertices, part->isClosed, snapshot, picture);
    }
  }
  const auto start = start_ ? start_ : extent_ == BorderExtent::Corners ? std::nullopt : spot;
  if (start) {
    view.start = picture.toWindow(snapshot.positions[picker_->vertexAt(*start)]);
  }
  for (const PickedBorder& side : sides_) {
    view.sides.push_back(
        {lineThrough(side.vertices, side.isClosed, snapshot, picture), side.vertices.size(), side.length});
  }
  view.pairs = linesBetween(pairs_, snapshot, picture);
  view.seams = seamsIn(snapshot, picture);
  for (const int vertex : middles_) {
    view.places.push_back(picture.toWindow(snapshot.positions[vertex]));
  }
  return view;
}

session::SetSewingCommand withoutSeam(const session::Snapshot& snapshot, std::size_t seam) {
  session::SetSewingCommand command{*snapshot.sewing};
  command.sewing.seams.erase(command.sewing.seams.begin() + static_cast<std::ptrdiff_t>(seam));
  return command;
}

session::SetSewingCommand withoutBand(const session::Snapshot& snapshot, std::size_t cloth, std::size_t band) {
  session::SetSewingCommand command{*snapshot.sewing};
  std::vector<scene::BandDescription>& bands = command.sewing.bands[cloth];
  bands.erase(bands.begin() + static_cast<std::ptrdiff_t>(band));
  return command;
}

session::SetSewingCommand withBandLength(const session::Snapshot& snapshot, std::size_t cloth, std::size_t band,
                                         double length) {
  session::SetSewingCommand command{*snapshot.sewing};
  command.sewing.bands[cloth][band].length = length;
  return command;
}

}  // namespace drape::ui
