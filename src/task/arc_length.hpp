#pragma once

#include <array>
#include <functional>

namespace wristwise {

/// The length of a smooth curve over its parameter u in [0, 1], and its inverse (F23).
class ArcLength {
 public:
  /// @param speed m, |dp/du|, positive
  explicit ArcLength(std::function<double(double)> speed);

  double total() const { return reached_.back(); }  ///< m
  /// The parameter at which the curve has come so far.
  double parameter_at(double length) const;

 private:
  static constexpr int kCells = 32;
  double between(double u0, double u1) const;

  std::function<double(double)> speed_;
  std::array<double, kCells + 1> reached_{};  ///< m, at u = i / kCells
};

}  // namespace wristwise
