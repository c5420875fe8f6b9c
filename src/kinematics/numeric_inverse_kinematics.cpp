#include "wristwise/numeric_inverse_kinematics.hpp"

#include <fmt/format.h>

#include <utility>

#include "kinematics/numeric_search.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

NumericInverseKinematics::NumericInverseKinematics(std::shared_ptr<const Robot> robot,
                                                   const NumericIkOptions& options) {
  if (!robot) throw InvalidInput("numeric inverse kinematics", "no robot");
  if (options.postures < 1 || options.neighbours < 1 || options.vain_starts < 1 ||
      options.most_of_continuum < 1 || options.box_poses < 1 || !(options.separation > 0)) {
    throw InvalidInput("numeric inverse kinematics", "an option is not positive",
                       "positive numbers of starts and a positive separation");
  }
  search_ = std::make_unique<const NumericSearch>(std::move(robot), options);
}

NumericInverseKinematics::~NumericInverseKinematics() = default;

void NumericInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  search_->solve(tcp, branches);
}

bool NumericInverseKinematics::meets_every_pose() const { return search_->rank() == 6; }

void NumericInverseKinematics::solve_near(const ToleranceSample& sample,
                                          std::vector<JointVector>& branches) const {
  InverseKinematics::solve_near(sample, branches);
  if (!branches.empty() || meets_every_pose() || sample.lower == sample.upper) return;
  search_->solve_in_cell({sample.box, sample.path_frame, sample.lower, sample.upper}, branches);
}

void NumericInverseKinematics::solve_in_box(const ToleranceBox& box, const Pose& path_frame,
                                            std::vector<JointVector>& postures) const {
  box.validate("tolerance");
  search_->solve_all_over(DeviationCell::of(box, path_frame), postures);
}

std::string NumericInverseKinematics::description() const {
  std::string text =
      fmt::format("numeric, from many starts: {} joints move the TCP in {} directions",
                  search_->robot().joint_count(), search_->rank());
  if (search_->is_redundant()) {
    text += fmt::format("; of the continuum of solutions up to {} for a pose, {:g} rad or m apart",
                        search_->options().most_of_continuum, search_->options().separation);
  }
  return text;
}

}  // namespace wristwise
