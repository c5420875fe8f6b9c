#pragma once

// The caller's own costs: Python callables as the std::functions of CostOptions.

#include <functional>

#include "array_casters.hpp"
#include "python_reference.hpp"
#include "wristwise/options.hpp"

namespace wristwise::python {

using VertexCost = std::function<double(std::size_t waypoint, const JointVector& q)>;
using EdgeCost =
    std::function<double(std::size_t interval, const JointVector& from, const JointVector& to)>;

/// Called from any thread; takes the interpreter lock.
/// Throws what the callable raises, and InvalidInput for what is no cost.
struct PythonCost {
  PythonReference callable;
  double operator()(std::size_t waypoint, const JointVector& q) const;
  double operator()(std::size_t interval, const JointVector& from, const JointVector& to) const;
};

/// f(time, q) -> (r, dr/dq) as a PostureResidual; as PythonCost.
struct PythonResidual {
  PythonReference callable;
  double operator()(double time, const JointVector& q, JointVector* gradient) const;
};

}  // namespace wristwise::python

namespace pybind11::detail {

template <class Function>
struct cost_caster {
  template <class Self>
  static bool load_into(Self& function, handle source) {
    if (source.is_none()) {
      function = nullptr;
      return true;
    }
    if (!PyCallable_Check(source.ptr())) return false;
    function = wristwise::python::PythonCost{
        wristwise::python::PythonReference(reinterpret_borrow<object>(source))};
    return true;
  }

  static handle object_of(const Function& function) {
    const auto* cost = function.template target<wristwise::python::PythonCost>();
    return cost != nullptr ? cost->callable.get().inc_ref() : none().release();
  }
};

template <>
struct type_caster<wristwise::python::VertexCost> : cost_caster<wristwise::python::VertexCost> {
  PYBIND11_TYPE_CASTER(wristwise::python::VertexCost,
                       const_name("Optional[Callable[[int, Array[joints]], float]]"));
  bool load(handle source, bool) { return load_into(value, source); }
  static handle cast(const wristwise::python::VertexCost& cost, return_value_policy, handle) {
    return object_of(cost);
  }
};

template <>
struct type_caster<wristwise::python::EdgeCost> : cost_caster<wristwise::python::EdgeCost> {
  PYBIND11_TYPE_CASTER(
      wristwise::python::EdgeCost,
      const_name("Optional[Callable[[int, Array[joints], Array[joints]], float]]"));
  bool load(handle source, bool) { return load_into(value, source); }
  static handle cast(const wristwise::python::EdgeCost& cost, return_value_policy, handle) {
    return object_of(cost);
  }
};

template <>
struct type_caster<wristwise::PostureResidual> {
  PYBIND11_TYPE_CASTER(wristwise::PostureResidual,
                       const_name("Callable[[float, Array[joints]], Tuple[float, ArrayLike]]"));
  bool load(handle source, bool) {
    if (!PyCallable_Check(source.ptr())) return false;
    value = wristwise::python::PythonResidual{
        wristwise::python::PythonReference(reinterpret_borrow<object>(source))};
    return true;
  }
  static handle cast(const wristwise::PostureResidual& residual, return_value_policy, handle) {
    const auto* own = residual.target<wristwise::python::PythonResidual>();
    return own != nullptr ? own->callable.get().inc_ref() : none().release();
  }
};

}  // namespace pybind11::detail
