#include "app/export/film_writer.hpp"

#include "messages/error.hpp"
#include "text/words.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has no header for it

namespace drape::app {
namespace {

constexpr std::string_view missing =
    "the program ffmpeg, which makes films, is not installed. Install the package ffmpeg (apt-get install ffmpeg), or "
    "write pictures: frame_{frame:4}.png";

std::string endingOf(const std::filesystem::path& file) {
  return text::lowerCase(file.extension().string());
}

/// FILM.part.mp4, since ffmpeg chooses the format by the extension.
std::filesystem::path partOf(const std::filesystem::path& film) {
  std::filesystem::path part = film;
  part += ".part" + endingOf(film);
  return part;
}

/// How ffmpeg encodes a film.
std::vector<std::string> encoding(const std::string& ending) {
  if (ending == ".gif") {
    // A palette for each picture, so that ffmpeg need not keep them all.
    return {"-filter_complex", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1"};
  }
  // Both numbers of pixels must be even.
  std::vector<std::string> words{"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
  const std::vector<std::string> codec =
      ending == ".mp4" ? std::vector<std::string>{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"}
                       : std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "30",        "-b:v",
                                                  "0",    "-deadline",  "good", "-cpu-used", "4"};
  words.insert(words.end(), codec.begin(), codec.end());
  return words;
}

/// The standard streams, the signals and the process group of ffmpeg. Ctrl-C must not reach it: this program ends the
/// film.
class SpawnOptions {
 public:
  SpawnOptions(int input, int errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;
  ~SpawnOptions() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

bool isFilm(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

FilmWriter::FilmWriter(std::filesystem::path file, int width, int height, double rate)
    : name_(std::move(file)), part_(partOf(name_)), messages_(std::tmpfile()) {
  if (!messages_) {
    throw messages::InputError("cannot write " + name_.string() + ": no temporary file (" + std::strerror(errno) + ")");
  }
  start(width, height, rate);
}

FilmWriter::~FilmWriter() {
  if (process_ >= 0) {
    kill(process_, SIGKILL);
    (void)waitForEnd();
  }
  if (pipe_ >= 0) {
    ::close(pipe_);
  }
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void FilmWriter::start(int width, int height, double rate) {
  // A socket, since writing to one whose reader has ended can be an error instead of a signal.
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw messages::InputError("cannot write " + name_.string() + ": " + std::strerror(errno));
  }
  pipe_ = ends[0];
  std::vector<std::string> words{"ffmpeg",
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-y",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgb24",
                                 "-video_size",
                                 fmt::format("{}x{}", width, height),
                                 "-framerate",
                                 fmt::format("{:.9g}", rate),
                                 "-i",
                                 "pipe:0"};
  const std::vector<std::string> format = encoding(endingOf(name_));
  words.insert(words.end(), format.begin(), format.end());
  words.push_back("file:" + part_.string());
  std::vector<char*> arguments;
  std::ranges::transform(words, std::back_inserter(arguments), [](std::string& word) { return word.data(); });
  arguments.push_back(nullptr);
  const SpawnOptions options(ends[1], fileno(messages_.get()));
  const int problem =
      posix_spawnp(&process_, "ffmpeg", options.actions(), options.attributes(), arguments.data(), environ);
  ::close(ends[1]);
  if (problem != 0) {
    process_ = -1;
    throw messages::InputError(problem == ENOENT ? std::string(missing)
                                                 : "ffmpeg cannot be started: " + std::string(std::strerror(problem)));
  }
}

int FilmWriter::waitForEnd() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void FilmWriter::fail() {
  if (pipe_ >= 0) {
    ::close(std::exchange(pipe_, -1));
  }
  if (process_ >= 0) {
    (void)waitForEnd();
  }
  std::rewind(messages_.get());
  std::array<char, 400> text{};
  const std::size_t count = std::fread(text.data(), 1, text.size(), messages_.get());
  std::string reason(text.data(), count);
  std::ranges::replace(reason, '\n', ' ');
  throw messages::InputError("cannot write " + name_.string() + ": ffmpeg failed (" +
                             (reason.empty() ? "without a message" : reason) +
                             "). Check the folder and the space on the disk.");
}

void FilmWriter::add(const render::Image& picture) {
  const std::uint8_t* from = picture.rgb.data();
  for (std::size_t left = picture.rgb.size(); left > 0;) {
    const ssize_t count = send(pipe_, from, left, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) {
      fail();
    }
    const auto sent = static_cast<std::size_t>(std::max<ssize_t>(0, count));
    from += sent;
    left -= sent;
  }
}

void FilmWriter::finish() {
  ::close(std::exchange(pipe_, -1));
  if (const int status = waitForEnd(); !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    fail();
  }
  std::error_code problem;
  std::filesystem::rename(part_, name_, problem);
  if (problem) {
    throw messages::InputError("cannot write " + name_.string() + ": " + problem.message());
  }
}

}  // namespace drape::app
