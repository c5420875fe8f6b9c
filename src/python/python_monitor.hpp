#pragma once

// How a Python caller watches and stops a run.

#include <pybind11/pybind11.h>

#include "wristwise/verification.hpp"

namespace wristwise::python {

namespace py = pybind11;

struct ProgressCallback {
  py::object callable = py::none();
};
struct LogCallback {
  py::object callable = py::none();
};
/// A threading.Event, or whatever else has is_set().
struct CancelEvent {
  py::object event = py::none();
};

struct PythonMonitor {
  ProgressCallback progress;
  LogCallback log;
  CancelEvent cancel;
};

struct PythonPlanOptions {
  int threads = 0;
  PythonMonitor monitor;
  VerificationOptions verification;
};

}  // namespace wristwise::python

namespace pybind11::detail {

template <>
struct type_caster<wristwise::python::ProgressCallback> {
  PYBIND11_TYPE_CASTER(wristwise::python::ProgressCallback,
                       const_name("Optional[Callable[[str, float], object]]"));
  bool load(handle source, bool) {
    value.callable = reinterpret_borrow<object>(source);
    return source.is_none() || PyCallable_Check(source.ptr());
  }
  static handle cast(const wristwise::python::ProgressCallback& held, return_value_policy, handle) {
    return held.callable.inc_ref();
  }
};

template <>
struct type_caster<wristwise::python::LogCallback> {
  PYBIND11_TYPE_CASTER(wristwise::python::LogCallback,
                       const_name("Optional[Callable[[LogLevel, str], object]]"));
  bool load(handle source, bool) {
    value.callable = reinterpret_borrow<object>(source);
    return source.is_none() || PyCallable_Check(source.ptr());
  }
  static handle cast(const wristwise::python::LogCallback& held, return_value_policy, handle) {
    return held.callable.inc_ref();
  }
};

template <>
struct type_caster<wristwise::python::CancelEvent> {
  PYBIND11_TYPE_CASTER(wristwise::python::CancelEvent, const_name("Optional[threading.Event]"));
  bool load(handle source, bool) {
    value.event = reinterpret_borrow<object>(source);
    return source.is_none() || hasattr(source, "is_set");
  }
  static handle cast(const wristwise::python::CancelEvent& held, return_value_policy, handle) {
    return held.event.inc_ref();
  }
};

}  // namespace pybind11::detail
