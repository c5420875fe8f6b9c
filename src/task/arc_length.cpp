#include "task/arc_length.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

constexpr int kMostSteps = 20;
constexpr double kRoundOff = 1e-15;  // of the length

// Gauss-Legendre, ten points (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 5> kNodes = {0.148874338981631, 0.433395394129247, 0.679409568299024,
                                          0.865063366688985, 0.973906528517172};
constexpr std::array<double, 5> kWeights = {0.295524224714753, 0.269266719309996, 0.219086362515982,
                                            0.149451349150581, 0.066671344308688};

}  // namespace

ArcLength::ArcLength(std::function<double(double)> speed) : speed_(std::move(speed)) {
  for (std::size_t i = 0; i < kCells; ++i)
    reached_[i + 1] =
        reached_[i] + between(static_cast<double>(i) / kCells, static_cast<double>(i + 1) / kCells);
}

double ArcLength::between(double u0, double u1) const {
  const double half = 0.5 * (u1 - u0), middle = 0.5 * (u1 + u0);
  double sum = 0;
  for (std::size_t k = 0; k < kNodes.size(); ++k)
    sum += kWeights[k] * (speed_(middle - half * kNodes[k]) + speed_(middle + half * kNodes[k]));
  return half * sum;
}

// Newton's method inside the cell where the length is reached.
double ArcLength::parameter_at(double length) const {
  const auto next = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, length);
  const auto cell = next - reached_.begin() - 1;
  const double left = *std::prev(next);
  const double u0 = static_cast<double>(cell) / kCells, u1 = u0 + 1.0 / kCells;
  double u = u0 + std::clamp((length - left) / (*next - left), 0.0, 1.0) / kCells;
  for (int step = 0; step < kMostSteps; ++step) {
    const double missing = length - left - between(u0, u);
    if (std::abs(missing) <= kRoundOff * total()) break;
    u = std::clamp(u + missing / speed_(u), u0, u1);
  }
  return u;
}

}  // namespace wristwise
