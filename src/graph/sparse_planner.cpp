#include "graph/sparse_planner.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cancelled.hpp"
#include "graph/sub_task.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {

namespace {

constexpr std::size_t kFirstShare = 10;  // one waypoint in ten

class SparsePlan {
 public:
  SparsePlan(const SamplingInput& input, const Task& task, double epsilon, int threads,
             const Monitor& monitor)
      : input_(input),
        task_(task),
        epsilon_(epsilon),
        threads_(threads),
        monitor_(monitor),
        dense_(input, task, epsilon, threads, monitor) {
    const std::size_t last = task.waypoints.size() - 1;
    for (std::size_t i = 0; i <= last; i += kFirstShare) points_.insert(i);
    points_.insert(last);
    for (std::size_t i = 0; i <= last; ++i) {
      if (task.waypoints[i].joints) points_.insert(i);
    }
  }

  SparsePath run() {
    for (;; ++result_.replans) {
      throw_if_cancelled(monitor_);
      const std::size_t before = points_.size();
      const LadderPath path = plan_points();
      result_.points.assign(points_.begin(), points_.end());
      if (path.found) {
        fill(path);
      } else if (!split_before(path.positions.size())) {
        result_.path.found = false;
        result_.path.positions.clear();  // of points only
        break;
      }
      if (points_.size() == before) break;
    }
    finish();
    return std::move(result_);
  }

 private:
  LadderPath plan_points() {
    const std::vector<std::size_t> points(points_.begin(), points_.end());
    const SubTask some = sub_task(task_, input_.cost, points);
    const SamplingInput input{input_.robot, input_.ik, input_.clearance, some.cost, input_.options};
    // Straight moves between points that are not neighbours are no moves to be made: they are
    // projected first.
    GraphSearch search(input, some.task, epsilon_, threads_, monitor_);
    std::vector<bool> are_neighbours;
    for (std::size_t k = 1; k < points.size(); ++k) {
      are_neighbours.push_back(points[k] == points[k - 1] + 1);
    }
    search.check_moves_only_in(std::move(are_neighbours));
    const std::vector<Rung> rungs = rungs_of(points);
    LadderPath path;
    if (!rungs.empty()) path = search.find_path(rungs);
    path.found = path.found && rungs.size() == points.size();
    result_.queries += search.moves().queries();
    add(path.statistics);
    result_.path.found = path.found;
    result_.path.positions = path.positions;
    return path;
  }

  /// Samples the points that are new; only those before the first without a vertex.
  std::vector<Rung> rungs_of(const std::vector<std::size_t>& points) {
    std::vector<std::size_t> indices;
    for (const std::size_t point : points) {
      if (rungs_.count(point) == 0) indices.push_back(point);
    }
    const SubTask fresh = sub_task(task_, input_.cost, indices);
    SampledPath sampled = sample_path(input_, fresh.task, threads_, {});
    result_.postures += sampled.postures;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      rungs_[indices[k]] = std::move(sampled.rungs[k]);
    }
    std::vector<Rung> rungs;
    for (const std::size_t point : points) {
      if (rungs_[point].size() == 0) break;
      rungs.push_back(rungs_[point]);
    }
    return rungs;
  }

  /// Adds a waypoint to the interval that ends at this point; false where there is none left.
  bool split_before(std::size_t failing) {
    const std::vector<std::size_t> points(points_.begin(), points_.end());
    if (failing == 0) return false;
    for (std::size_t k = failing; k < points.size(); ++k) {
      if (points[k] - points[k - 1] < 2) continue;
      points_.insert(points[k - 1] + (points[k] - points[k - 1]) / 2);
      return true;
    }
    return false;
  }

  /// Postures for every waypoint; where that fails, new points.
  void fill(const LadderPath& path) {
    const std::vector<std::size_t> points(points_.begin(), points_.end());
    std::vector<JointVector> positions = {path.positions.front()};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const auto failing =
          join(points[k], points[k + 1], path.positions[k], path.positions[k + 1], positions);
      if (failing) points_.insert(*failing);
    }
    result_.path.positions = std::move(positions);
  }

  /// Appends the postures of the waypoints after `a` up to `b`.
  /// @return a waypoint between that should be planned itself
  std::optional<std::size_t> join(std::size_t a, std::size_t b, const JointVector& from,
                                  const JointVector& to, std::vector<JointVector>& positions) {
    const double t0 = task_.waypoints[a].time, t1 = task_.waypoints[b].time;
    std::optional<std::size_t> failing;
    for (std::size_t i = a + 1; i <= b; ++i) {
      JointVector q = to;
      if (i < b) {
        const double s = (task_.waypoints[i].time - t0) / (t1 - t0);
        const JointVector straight = from + s * (to - from);
        const std::optional<JointVector> projected = project(i, straight);
        if (!projected) {
          if (!failing) failing = i;
          q = straight;
        } else {
          q = *projected;
        }
      }
      if (!failing && b - a > 1 && !can_move(i - 1, positions.back(), q)) {
        failing = i < b ? i : i - 1;
      }
      positions.push_back(q);
    }
    return failing;
  }

  /// The posture in tolerance that is nearest to an interpolated one, if it is near enough.
  std::optional<JointVector> project(std::size_t index, const JointVector& straight) {
    const Waypoint& waypoint = task_.waypoints[index];
    const Pose tcp = tcp_pose(input_.robot, straight);
    Vector6 e = deviation(waypoint.tolerance, waypoint.frame, tcp);
    for (int k = 0; k < 6; ++k) {
      if (waypoint.tolerance.is_free(k)) continue;
      e[k] = std::clamp(e[k], waypoint.tolerance.lower[k], waypoint.tolerance.upper[k]);
    }
    std::vector<JointVector> branches, postures;
    input_.ik.solve_beside(pose_at_deviation(waypoint.tolerance, waypoint.frame, e), straight,
                           branches);
    for (const JointVector& branch : branches) {
      append_turns(input_.robot, branch, input_.options.turns, postures);
    }
    const JointVector* nearest = nullptr;
    double least = input_.options.sparse_deviation;
    for (const JointVector& q : postures) {
      const double distance = (q - straight).cwiseAbs().maxCoeff();
      if (distance > least) continue;
      least = distance;
      nearest = &q;
    }
    if (nearest == nullptr || !dense_.moves().has_clearance(0, index, *nearest))
      return std::nullopt;
    return *nearest;
  }

  bool can_move(std::size_t interval, const JointVector& from, const JointVector& to) {
    const EdgeRules& rules = dense_.rules();
    if (((to - from).cwiseAbs().array() > rules.max_step[interval].array()).any()) return false;
    if (rules.is_near && !rules.is_near(interval, from, to)) return false;
    ++result_.moves;
    return !rules.is_clear || rules.is_clear(0, interval, from, to);
  }

  void finish() {
    result_.queries += dense_.moves().queries();
    result_.path.statistics.clear_checks += result_.moves;
    set_cost();
  }

  void set_cost() {
    const EdgeRules& rules = dense_.rules();
    double& cost = result_.path.cost;
    cost = 0;
    for (std::size_t i = 0; i < result_.path.positions.size(); ++i) {
      const JointVector& q = result_.path.positions[i];
      cost += posture_cost(input_, task_.waypoints[i], q);
      if (rules.vertex_cost) cost += rules.vertex_cost(i, q);
      if (i == 0) continue;
      const JointVector& before = result_.path.positions[i - 1];
      const JointVector step = (q - before).cwiseAbs();
      cost += rules.weight.dot(rules.squared ? step.cwiseAbs2().eval() : step);
      if (rules.edge_cost) cost += rules.edge_cost(i - 1, before, q);
    }
  }

  void add(const LadderStatistics& more) {
    LadderStatistics& sum = result_.path.statistics;
    sum.vertices = more.vertices;
    sum.edges = more.edges;
    sum.edges_evaluated += more.edges_evaluated;
    sum.usable_checks += more.usable_checks;
    sum.clear_checks += more.clear_checks;
  }

  const SamplingInput& input_;
  const Task& task_;
  const double epsilon_;
  const int threads_;
  const Monitor& monitor_;
  GraphSearch dense_;
  std::set<std::size_t> points_;
  std::map<std::size_t, Rung> rungs_;
  SparsePath result_;
};

}  // namespace

SparsePath plan_sparse(const SamplingInput& input, const Task& task, double epsilon, int threads,
                       const Monitor& monitor) {
  return SparsePlan(input, task, epsilon, threads, monitor).run();
}

}  // namespace wristwise
