#include "graph/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define WRISTWISE_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define WRISTWISE_VECTOR_CLONES
#endif

namespace wristwise {

namespace {

constexpr std::size_t kTile = 512;  // vertices whose totals stay in the first-level cache
constexpr std::size_t kLanes = 8;
constexpr double kUnreachable = std::numeric_limits<double>::infinity();

}  // namespace

// Products and sums are kept apart (the library is built with -ffp-contract=off), so that every
// clone rounds alike.
WRISTWISE_VECTOR_CLONES
double relax_towards(const RungColumns& from, const double* distance, const double* target,
                     const double* weight, const double* max_step, double* total) {
  std::array<double, kLanes> least{};
  least.fill(kUnreachable);
  for (std::size_t begin = 0; begin < from.count; begin += kTile) {
    const std::size_t size = std::min(kTile, from.count - begin);
    double* const sum = total + begin;
    std::copy_n(distance + begin, size, sum);
    for (int j = 0; j < from.joints; ++j) {
      const double* const q = from.positions + static_cast<std::size_t>(j) * from.count + begin;
      const double goal = target[j], w = weight[j], limit = max_step[j];
      if (limit == kUnreachable) {
        for (std::size_t u = 0; u < size; ++u) sum[u] += w * std::fabs(q[u] - goal);
      } else {
        for (std::size_t u = 0; u < size; ++u) {
          const double step = std::fabs(q[u] - goal);
          sum[u] = step > limit ? kUnreachable : sum[u] + w * step;
        }
      }
    }
    std::size_t u = 0;
    for (; u + kLanes <= size; u += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        least[lane] = sum[u + lane] < least[lane] ? sum[u + lane] : least[lane];
      }
    }
    for (; u < size; ++u) least[0] = std::min(least[0], sum[u]);
  }
  return *std::min_element(least.begin(), least.end());
}

}  // namespace wristwise
