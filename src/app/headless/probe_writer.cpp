#include "app/headless/probe_writer.hpp"

#include "app/command_line.hpp"
#include "messages/error.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

namespace drape::app {
namespace {

std::string partFileOf(const std::string& name) {
  return name + ".part";
}

void requireVertices(const std::vector<int>& vertices, int count) {
  for (const int vertex : vertices) {
    if (vertex >= count) {
      throw messages::UsageError("--probe " + std::to_string(vertex) + ": the cloth has the vertices 0 to " +
                                 std::to_string(count - 1));
    }
  }
}

}  // namespace

void ProbeArguments::addTo(CLI::App& app) {
  CLI::Option* probe = app.add_option("--probe", vertices,
                                      "Vertices at which to write the values of all fields in each step; right click a "
                                      "vertex in the viewer to see its number")
                           ->delimiter(',')
                           ->type_name("VERTEX,...")
                           ->check(CLI::Range(0, std::numeric_limits<int>::max()));
  CLI::Option* output =
      app.add_option("--probe-output", file, "File of these values (CSV)")->type_name("FILE")->check(notEmpty());
  probe->needs(output);
  output->needs(probe);
}

ProbeWriter::ProbeWriter(const ProbeArguments& arguments, session::Simulation& simulation)
    : vertices_(arguments.vertices), name_(arguments.file) {
  requireVertices(vertices_, simulation.model().vertexCount());
  file_.reset(std::fopen(partFileOf(name_).c_str(), "w"));
  if (!file_) {
    throw messages::InputError("cannot write the probes to " + name_ + ": " + std::strerror(errno));
  }
  simulation.apply(session::ObserveCommand{});
  std::fputs(fields::probeTitles(vertices_).c_str(), file_.get());
  sample(simulation);
}

void ProbeWriter::sample(const session::Simulation& simulation) {
  simulation.capture(snapshot_);
  fields_.take(snapshot_);
  std::fputs(fields::probeLine(snapshot_.time, fields::probe(fields_, vertices_)).c_str(), file_.get());
  if (std::ferror(file_.get()) != 0) {
    fail(errno);  // at once: the run stops early when the disk is full
  }
}

void ProbeWriter::close() {
  const bool written = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  const int reason = errno;
  if (std::fclose(file_.release()) != 0 || !written) {
    fail(reason);
  }
  std::error_code error;
  std::filesystem::rename(partFileOf(name_), name_, error);
  if (error) {
    fail(error.value());
  }
}

void ProbeWriter::fail(int reason) const {
  throw messages::InputError("the probes could not be written completely to " + name_ + ": " + std::strerror(reason));
}

}  // namespace drape::app
