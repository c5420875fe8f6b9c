#pragma once

#include <array>
#include <utility>

namespace wristwise {

/// A polynomial of degree up to 5: sum of coefficient[k] u^k.
using Polynomial = std::array<double, 6>;

double evaluate(const Polynomial& p, double u);
Polynomial derivative(const Polynomial& p);

/// The least and largest value of a polynomial over u in [0, 1].
std::pair<double, double> extremes_on_unit_interval(const Polynomial& p);

}  // namespace wristwise
