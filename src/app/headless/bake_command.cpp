#include "app/command_line.hpp"
#include "app/export/film_writer.hpp"
#include "app/export/frame_rate.hpp"
#include "app/export/motion_export.hpp"
#include "app/export/output_name.hpp"
#include "app/headless/bake_folder.hpp"
#include "app/headless/checkpoint_file.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/end_warnings.hpp"
#include "app/headless/intact.hpp"
#include "app/headless/pierced_start.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/headless/view_arguments.hpp"
#include "app/progress_line.hpp"
#include "app/report/stop_signal.hpp"
#include "app/used_files.hpp"
#include "messages/error.hpp"
#include "render/image.hpp"

#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct BakeArguments {
  SceneArguments scene;
  std::string frames;
  ExportArguments exports;
  std::string film;
  ViewArguments view;
  double checkpointEvery = 30.0;
};

/// "240" means the frames 0 to 239, "1-240" the frames 1 to 240.
FrameRange rangeOf(const std::string& text) {
  constexpr int maxFrame = 1000000;
  const std::size_t dash = text.find('-');
  const auto number = [&text](std::string_view digits) {
    int value = -1;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || value < 0 || value > maxFrame) {
      throw messages::UsageError("--frames '" + text + "' is neither a number, as 240, nor a range, as 1-240");
    }
    return value;
  };
  const std::string_view whole = text;
  const int first = dash == std::string::npos ? 0 : number(whole.substr(0, dash));
  const int last = dash == std::string::npos ? number(whole) - 1 : number(whole.substr(dash + 1));
  if (last < first) {
    throw messages::UsageError("--frames '" + text + "' has no frames");
  }
  return {first, last - first + 1};
}

/// A bake from its start, or from where an earlier run of the same command stopped, to its files.
class Bake {
 public:
  Bake(const BakeArguments& arguments, session::Simulation& simulation)
      : arguments_(arguments),
        simulation_(simulation),
        range_(rangeOf(arguments.frames)),
        film_(withSettings(arguments.film, simulation.settings())),
        stepsPerFrame_(stepsPerFrame(arguments.exports.frameRate(), simulation.settings().step.timeStep)),
        // Opened at once, so that a wrong folder shows before the simulation.
        exports_(arguments.exports, simulation, range_),
        folder_(folderName(), simulation.state().positions.size(), film_.empty() ? "none" : arguments.view.inWords()) {
    requireOwnFiles();
    if (folder_.hasCheckpoint()) {
      requireNoChange(resumed());
      done_ = simulation_.stepIndex() / stepsPerFrame_ + 1;
      std::cerr << "note: continues after frame " << done_ - 1 << " of " << folderName() << '\n';
    }
    folder_.keep(done_);
    if (!film_.empty()) {
      pictures_ = arguments.view.makerFor(simulation_);
    }
  }

  /// Simulates all frames. Throws InputError when a signal stops it.
  void simulate(StopSignal& stop) {
    ProgressLine progress;
    double saved = 0.0;
    for (; done_ <= last(); ++done_) {
      if (stop.came()) {
        if (done_ > 0) {
          save();
        }
        throw messages::InputError("stopped by a signal after frame " + std::to_string(done_ - 1) +
                                   "; the same command continues from there");
      }
      for (int i = 0; done_ > 0 && i < stepsPerFrame_ && !simulation_.blewUp(); ++i) {
        simulation_.step();
      }
      requireIntact(simulation_);
      keepFrame();
      progress.show("baking", static_cast<double>(done_ + 1), last() + 1.0);
      if (progress.spent() - saved >= arguments_.checkpointEvery) {
        saved = progress.spent();
        save();
      }
    }
  }

  /// Writes the files from the frames, and removes the folder.
  void write() {
    save();  // if a file cannot be written, the same command writes it without a new simulation
    for (int frame = range_.first; frame <= last(); ++frame) {
      exports_.addFrame(simulation_, folder_.positions(frame));
    }
    exports_.finish(simulation_, folder_.positions(last()));
    if (!film_.empty()) {
      writeFilm();
    }
    for (const std::string& line : exports_.summary()) {
      std::cout << line << '\n';
    }
    folder_.remove();
  }

 private:
  [[nodiscard]] int last() const { return range_.first + range_.count - 1; }

  [[nodiscard]] std::string folderName() const {
    return withSettings(arguments_.exports.files.empty() ? arguments_.film : arguments_.exports.files.front(),
                        simulation_.settings()) +
           ".bake";
  }

  /// Continues from the checkpoint in the folder. @return what has changed since
  [[nodiscard]] std::vector<std::string> resumed() {
    try {
      return resumeFrom(folder_.checkpoint(), simulation_);
    } catch (const messages::InputError& error) {
      throw messages::InputError(error.what() + (" Or remove the folder " + folderName()) + " to start anew.");
    }
  }

  /// Throws UsageError if a setting or the scene has changed since the frames in the folder, which would come from two
  /// motions.
  void requireNoChange(const std::vector<std::string>& changes) const {
    if (!changes.empty()) {
      throw messages::UsageError(changes.front() +
                                 "; give the same scene and settings as the unfinished bake, or remove the folder " +
                                 folderName() + " to start anew");
    }
  }

  /// Throws UsageError if a file would replace a file of the scene or another one.
  void requireOwnFiles() const {
    UsedFiles files(simulation_.scene());
    files.read(arguments_.scene.fabrics);
    files.write(film_, "--film");
    for (const std::filesystem::path& file : exports_.files()) {
      files.write(file, "--export");
    }
  }

  void keepFrame() {
    folder_.append(simulation_.state().positions);
    if (pictures_) {
      render::writePng(pictures_->draw(simulation_), folder_.picture(done_));
    }
  }

  /// A checkpoint after the present frame, once all frames are on the disk.
  void save() {
    folder_.synchronise();
    CheckpointFile(folder_.checkpoint(), simulation_).write(simulation_);
  }

  void writeFilm() {
    const int width = arguments_.view.resolution[0];
    const int height = arguments_.view.resolution[1];
    FilmWriter film(film_, width, height, arguments_.exports.frameRate());
    for (int frame = range_.first; frame <= last(); ++frame) {
      film.add(render::readPng(folder_.picture(frame)));
    }
    film.finish();
    std::cout << film_ << ": " << range_.count << " pictures\n";
  }

  const BakeArguments& arguments_;
  session::Simulation& simulation_;
  FrameRange range_;
  std::string film_;
  int stepsPerFrame_;
  MotionExport exports_;
  BakeFolder folder_;
  std::unique_ptr<PictureMaker> pictures_;
  std::int64_t done_ = 0;  // number of frames in the folder
};

void bake(BakeArguments arguments) {
  if (arguments.exports.files.empty() && arguments.film.empty()) {
    throw messages::UsageError("bake needs --export or --film: the files to write");
  }
  if (!arguments.film.empty() && !isFilm(arguments.film)) {
    throw messages::UsageError("--film " + arguments.film + ": films are .mp4, .webm or .gif");
  }
  StopSignal stop;
  arguments.scene.adjust = fitTimeStep(arguments.exports.frameRate(), arguments.scene.settings);
  const auto scene = arguments.scene.load();
  printPiercedStart(scene);
  session::Simulation simulation(scene);
  printSolverWarnings(simulation.settings(), simulation.model());
  Bake work(arguments, simulation);
  work.simulate(stop);
  printEndWarnings(simulation);
  work.write();
}

}  // namespace

void addBakeCommand(CLI::App& app) {
  constexpr double oneDay = 86400.0;
  auto arguments = std::make_shared<BakeArguments>();
  CLI::App* command = app.add_subcommand("bake", "Writes exports and a film; continues after an interruption");
  arguments->scene.addTo(*command);
  command->add_option("--frames", arguments->frames, "240 for the frames 0 to 239, 1-240 for a range")
      ->required()
      ->type_name("N|A-B");
  arguments->exports.addTo(*command);
  command->add_option("--film", arguments->film, "Write a film: .mp4, .webm or .gif")
      ->type_name("FILE")
      ->check(notEmpty());
  arguments->view.addTo(*command);
  command
      ->add_option("--checkpoint-every", arguments->checkpointEvery,
                   "Time between two checkpoints [s]; 0: after each frame; default 30")
      ->check(numberFrom(0.0, oneDay));
  command->callback([arguments] { bake(*arguments); });
}

}  // namespace drape::app
