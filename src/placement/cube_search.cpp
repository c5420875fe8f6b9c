#include "placement/cube_search.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

namespace wristwise {

namespace {

constexpr double kFirstStep = 0.08;     // of the local search
constexpr double kSmallestStep = 1e-4;  // it ends here

/// Keeps the least value, whatever the optimiser returns, and what the function throws. NLopt's
/// CRS2 heeds neither a stop nor its limit while it fills its population: both are kept here.
class Recorder {
 public:
  Recorder(const CubeFunction& function, int evaluations)
      : function_(function), left_(evaluations) {}

  CubeMinimum best{{}, std::numeric_limits<double>::infinity()};

  void run(nlopt::opt& optimiser, CubePoint point) {
    optimiser.set_lower_bounds(0);
    optimiser.set_upper_bounds(1);
    optimiser.set_min_objective(&Recorder::call, this);
    double value = 0;
    try {
      optimiser.optimize(point, value);
    } catch (const std::exception&) {  // the optimiser's own end is as good as another: best counts
      if (thrown_) std::rethrow_exception(thrown_);
    }
  }

 private:
  static double call(const CubePoint& point, CubePoint& /*gradient*/, void* self) {
    return static_cast<Recorder*>(self)->evaluate(point);
  }

  double evaluate(const CubePoint& point) {
    if (thrown_ || left_-- <= 0) throw nlopt::forced_stop();
    try {
      const double value = function_(point);
      if (value < best.value) best = {point, value};
      return value;
    } catch (...) {
      thrown_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  const CubeFunction& function_;
  int left_;
  std::exception_ptr thrown_;
};

/// NLopt's own choice, or half of what may be evaluated where that is less; at least a simplex.
unsigned population(std::size_t dimension, int evaluations) {
  const auto simplex = static_cast<unsigned>(dimension + 1);
  return std::clamp(static_cast<unsigned>(evaluations) / 2, simplex, 10 * simplex);
}

}  // namespace

CubeMinimum search_globally(const CubeFunction& function, const CubePoint& start,
                            std::uint32_t seed, int evaluations) {
  nlopt::srand(seed);  // of this thread
  nlopt::opt optimiser(nlopt::GN_CRS2_LM, static_cast<unsigned>(start.size()));
  optimiser.set_maxeval(evaluations);
  optimiser.set_population(population(start.size(), evaluations));
  Recorder recorder(function, evaluations);
  recorder.run(optimiser, start);
  return recorder.best;
}

CubeMinimum search_locally(const CubeFunction& function, const CubeMinimum& start,
                           int evaluations) {
  nlopt::opt optimiser(nlopt::LN_SBPLX, static_cast<unsigned>(start.point.size()));
  optimiser.set_maxeval(evaluations);
  optimiser.set_initial_step(kFirstStep);
  optimiser.set_xtol_abs(kSmallestStep);
  Recorder recorder(function, evaluations);
  recorder.best = start;
  recorder.run(optimiser, start.point);
  return recorder.best;
}

}  // namespace wristwise
