#include "timing/banded_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wristwise {

namespace {

constexpr int kWidth = BandedRow::kWidth;
constexpr int kMostIterations = 60;
constexpr double kStepShare = 0.995;  // of the way to the nearest bound
constexpr double kGap = 1e-10;        // of a row's slack times its multiplier, gains scaled to 1

constexpr double kDualError = 1e-6;  // of A^T z = gains

using Vector = std::vector<double>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A symmetric positive definite matrix of half bandwidth kWidth - 1; element (i, i - k) at [i][k].
class BandedMatrix {
 public:
  explicit BandedMatrix(std::size_t size) : rows_(size) {}

  void add_square(const BandedRow& row, double factor) {
    for (int i = 0; i < kWidth; ++i) {
      for (int k = 0; k <= i; ++k) {
        rows_[at(row.first + i)][at(k)] += factor * row.weights[at(i)] * row.weights[at(i - k)];
      }
    }
  }

  /// In place: L of A = L L^T. A pivot that round-off has eaten up is made so large that its
  /// unknown stays where it is.
  void factorise() {
    constexpr double kRoundOff = 1e-14, kHuge = 1e60;
    for (int i = 0; i < size(); ++i) {
      const double diagonal = rows_[at(i)][0];
      for (int k = std::min(i, kWidth - 1); k >= 0; --k) {
        double sum = rows_[at(i)][at(k)];
        for (int m = k + 1; m < kWidth && m <= i; ++m) {
          sum -= rows_[at(i)][at(m)] * rows_[at(i - k)][at(m - k)];
        }
        if (k > 0) {
          rows_[at(i)][at(k)] = sum / rows_[at(i - k)][0];
        } else {
          rows_[at(i)][0] = sum > kRoundOff * diagonal ? std::sqrt(sum) : kHuge;
        }
      }
    }
  }

  /// x of L L^T x = right.
  Vector solve(Vector right) const {
    for (int i = 0; i < size(); ++i) {
      for (int k = 1; k < kWidth && k <= i; ++k)
        right[at(i)] -= rows_[at(i)][at(k)] * right[at(i - k)];
      right[at(i)] /= rows_[at(i)][0];
    }
    for (int i = size() - 1; i >= 0; --i) {
      for (int k = 1; k < kWidth && i + k < size(); ++k) {
        right[at(i)] -= rows_[at(i + k)][at(k)] * right[at(i + k)];
      }
      right[at(i)] /= rows_[at(i)][0];
    }
    return right;
  }

 private:
  int size() const { return static_cast<int>(rows_.size()); }
  std::vector<std::array<double, kWidth>> rows_;
};

double product(const BandedRow& row, const Vector& x) {
  double sum = 0;
  for (int k = 0; k < kWidth; ++k) sum += row.weights[at(k)] * x[at(row.first + k)];
  return sum;
}

/// The largest share, up to 1, of `step` that keeps `value` positive.
double room(const Vector& value, const Vector& step) {
  double share = 1;
  for (std::size_t r = 0; r < value.size(); ++r) {
    if (step[r] < 0) share = std::min(share, -kStepShare * value[r] / step[r]);
  }
  return share;
}

/// The rows A x + s = c, s >= 0, with multipliers z >= 0, A^T z = gains. x starts inside and stays
/// there, so that s is A x's own at all times.
class InteriorPoint {
 public:
  InteriorPoint(Vector gains, std::vector<BandedRow> rows, Vector start)
      : gains_(std::move(gains)), rows_(std::move(rows)), x_(std::move(start)) {
    scale();
    slack_.resize(rows_.size());
    update_slack();
    multiplier_.assign(rows_.size(), 1.0);
  }

  Vector run() {
    for (int i = 0; i < kMostIterations; ++i) {
      const double gap = mean_product();
      if ((gap < kGap && dual_error() < kDualError) || !step(gap)) break;
    }
    return std::move(x_);
  }

 private:
  struct Direction {
    Vector x, slack, multiplier;
  };

  void scale() {
    const double largest = *std::max_element(gains_.begin(), gains_.end());
    for (double& gain : gains_) gain /= largest;
    for (BandedRow& row : rows_) {
      double size = 0;
      for (const double w : row.weights) size = std::max(size, std::abs(w));
      for (double& w : row.weights) w /= size;
      row.limit /= size;
    }
  }

  void update_slack() {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      slack_[r] = rows_[r].limit - product(rows_[r], x_);
    }
  }

  double mean_product() const {
    double sum = 0;
    for (std::size_t r = 0; r < rows_.size(); ++r) sum += slack_[r] * multiplier_[r];
    return sum / static_cast<double>(rows_.size());
  }

  /// gains - A^T z
  Vector dual_residual() const {
    Vector residual = gains_;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (int k = 0; k < kWidth; ++k) {
        residual[at(rows_[r].first + k)] -= rows_[r].weights[at(k)] * multiplier_[r];
      }
    }
    return residual;
  }

  double dual_error() const {
    double largest = 0;
    for (const double value : dual_residual()) largest = std::max(largest, std::abs(value));
    return largest;
  }

  /// Newton's step towards s z = aim[r]: with D = z / s and r_c = aim - s z,
  /// A^T D A dx = (gains - A^T z) - A^T (r_c / s),  ds = -A dx,  dz = (r_c - z ds) / s.
  Direction direction(const BandedMatrix& normal, const Vector& dual, const Vector& aim) const {
    Vector right = dual;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const double share = aim[r] / slack_[r] - multiplier_[r];
      for (int k = 0; k < kWidth; ++k) {
        right[at(rows_[r].first + k)] -= rows_[r].weights[at(k)] * share;
      }
    }
    Direction d{normal.solve(std::move(right)), Vector(rows_.size()), Vector(rows_.size())};
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      d.slack[r] = -product(rows_[r], d.x);
      d.multiplier[r] = (aim[r] - multiplier_[r] * d.slack[r]) / slack_[r] - multiplier_[r];
    }
    return d;
  }

  bool step(double gap) {
    BandedMatrix normal(x_.size());
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      normal.add_square(rows_[r], multiplier_[r] / slack_[r]);
    }
    normal.factorise();
    const Vector dual = dual_residual();
    Vector aim(rows_.size(), 0.0);
    const Direction predictor = direction(normal, dual, aim);
    const double centring = std::pow(gap_after(predictor) / gap, 3);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      aim[r] = centring * gap - predictor.slack[r] * predictor.multiplier[r];
    }
    return move(direction(normal, dual, aim));
  }

  double gap_after(const Direction& d) const {
    const double primal = room(slack_, d.slack), dual = room(multiplier_, d.multiplier);
    double sum = 0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      sum += (slack_[r] + primal * d.slack[r]) * (multiplier_[r] + dual * d.multiplier[r]);
    }
    return sum / static_cast<double>(rows_.size());
  }

  /// False, and nothing moved, where round-off would carry x out of a row.
  bool move(const Direction& d) {
    const double primal = room(slack_, d.slack), dual = room(multiplier_, d.multiplier);
    const Vector before = x_;
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += primal * d.x[i];
    update_slack();
    if (!std::all_of(slack_.begin(), slack_.end(), [](double s) { return s > 0; })) {
      x_ = before;
      return false;
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) multiplier_[r] += dual * d.multiplier[r];
    return true;
  }

  Vector gains_;
  std::vector<BandedRow> rows_;
  Vector x_;
  Vector slack_, multiplier_;
};

}  // namespace

std::vector<double> maximise(const std::vector<double>& gains, const std::vector<BandedRow>& rows,
                             const std::vector<double>& start) {
  return InteriorPoint(gains, rows, start).run();
}

}  // namespace wristwise
