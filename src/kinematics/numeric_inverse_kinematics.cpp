#include "wristwise/numeric_inverse_kinematics.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/pose_descent.hpp"
#include "kinematics/posture_table.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPoseTolerance = 1e-10;  // m and rad
constexpr double kConsistent = 1e-9;      // m and rad, of a pose that few joints can reach
constexpr double kSameSolution = 1e-5;    // rad or m: at a double root 1e-10 in the pose
constexpr double kSingular = 1e-6;        // of the largest singular value
constexpr double kSameStart = 0.4;        // rad or m
constexpr double kLeadsThere = 0.6;       // rad or m, of a start to a known solution
constexpr double kUnlimitedTravel = 10;   // m either way, of a slide without limits
constexpr int kRankSamples = 8;

double joint_distance(const Joint& joint, double a, double b) {
  return std::abs(joint.type == JointType::prismatic ? a - b : wrap_angle(a - b));
}

struct Ranges {
  JointVector lower, upper;  ///< where postures are looked for
};

bool turns_round(const Joint& joint) {
  return joint.type != JointType::prismatic && joint.upper - joint.lower >= 2 * kPi;
}

Ranges search_ranges(const Robot& robot, bool inside_limits) {
  Ranges ranges{robot.lower_limits(), robot.upper_limits()};
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const bool slides = joint.type == JointType::prismatic;
    const double most = slides ? kUnlimitedTravel : kPi;
    if (slides ? !std::isfinite(joint.lower) : !inside_limits || turns_round(joint))
      ranges.lower[j] = -most;
    if (slides ? !std::isfinite(joint.upper) : !inside_limits || turns_round(joint))
      ranges.upper[j] = most;
  }
  return ranges;
}

/// Singular values of the TCP's Jacobian above this share of the largest.
int rank(const Robot& robot, const JointVector& q, double length) {
  ChainPose chain;
  forward_kinematics(robot, q, chain);
  Jacobian jacobian = geometric_jacobian(robot, chain);
  jacobian.topRows<3>() /= length;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(jacobian)};
  svd.setThreshold(kSingular);
  return static_cast<int>(svd.rank());
}

}  // namespace

class NumericInverseKinematics::Search {
 public:
  Search(std::shared_ptr<const Robot> robot, const NumericIkOptions& options)
      : robot_(std::move(robot)), options_(options) {
    const int joints = robot_->joint_count();
    for (int i = 0; i < kRankSamples; ++i)
      rank_ =
          std::max(rank_, rank(*robot_, JointVector::LinSpaced(joints, 0.3 + i, 1.1 + 2 * i), 1));
    const Ranges ranges = search_ranges(*robot_, is_redundant());
    table_ =
        std::make_unique<const PostureTable>(robot_, ranges.lower, ranges.upper, options_.postures);
    rules_ = {table_->length(), rank_ < 6 ? kConsistent : kPoseTolerance, ranges.lower,
              ranges.upper};
    for (int j = 0; j < joints; ++j) {
      const Joint& joint = robot_->joints()[static_cast<std::size_t>(j)];
      if (joint.type != JointType::prismatic && (!is_redundant() || turns_round(joint))) {
        rules_.lower[j] = -kInfinity;
        rules_.upper[j] = kInfinity;
      }
    }
  }

  void solve(const Pose& tcp, std::vector<JointVector>& solutions) const {
    solutions.clear();
    if (!tcp.matrix().allFinite()) return;
    PostureTable::Found found;
    table_->find(tcp, options_.neighbours, found);
    std::vector<int> tried, waiting;
    int vain = 0;
    const auto wanted = [&] {
      return vain < options_.vain_starts && !(is_redundant() && is_enough(solutions.size()));
    };
    const auto start = [&](int index) {
      tried.push_back(index);
      JointVector q = table_->towards(tcp, found, index);
      const bool is_new = descend_to_pose(*robot_, tcp, rules_, q) && add(q, solutions);
      vain = is_new ? 0 : vain + 1;
    };
    for (const NearestKeys::Neighbour& neighbour : found.postures) {
      if (!wanted()) return;
      const JointVector& posture = table_->posture(neighbour.index);
      if (is_tried(tried, posture)) continue;
      if (is_near_one(solutions, posture, kLeadsThere)) {
        waiting.push_back(neighbour.index);
      } else {
        start(neighbour.index);
      }
    }
    for (const int index : waiting) {
      if (!wanted()) return;
      if (!is_tried(tried, table_->posture(index))) start(index);
    }
  }

  std::string describe() const {
    std::string text =
        fmt::format("numeric, from many starts: {} joints move the TCP in {} directions",
                    robot_->joint_count(), rank_);
    if (is_redundant()) {
      text +=
          fmt::format("; of the continuum of solutions up to {} for a pose, {:g} rad or m apart",
                      options_.most_of_continuum, options_.separation);
    }
    return text;
  }

 private:
  bool is_redundant() const { return robot_->joint_count() > rank_; }

  bool is_enough(std::size_t solutions) const {
    return solutions >= static_cast<std::size_t>(options_.most_of_continuum);
  }

  bool is_tried(const std::vector<int>& tried, const JointVector& posture) const {
    return std::any_of(tried.begin(), tried.end(), [&](int other) {
      return inner_distance(table_->posture(other), posture) < kSameStart;
    });
  }

  bool is_near_one(const std::vector<JointVector>& solutions, const JointVector& posture,
                   double radius) const {
    return std::any_of(solutions.begin(), solutions.end(), [&](const JointVector& solution) {
      return inner_distance(solution, posture) < radius;
    });
  }

  /// Of the joints that a posture of the table fixes.
  double inner_distance(const JointVector& a, const JointVector& b) const {
    return a.size() > 2 ? distance(a, b, 1, a.size() - 1) : kInfinity;
  }

  double distance(const JointVector& a, const JointVector& b, Eigen::Index from,
                  Eigen::Index to) const {
    double largest = 0;
    for (Eigen::Index j = from; j < to; ++j) {
      const Joint& joint = robot_->joints()[static_cast<std::size_t>(j)];
      largest = std::max(largest, joint_distance(joint, a[j], b[j]));
    }
    return largest;
  }

  /// @return whether it is new
  bool add(JointVector q, std::vector<JointVector>& solutions) const {
    for (int j = 0; j < robot_->joint_count(); ++j) {
      if (robot_->joints()[static_cast<std::size_t>(j)].type != JointType::prismatic)
        q[j] = wrap_angle(q[j]);
    }
    double nearest = kInfinity;
    for (const JointVector& other : solutions)
      nearest = std::min(nearest, distance(q, other, 0, q.size()));
    if (nearest < kSameSolution) return false;
    const bool in_question = nearest < options_.separation;
    if (in_question && (is_redundant() || rank(*robot_, q, rules_.length) < rank_)) return false;
    solutions.push_back(std::move(q));
    return true;
  }

  std::shared_ptr<const Robot> robot_;
  NumericIkOptions options_;
  int rank_ = 0;
  DescentRules rules_;
  std::unique_ptr<const PostureTable> table_;
};

NumericInverseKinematics::NumericInverseKinematics(std::shared_ptr<const Robot> robot,
                                                   const NumericIkOptions& options) {
  if (!robot) throw InvalidInput("numeric inverse kinematics", "no robot");
  if (options.postures < 1 || options.neighbours < 1 || options.vain_starts < 1 ||
      options.most_of_continuum < 1 || !(options.separation > 0)) {
    throw InvalidInput("numeric inverse kinematics", "an option is not positive",
                       "positive numbers of starts and a positive separation");
  }
  search_ = std::make_unique<const Search>(std::move(robot), options);
}

NumericInverseKinematics::~NumericInverseKinematics() = default;

void NumericInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  search_->solve(tcp, branches);
}

std::string NumericInverseKinematics::description() const { return search_->describe(); }

}  // namespace wristwise
