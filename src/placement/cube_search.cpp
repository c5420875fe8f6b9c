#include "placement/cube_search.hpp"

#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

namespace wristwise {

namespace {

constexpr double kFirstStep = 0.08;     // of the local search
constexpr double kSmallestStep = 1e-4;  // it ends here

/// Keeps the least value, whatever the optimiser returns, and what the function throws.
class Recorder {
 public:
  explicit Recorder(const CubeFunction& function) : function_(function) {}

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
  std::exception_ptr thrown_;
};

nlopt::opt optimiser_of(nlopt::algorithm algorithm, const CubePoint& start, int evaluations) {
  nlopt::opt optimiser(algorithm, static_cast<unsigned>(start.size()));
  optimiser.set_maxeval(evaluations);
  return optimiser;
}

}  // namespace

CubeMinimum search_globally(const CubeFunction& function, const CubePoint& start,
                            std::uint32_t seed, int evaluations) {
  nlopt::srand(seed);  // of this thread
  nlopt::opt optimiser = optimiser_of(nlopt::GN_CRS2_LM, start, evaluations);
  Recorder recorder(function);
  recorder.run(optimiser, start);
  return recorder.best;
}

CubeMinimum search_locally(const CubeFunction& function, const CubeMinimum& start,
                           int evaluations) {
  nlopt::opt optimiser = optimiser_of(nlopt::LN_SBPLX, start.point, evaluations);
  optimiser.set_initial_step(kFirstStep);
  optimiser.set_xtol_abs(kSmallestStep);
  Recorder recorder(function);
  recorder.best = start;
  recorder.run(optimiser, start.point);
  return recorder.best;
}

}  // namespace wristwise
