#include "app/viewer/export_job.hpp"

#include "app/export/frame_rate.hpp"
#include "app/export/motion_export.hpp"
#include "app/export/picture_files.hpp"
#include "app/viewer/export_name.hpp"
#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "session/simulation.hpp"
#include "sim/model/seconds_since.hpp"

#include <fmt/core.h>

#include <cmath>
#include <exception>
#include <utility>

namespace drape::app {
namespace {

constexpr double rounding = 1e-6;  // of a typed time [frames]

}  // namespace

ExportJob::ExportJob(ExportOrder order) : order_(std::move(order)) {
  const ui::ExportRequest& request = order_.request;
  if (request.to < request.from) {
    throw messages::InputError(
        fmt::format("the export ends at {:.6g} s, before it begins at {:.6g} s", request.to, request.from));
  }
  firstFrame_ = static_cast<int>(std::ceil(request.from * request.rate - rounding));
  frames_ = static_cast<int>(std::floor(request.to * request.rate + rounding)) - firstFrame_ + 1;
  if (frames_ < 1) {
    throw messages::InputError(fmt::format("there is no frame between {:.6g} s and {:.6g} s at {:.6g} frames a second",
                                           request.from, request.to, request.rate));
  }
  const bool isFilm = request.format->kind == ui::ExportKind::Film;
  requireNewFiles(order_.file, isFilm ? 0 : firstFrame_, frames_);  // pictures are counted from 0
  thread_ = std::thread([this] { run(); });
}

ExportJob::~ExportJob() {
  cancel();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ExportJob::cancel() {
  stop_.request_stop();
  changed_.notify_all();
}

std::optional<ExportJob::Outcome> ExportJob::poll() {
  const std::scoped_lock lock(lock_);
  return outcome_;
}

ui::ExportProgress ExportJob::progress() const {
  const std::scoped_lock lock(lock_);
  const double spent = sim::secondsSince(begin_);
  return {order_.file, share_, share_ > 0.0 ? spent * (1.0 - share_) / share_ : -1.0};
}

bool ExportJob::serve(const Draw& draw) {
  std::unique_lock lock(lock_);
  if (!wanted_) {
    return false;
  }
  const session::Snapshot snapshot = *std::exchange(wanted_, std::nullopt);
  const double share = wantedShare_;
  lock.unlock();
  std::optional<render::Image> image;
  std::string problem;
  try {
    image = draw(snapshot, share);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  lock.lock();
  drawn_ = std::move(image);
  drawProblem_ = problem;
  lock.unlock();
  changed_.notify_all();
  return true;
}

void ExportJob::run() {
  try {
    finish({write(), false});
  } catch (const Cancelled&) {
    finish({text::Sentence("The export was cancelled"), false});
  } catch (const sim::StepStopped&) {
    finish({text::Sentence("The export was cancelled"), false});
  } catch (const sim::SimError& error) {
    finish({messages::sentenceOf(error), true});
  } catch (const std::exception& error) {
    finish({text::Sentence::verbatim(error.what()), true});
  }
}

void ExportJob::finish(Outcome outcome) {
  const std::scoped_lock lock(lock_);
  outcome_ = std::move(outcome);
}

text::Sentence ExportJob::write() {
  session::Simulation simulation(order_.scene);
  simulation.setStopToken(stop_.get_token());
  prepare(simulation);
  if (order_.request.format->kind == ui::ExportKind::Film) {
    writeFilm(simulation);
  } else {
    writeMotion(simulation);
  }
  return text::Sentence(text::plural(frames_, "Saved {}: {} frame", "Saved {}: {} frames"), order_.file, frames_);
}

/// Gives the simulation what the user chose, its beginning, and a time step that fits the frames.
void ExportJob::prepare(session::Simulation& simulation) {
  if (order_.placedStart) {
    simulation.apply(session::PlaceClothCommand{*order_.placedStart, true});
  }
  session::Snapshot opened;
  simulation.capture(opened);
  const auto apply = [&](const session::Command& command) { simulation.apply(command); };
  for (const session::Command& command :
       session::commandsBetween(session::userStateOf(opened), order_.user, *order_.scene)) {
    apply(command);
  }
  const double timeStep = simulation.settings().step.timeStep;
  const double fitting = fittingTimeStep(order_.request.rate, timeStep);
  if (fitting != timeStep) {
    apply(session::SetSettingCommand{"time_step", fitting});
  }
  apply(session::SetSettingCommand{"view.pins", false});      // a tool for the user, not part of a picture
  apply(session::SetSettingCommand{"timeline.memory", 0.0});  // nobody goes back
  stepsPerFrame_ = stepsPerFrame(order_.request.rate, simulation.settings().step.timeStep);
  if (order_.beginning.valid()) {
    simulation.continueFrom(order_.beginning.get());
  } else {
    apply(session::ResetCommand{});
  }
}

void ExportJob::stopIfCancelled() const {
  if (stop_.stop_requested()) {
    throw Cancelled{};
  }
}

/// Takes the steps to a frame, counted from the beginning.
void ExportJob::simulateTo(session::Simulation& simulation, int frame) {
  const std::int64_t wanted = static_cast<std::int64_t>(frame) * stepsPerFrame_;
  const double all = static_cast<double>(stepsPerFrame_) * (firstFrame_ + frames_);
  for (; steps_ < wanted; ++steps_) {
    stopIfCancelled();
    simulation.step();
    if (simulation.blewUp()) {
      throw messages::InputError(simulation.message().english());
    }
    const std::scoped_lock lock(lock_);
    share_ = static_cast<double>(steps_ + 1) / all;
  }
  stopIfCancelled();
}

void ExportJob::writeMotion(session::Simulation& simulation) {
  MotionExport files({{order_.file}, order_.request.rate, {}}, simulation, FrameRange{firstFrame_, frames_});
  for (int frame = firstFrame_; frame < firstFrame_ + frames_; ++frame) {
    simulateTo(simulation, frame);
    files.addFrame(simulation, simulation.state().positions);
  }
  files.finish(simulation, simulation.state().positions);
}

void ExportJob::writeFilm(session::Simulation& simulation) {
  const ui::ExportRequest& request = order_.request;
  PictureFiles files(order_.file, frames_, request.width, request.height, request.rate);
  for (int frame = firstFrame_; frame < firstFrame_ + frames_; ++frame) {
    simulateTo(simulation, frame);
    files.add(picture(simulation, static_cast<double>(frame - firstFrame_) / frames_));
  }
  files.finish();
}

/// Waits until the thread of the window has drawn the present state.
render::Image ExportJob::picture(const session::Simulation& simulation, double share) {
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  std::unique_lock lock(lock_);
  wanted_ = std::move(snapshot);
  wantedShare_ = share;
  drawn_.reset();
  drawProblem_.clear();
  changed_.wait(lock, stop_.get_token(), [&] { return drawn_.has_value() || !drawProblem_.empty(); });
  if (!drawProblem_.empty()) {
    throw messages::InputError("the picture cannot be drawn: " + drawProblem_);
  }
  if (!drawn_) {
    throw Cancelled{};
  }
  return *std::exchange(drawn_, std::nullopt);
}

}  // namespace drape::app
