#include "io/peaks.hpp"

namespace wristwise {

std::optional<JointVector> peak_derivative(const JointPath& path, int order) {
  if (path.size() <= static_cast<std::size_t>(order)) return std::nullopt;
  JointVector peak = JointVector::Zero(path.positions.front().size());
  for (const JointVector& value : divided_differences(path, order))
    peak = peak.cwiseMax(value.cwiseAbs());
  return peak;
}

}  // namespace wristwise
