#include "bench/suite.hpp"

#include <benchmark/benchmark.h>
#include <sched.h>
#include <map>
#include <memory>
#include <regex>
#include <utility>

namespace drape::bench {
namespace {

/// Binds this thread, and those that it starts, to the last of its allowed cores; the first core handles interrupts.
class Pinned {
 public:
  explicit Pinned(int cores) {
    sched_getaffinity(0, sizeof(before_), &before_);
    cpu_set_t chosen;
    CPU_ZERO(&chosen);
    for (int core = CPU_SETSIZE - 1; core >= 0 && cores > 0; --core) {
      if (CPU_ISSET(core, &before_)) {
        CPU_SET(core, &chosen);
        --cores;
      }
    }
    sched_setaffinity(0, sizeof(chosen), &chosen);
  }
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;
  ~Pinned() { sched_setaffinity(0, sizeof(before_), &before_); }

 private:
  cpu_set_t before_{};
};

/// Passes the time of every repetition to the results instead of printing it.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration && !run.error_occurred && run.iterations > 0) {
        seconds[run.run_name.function_name].push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
      }
    }
  }

  std::map<std::string, std::vector<double>> seconds;  // a batch
};

std::string nameOf(const Row& row) {
  return row.group + "/" + row.name;
}

}  // namespace

void Suite::add(const Row& row, std::function<Batch()> make, int cores) {
  auto batch = std::make_shared<Batch>();
  entries_.push_back({row, batch});
  auto* registered = benchmark::RegisterBenchmark(nameOf(row).c_str(),
                                                  [batch, make = std::move(make), cores](benchmark::State& state) {
                                                    const Pinned pinned(cores);
                                                    if (!batch->seconds) {
                                                      *batch = make();
                                                      batch->seconds();
                                                    }
                                                    for ([[maybe_unused]] auto iteration : state) {
                                                      state.SetIterationTime(batch->seconds());
                                                    }
                                                  });
  registered->UseManualTime();
}

void Suite::addFigure(const Row& row, std::function<double()> find) {
  figures_.push_back({row, std::move(find)});
}

Results Suite::run(const std::string& filter, int repetitions, double seconds) {
  std::vector<std::string> arguments{
      "drape_bench", "--benchmark_enable_random_interleaving=true", "--benchmark_filter=" + filter,
      "--benchmark_repetitions=" + std::to_string(repetitions), "--benchmark_min_time=" + std::to_string(seconds)};
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::Shutdown();

  Results results;
  for (const Entry& entry : entries_) {
    const auto found = collector.seconds.find(nameOf(entry.row));
    if (found != collector.seconds.end()) {
      std::vector<double> values = found->second;
      for (double& value : values) {
        value *= unitsPerSecond(entry.row.unit) / entry.batch->items;
      }
      results.lines.push_back({entry.row, statisticsOf(std::move(values))});
    }
  }
  const std::regex wanted(filter == "all" ? "." : filter);
  for (const Figure& figure : figures_) {
    if (std::regex_search(nameOf(figure.row), wanted)) {
      results.lines.push_back({figure.row, statisticsOf({figure.find()})});
    }
  }
  results.addRatios(ratios_);
  return results;
}

}  // namespace drape::bench
