#include "app/headless/position_writer.hpp"

#include "messages/error.hpp"

#include <cerrno>
#include <cstring>

namespace drape::app {

PositionWriter::PositionWriter(const std::string& file, double every, double timeStep)
    : name_(file), file_(std::fopen(file.c_str(), "w")), every_(every), tolerance_(0.5 * timeStep) {
  if (!file_) {
    throw messages::InputError("cannot write positions to " + file + ": " + std::strerror(errno));
  }
  std::fputs("time,vertex,x,y,z\n", file_.get());
}

void PositionWriter::sample(const sim::ClothState& state) {
  if (state.time + tolerance_ <= every_ * static_cast<double>(samples_)) {
    return;
  }
  // A step longer than the interval skips samples.
  while (every_ * static_cast<double>(samples_) < state.time + tolerance_) {
    ++samples_;
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3& position = state.positions[v];
    std::fprintf(file_.get(), "%.9g,%zu,%.9g,%.9g,%.9g\n", state.time, v, position.x(), position.y(), position.z());
  }
  if (std::ferror(file_.get()) != 0) {
    fail(errno);  // at once: the run stops early when the disk is full
  }
}

void PositionWriter::close() {
  const bool written = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  const int reason = errno;
  if (std::fclose(file_.release()) != 0 || !written) {
    fail(reason);
  }
}

void PositionWriter::fail(int reason) const {
  throw messages::InputError("positions could not be written completely to " + name_ + ": " + std::strerror(reason));
}

}  // namespace drape::app
