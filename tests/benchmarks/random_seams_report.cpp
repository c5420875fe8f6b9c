// Runs the random test bed and says how it went. By hand; docs/benchmarks.md has the figures.
//   random_seams_report --first 0 --count 300 --csv seams.csv
//   random_seams_report --seam 17 --write seam_17.yaml      the problem file of one seam

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "acceptance/random_seams.hpp"
#include "benchmark_problems.hpp"

namespace wristwise::benchmarks {
namespace {

namespace bed = test::bed;

constexpr int kSamplesPerInterval = 50;

/// Largest |q''| (rad/s^2) and |q'''| (rad/s^3) of joints 4 and 6, by divided differences.
struct WristPeaks {
  double acceleration = 0, jerk = 0;
};

WristPeaks wrist_peaks(const JointPath& path) {
  const auto peak = [&](int derivative) {
    double largest = 0;
    for (const JointVector& value : divided_differences(path, derivative)) {
      largest = std::max({largest, std::abs(value[3]), std::abs(value[5])});
    }
    return largest;
  };
  return {peak(2), peak(3)};
}

struct Outcome {
  bed::RandomSeam seam;
  PlanResult result;
  bool rejected = false;        ///< solved, but the denser check says no
  WristPeaks graph, two_stage;  ///< where solved
};

/// A folder for what passes through files.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("wristwise_random_seams_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// The check of what is written, as anyone would do it: through trajectory.csv, and denser.
bool passes_dense_check(const Problem& problem, const PlanResult& result, const Folder& folder) {
  std::vector<std::string> names;
  for (const Joint& joint : problem.robot->joints()) names.push_back(joint.name);
  const auto file = folder / "trajectory.csv";
  write_trajectory(file, names, result.trajectory);
  PlanOptions options;
  options.verification.samples_per_interval = kSamplesPerInterval;
  return check(problem, *read_trajectory(file, names).trajectory, options).passed;
}

Outcome run(int index, int thread_count, const Folder& folder) {
  Outcome outcome;
  outcome.seam = bed::random_seam(index);
  write_file(folder / "seam.yaml", outcome.seam.problem);
  const Problem problem = load_problem(folder / "seam.yaml");
  outcome.result = plan(problem, threads(thread_count));
  if (outcome.result.status == Status::solved) {
    outcome.rejected = !passes_dense_check(problem, outcome.result, folder);
    outcome.graph = wrist_peaks(outcome.result.seeds.front().path);
    outcome.two_stage = wrist_peaks(outcome.result.path);
  }
  return outcome;
}

std::string name_of(Status status) {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::infeasible:
      return "infeasible";
    case Status::failed:
      return "failed";
    case Status::interrupted:
      break;
  }
  return "interrupted";
}

std::string first_line(const PlanResult& result) {
  if (result.diagnosis.empty()) return "NO DIAGNOSIS";
  std::string detail = result.diagnosis.front().reason + ": ";
  for (const Diagnosis& diagnosis : result.diagnosis) detail += diagnosis.detail + "; ";
  std::replace(detail.begin(), detail.end(), '"', '\'');
  return detail;
}

void write_row(std::FILE* out, const Outcome& o) {
  const PlanResult& r = o.result;
  std::fprintf(out, "%d,%s,%d,%s,%d,%.4f,%.4f,%d,%d,%.6g,%.6g,%.6g,%.6g,%.6g,\"%s\"\n",
               o.seam.index, bed::name_of(o.seam.kind).c_str(), o.seam.singular ? 1 : 0,
               name_of(r.status).c_str(), o.rejected ? 1 : 0, r.timing.total, r.timing.refine,
               r.refine.rounds, r.refine.iterations, r.refine.objective, o.graph.acceleration,
               o.two_stage.acceleration, o.graph.jerk, o.two_stage.jerk,
               r.status == Status::solved ? "" : first_line(r).c_str());
  std::fflush(out);
}

constexpr const char* kHeader =
    "index,kind,singular,status,rejected,total_s,refine_s,rounds,iterations,objective,"
    "graph_acceleration,two_stage_acceleration,graph_jerk,two_stage_jerk,diagnosis\n";

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Value>
void print_spread(const char* what, const std::vector<Outcome>& outcomes, const Value& value) {
  std::vector<double> values;
  for (const Outcome& outcome : outcomes) values.push_back(value(outcome));
  if (values.empty()) return;
  std::printf("%-44s median %10.4g   least %10.4g   largest %10.4g\n", what, median(values),
              *std::min_element(values.begin(), values.end()),
              *std::max_element(values.begin(), values.end()));
}

void print_counts(const char* what, const std::vector<Outcome>& outcomes) {
  std::map<Status, std::size_t> counts;
  for (const Outcome& outcome : outcomes) ++counts[outcome.result.status];
  std::printf("%-24s %4zu: solved %zu, infeasible %zu, failed %zu\n", what, outcomes.size(),
              counts[Status::solved], counts[Status::infeasible], counts[Status::failed]);
}

template <class Condition>
std::vector<Outcome> where(const std::vector<Outcome>& outcomes, const Condition& condition) {
  std::vector<Outcome> chosen;
  std::copy_if(outcomes.begin(), outcomes.end(), std::back_inserter(chosen), condition);
  return chosen;
}

void print_summary(const std::vector<Outcome>& outcomes) {
  print_counts("all seams", outcomes);
  for (const bed::Kind kind : {bed::Kind::line, bed::Kind::arc, bed::Kind::corner}) {
    print_counts(bed::name_of(kind).c_str(),
                 where(outcomes, [&](const Outcome& o) { return o.seam.kind == kind; }));
  }
  const auto singular = where(outcomes, [](const Outcome& o) { return o.seam.singular; });
  print_counts("past the singularity", singular);
  const auto solved =
      where(outcomes, [](const Outcome& o) { return o.result.status == Status::solved; });
  std::printf("solved, but rejected at %d samples an interval: %zu\n", kSamplesPerInterval,
              where(solved, [](const Outcome& o) { return o.rejected; }).size());
  print_spread("time, all, s", outcomes, [](const Outcome& o) { return o.result.timing.total; });
  print_spread("time of refine, solved, s", solved,
               [](const Outcome& o) { return o.result.timing.refine; });
  const auto print_peaks = [](const std::string& which, const std::vector<Outcome>& of) {
    const auto show = [&](const char* what, const auto& value) {
      print_spread((which + what).c_str(), of, value);
    };
    show(": graph q''4,6, rad/s^2", [](const Outcome& o) { return o.graph.acceleration; });
    show(": two-stage q''4,6", [](const Outcome& o) { return o.two_stage.acceleration; });
    show(": graph / two-stage",
         [](const Outcome& o) { return o.graph.acceleration / o.two_stage.acceleration; });
    show(": graph q'''4,6, rad/s^3", [](const Outcome& o) { return o.graph.jerk; });
    show(": two-stage q'''4,6", [](const Outcome& o) { return o.two_stage.jerk; });
    show(": graph / two-stage", [](const Outcome& o) { return o.graph.jerk / o.two_stage.jerk; });
  };
  print_peaks("solved", solved);
  print_peaks("solved, singular", where(solved, [](const Outcome& o) { return o.seam.singular; }));
}

void report(int first, int count, int thread_count, const std::string& csv) {
  const Folder folder;
  std::FILE* table = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
  if (table != nullptr) std::fputs(kHeader, table);
  std::vector<Outcome> outcomes;
  for (int index = first; index < first + count; ++index) {
    outcomes.push_back(run(index, thread_count, folder));
    const Outcome& outcome = outcomes.back();
    if (table != nullptr) write_row(table, outcome);
    if (outcome.result.status != Status::solved || outcome.rejected) {
      std::printf("%4d %s%s %s%s: %s\n", index, bed::name_of(outcome.seam.kind).c_str(),
                  outcome.seam.singular ? " singular" : "", name_of(outcome.result.status).c_str(),
                  outcome.rejected ? " but REJECTED" : "", first_line(outcome.result).c_str());
      std::fflush(stdout);
    }
  }
  if (table != nullptr) std::fclose(table);
  print_summary(outcomes);
}

}  // namespace
}  // namespace wristwise::benchmarks

int main(int argc, char** argv) {
  using namespace wristwise;
  CLI::App app("The random test bed");
  int first = 0, count = 300, thread_count = 1, index = -1;
  std::string csv, yaml;
  app.add_option("--first", first, "first seam");
  app.add_option("--count", count, "number of seams");
  app.add_option("--threads", thread_count, "threads of stage 1");
  app.add_option("--csv", csv, "table of all seams");
  app.add_option("--seam", index, "with --write: which seam");
  app.add_option("--write", yaml, "writes the problem file of the seam and stops");
  CLI11_PARSE(app, argc, argv);
  if (!yaml.empty()) {
    benchmarks::write_file(yaml, test::bed::random_seam(index).problem);
    return 0;
  }
  benchmarks::report(first, count, thread_count, csv);
}
