#pragma once

#include "render/image.hpp"

#include <sys/types.h>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace drape::app {

/// Whether the extension of a file, in any case, is that of a film: .mp4, .webm or .gif.
[[nodiscard]] bool isFilm(const std::filesystem::path& file);

/// A film from pictures. The program ffmpeg encodes it: it runs as a process and receives the pictures in a pipe. The
/// film is written beside its name and renamed at the end; an unfinished one is removed.
class FilmWriter {
 public:
  /// @param width, height of the pictures [pixels]  @param rate pictures per second
  /// Throws InputError when ffmpeg is not installed.
  FilmWriter(std::filesystem::path file, int width, int height, double rate);
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;
  ~FilmWriter();

  /// Throws InputError with the reason that ffmpeg gives when it cannot write the film.
  void add(const render::Image& picture);
  /// Ends the film after at least one picture. Throws as `add`.
  void finish();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void start(int width, int height, double rate);
  [[noreturn]] void fail();
  [[nodiscard]] int waitForEnd();

  std::filesystem::path name_;
  std::filesystem::path part_;
  std::unique_ptr<std::FILE, Closer> messages_;  // what ffmpeg writes to its standard error
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace drape::app
