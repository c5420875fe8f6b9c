#include <fmt/format.h>
#include <unistd.h>

#include <memory>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/new_problem/problem_text.hpp"
#include "app/new_problem/shipped_robot.hpp"
#include "app/new_problem/trial_folder.hpp"
#include "app/output.hpp"
#include "app/required_file.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPlaces = 4;
constexpr double kGapBelowTorch = 0.05;  // m, of a plate where the torch's body reaches the TCP

RobotSource robot_source(const NewCommand& command) {
  RobotSource source;
  source.urdf = command.urdf.empty() ? shipped_robot() : command.urdf;
  require_file(source.urdf, "a robot description", ".urdf");
  source.base_link = command.base_link;
  source.part_link = command.part_link;
  source.tip_link = command.tip_link;
  source.limits = command.limits;
  const fs::path beside = source.urdf.parent_path() / "joint_limits.yaml";
  std::error_code error;
  if (source.limits.empty() && fs::exists(beside, error)) source.limits = beside;
  return source;
}

/// @throws InvalidInput where something is there that may not be overwritten
void require_free(const fs::path& file, bool force) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw InvalidInput(file.string(), "is a folder", "a new file");
  if (!force && fs::exists(file, error))
    throw InvalidInput(file.string(), "exists already", "another name, or --force to overwrite it");
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder, error))
    throw InvalidInput(file.string(), "there is no folder " + folder.string(),
                       "a folder that exists");
  if (access(folder.c_str(), W_OK) != 0)
    throw InvalidInput(file.string(), folder.string() + " cannot be written to");
}

/// As it stands in a file of `folder`: relative, unless the two have no more in common than "/".
std::string path_from(const fs::path& folder, const fs::path& file) {
  if (file.empty()) return {};
  const fs::path whole = fs::weakly_canonical(fs::absolute(file));
  const fs::path from = fs::weakly_canonical(fs::absolute(folder));
  const bool share_a_folder = *std::next(whole.begin()) == *std::next(from.begin());
  return (share_a_folder ? whole.lexically_relative(from) : whole).string();
}

/// Tries what a new problem could say until one is solved.
class NewProblemSearch {
 public:
  NewProblemSearch(const NewCommand& command, RobotSource source)
      : command_(command),
        source_(std::move(source)),
        robot_(std::make_shared<const Robot>(load_robot(source_))),
        solver_(find_redundant_inverse_kinematics(robot_).solver) {}

  const Robot& robot() const { return *robot_; }

  /// @param settings of the trials. @throws InvalidInput where none is solved
  NewProblem solved_problem(const Settings& settings) {
    const SeamShape shape = command_.seam == "arc" ? SeamShape::arc : SeamShape::line;
    if (!solver_) fail("no inverse kinematics fits this chain");
    const auto places = reachable_places(*robot_, *solver_, shape, kPlaces);
    if (places.empty())
      fail(
          "its inverse kinematics reaches no short seam, neither with the torch down nor from "
          "postures of its own");
    Console console(settings);
    for (const Freedom freedom : freedoms()) {
      for (const std::optional<double>& gap : gaps()) {
        for (const SeamPlace& place : places) {
          NewProblem problem = trial_problem(place, shape, freedom, gap);
          if (is_solved(problem, console, settings) || interrupted()) return problem;
        }
      }
    }
    fail("no seam that it reaches could be planned");
  }

  /// With paths as they stand in a file of `folder`.
  NewProblem with_paths_from(const fs::path& folder, NewProblem problem) const {
    problem.urdf = path_from(folder, source_.urdf);
    problem.limits = path_from(folder, source_.limits);
    return problem;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw InvalidInput(source_.urdf.string(), why,
                       "another --base or --tip; wristwise info shows the chain");
  }

  std::vector<Freedom> freedoms() const {
    if (solver_->meets_every_pose()) return {Freedom::tilt_and_spin, Freedom::spin};
    return {Freedom::spin, Freedom::tilt_and_spin, Freedom::none};
  }

  static std::vector<std::optional<double>> gaps() { return {0.0, kGapBelowTorch, std::nullopt}; }

  NewProblem trial_problem(const SeamPlace& place, SeamShape shape, Freedom freedom,
                           std::optional<double> gap) const {
    NewProblem problem;
    problem.name = command_.file == "-" ? "my_seam" : command_.file.stem().string();
    problem.shape = shape;
    problem.place = place;
    problem.freedom = freedom;
    problem.plate_gap = place.torch_down ? gap : std::nullopt;
    if (command_.seam == "csv") problem.poses = problem.name + ".csv";
    return problem;
  }

  bool is_solved(const NewProblem& problem, Console& console, const Settings& settings) const {
    const TrialFolder folder;
    const fs::path file = folder.path() / "trial.yaml";
    write_text(file, problem_text(with_paths_from(folder.path(), problem), *robot_));
    if (!problem.poses.empty())
      write_text(folder.path() / problem.poses, poses_text(problem.place));
    Problem loaded = load_problem(file, load_options(settings));
    loaded.graph.try_relaxations = loaded.refine.try_speeds = false;
    return plan(loaded, console.plan_options(loaded)).status == Status::solved;
  }

  const NewCommand& command_;
  RobotSource source_;
  std::shared_ptr<const Robot> robot_;
  std::shared_ptr<const InverseKinematics> solver_;
};

}  // namespace

int run_new(const NewCommand& command, const Settings& settings) {
  const bool to_stdout = command.file == "-";
  const fs::path folder = to_stdout ? fs::path(".") : fs::absolute(command.file).parent_path();
  const fs::path poses = fs::path(command.file).replace_extension(".csv");
  if (to_stdout && command.seam == "csv")
    throw InvalidInput("--seam csv", "the poses need a file of their own", "a FILE in place of -");
  if (!to_stdout) require_free(command.file, command.force);
  if (command.seam == "csv") require_free(poses, command.force);

  NewProblemSearch search(command, robot_source(command));
  const NewProblem problem = search.with_paths_from(folder, search.solved_problem(settings));
  if (interrupted()) return kInterrupted;
  const std::string text = problem_text(problem, search.robot());
  if (to_stdout) {
    fmt::print("{}", text);
    return kSolved;
  }
  if (!problem.poses.empty()) write_text(poses, poses_text(problem.place));
  write_text(command.file, text);
  const Paint paint(settings.colour, STDOUT_FILENO);
  print(
      fmt::format("written to {}: a seam of {:.2g} m for {}, planned once as a trial\n{} wristwise "
                  "plan {}\n",
                  command.file.string(), problem.place.length, search.robot().name(),
                  paint.bold("next:"), command.file.string()));
  return kSolved;
}

}  // namespace wristwise::app
