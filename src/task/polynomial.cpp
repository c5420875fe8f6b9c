#include "task/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

/// Points of [0, 1] in increasing order, ends included.
struct Breaks {
  std::array<double, 8> at{};
  int count = 0;
  void add(double u) { at[static_cast<std::size_t>(count++)] = u; }
};

double bisect(const Polynomial& p, double left, double right) {
  const bool rising = evaluate(p, left) < 0;
  for (int step = 0; step < 60 && left < right; ++step) {
    const double middle = 0.5 * (left + right);
    (evaluate(p, middle) < 0) == rising ? left = middle : right = middle;
  }
  return 0.5 * (left + right);
}

int degree(const Polynomial& p) {
  int d = 5;
  while (d > 0 && p[static_cast<std::size_t>(d)] == 0) --d;
  return d;
}

/// 0, 1 and the sign changes of p between them. Between two neighbouring breaks of its derivative p
/// is monotone, so that a change of sign there is its only one.
Breaks sign_changes(const Polynomial& p) {
  Breaks breaks;
  breaks.add(0);
  if (degree(p) > 0) {
    const Breaks turns = sign_changes(derivative(p));
    for (int i = 0; i + 1 < turns.count; ++i) {
      const double left = turns.at[static_cast<std::size_t>(i)];
      const double right = turns.at[static_cast<std::size_t>(i) + 1];
      if (evaluate(p, left) * evaluate(p, right) < 0) breaks.add(bisect(p, left, right));
    }
  }
  breaks.add(1);
  return breaks;
}

}  // namespace

double evaluate(const Polynomial& p, double u) {
  double value = 0;
  for (std::size_t k = p.size(); k-- > 0;) value = value * u + p[k];
  return value;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d{};
  for (std::size_t k = 1; k < p.size(); ++k) d[k - 1] = static_cast<double>(k) * p[k];
  return d;
}

std::pair<double, double> extremes_on_unit_interval(const Polynomial& p) {
  const Breaks candidates = sign_changes(derivative(p));
  double least = evaluate(p, 0), largest = least;
  for (int i = 0; i < candidates.count; ++i) {
    const double value = evaluate(p, candidates.at[static_cast<std::size_t>(i)]);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  return {least, largest};
}

}  // namespace wristwise
