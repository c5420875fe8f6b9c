#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace wristwise {

struct QuadraturePoint {
  double time;    ///< s
  double weight;  ///< s
};

inline constexpr std::ptrdiff_t kGaussPoints = 5;  ///< on each span

/// Five Gauss-Legendre points on each span: exact for polynomials up to degree 9, hence for the
/// square of any derivative of a quintic (Abramowitz & Stegun, table 25.4).
inline std::vector<QuadraturePoint> gauss_points(const std::vector<double>& breakpoints) {
  constexpr std::array<double, kGaussPoints> kNodes = {-0.906179845938664, -0.538469310105683, 0.0,
                                                       0.538469310105683, 0.906179845938664};
  constexpr std::array<double, kGaussPoints> kWeights = {0.236926885056189, 0.478628670499366,
                                                         0.568888888888889, 0.478628670499366,
                                                         0.236926885056189};
  std::vector<QuadraturePoint> points;
  points.reserve(kGaussPoints * breakpoints.size());
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double half = 0.5 * (breakpoints[i + 1] - breakpoints[i]);
    const double middle = 0.5 * (breakpoints[i + 1] + breakpoints[i]);
    for (std::size_t k = 0; k < kNodes.size(); ++k) {
      points.push_back({middle + half * kNodes[k], half * kWeights[k]});
    }
  }
  return points;
}

}  // namespace wristwise
