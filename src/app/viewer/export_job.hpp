#pragma once

#include "render/image.hpp"
#include "scene/scene.hpp"
#include "session/simulation.hpp"
#include "session/snapshot.hpp"
#include "session/timeline.hpp"
#include "session/user_state.hpp"
#include "text/sentence.hpp"
#include "ui/export_request.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace drape::app {

/// What an export simulates and writes.
struct ExportOrder {
  ui::ExportRequest request;
  std::string file;                           ///< its name, see exportName()
  std::shared_ptr<const scene::Scene> scene;  ///< never null
  /// Where a dressed cloth starts [m]; null: as the scene has it.
  std::shared_ptr<const std::vector<Vec3>> placedStart;
  session::UserState user;                        ///< the user's settings, pins and bodies
  std::future<session::RecordedState> beginning;  ///< the present state; invalid: the export begins with the scene
};

/// Simulates a scene on its own thread and writes its motion or a film. It uses the same files as drape-headless. The
/// thread of the window draws the pictures of a film, since it has the OpenGL context.
class ExportJob {
 public:
  /// How an export ended.
  struct Outcome {
    text::Sentence message;  ///< one sentence
    bool hasFailed = false;
  };

  explicit ExportJob(ExportOrder order);
  ExportJob(const ExportJob&) = delete;
  ExportJob& operator=(const ExportJob&) = delete;
  /// Cancels.
  ~ExportJob();

  /// Draws a snapshot at that share of the film, from 0 to 1.
  using Draw = std::function<render::Image(const session::Snapshot& snapshot, double share)>;

  /// Draws the picture that the thread waits for, if it waits. @return whether it did
  bool serve(const Draw& draw);

  [[nodiscard]] ui::ExportProgress progress() const;

  /// Ends the export after the present step. An unfinished file is removed; finished files of a sequence stay.
  void cancel();

  /// The outcome once the export has ended.
  [[nodiscard]] std::optional<Outcome> poll();

 private:
  struct Cancelled {};
  void run();
  [[nodiscard]] text::Sentence write();
  void prepare(session::Simulation& simulation);
  void writeMotion(session::Simulation& simulation);
  void writeFilm(session::Simulation& simulation);
  void simulateTo(session::Simulation& simulation, int frame);
  [[nodiscard]] render::Image picture(const session::Simulation& simulation, double share);
  void stopIfCancelled() const;
  void finish(Outcome outcome);

  ExportOrder order_;
  int firstFrame_ = 0;
  int frames_ = 1;
  int stepsPerFrame_ = 1;
  std::int64_t steps_ = 0;  // so far
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();

  mutable std::mutex lock_;  // of the following
  std::condition_variable_any changed_;
  double share_ = 0.0;
  std::optional<session::Snapshot> wanted_;  // the picture that the thread waits for
  double wantedShare_ = 0.0;                 // of the film before it
  std::optional<render::Image> drawn_;
  std::string drawProblem_;
  std::optional<Outcome> outcome_;

  std::stop_source stop_;
  std::thread thread_;
};

}  // namespace drape::app
