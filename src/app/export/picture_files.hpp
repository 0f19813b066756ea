#pragma once

#include "app/export/film_writer.hpp"
#include "app/export/frame_name.hpp"
#include "render/image.hpp"

#include <optional>
#include <string>

namespace drape::app {

/// The pictures of a run: one PNG file each, or a film, as the name of the file says.
class PictureFiles {
 public:
  /// Creates the folder and starts the film, so that an error shows before the run.
  /// @param file name with a placeholder for the number of a picture, or that of a film
  /// @param pictures how many there will be  @param width, height of them [pixels]  @param rate pictures per second
  /// Throws UsageError for a name that does not fit, and InputError as FilmWriter.
  PictureFiles(const std::string& file, int pictures, int width, int height, double rate);

  /// Throws InputError when the picture cannot be written.
  void add(const render::Image& picture);
  /// Ends the film. Throws InputError when it cannot be written.
  void finish();

  /// The number of pictures so far.
  [[nodiscard]] int count() const { return count_; }
  /// "3 pictures at 30 a second: flag.mp4", "3 pictures: f_0.png to f_2.png".
  [[nodiscard]] std::string summary() const;

 private:
  FramePattern pattern_;
  std::optional<FilmWriter> film_;
  double rate_;  // pictures per second
  int count_ = 0;
};

}  // namespace drape::app
