#include "kinematics/ikfast_solutions.hpp"

#include <stdexcept>

namespace wristwise {

std::size_t IkFastSolutions::AddSolution(
    const std::vector<ikfast::IkSingleDOFSolutionBase<double>>& joints,
    const std::vector<int>& /*free*/) {
  JointVector posture(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    posture[static_cast<Eigen::Index>(j)] = joints[j].foffset;
  postures_.push_back(posture);
  return postures_.size() - 1;
}

/// Generated solvers only add.
const ikfast::IkSolutionBase<double>& IkFastSolutions::GetSolution(std::size_t /*index*/) const {
  throw std::logic_error("IKFast solutions are not handed back");
}

}  // namespace wristwise
