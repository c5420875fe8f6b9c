#pragma once

#include <pybind11/pybind11.h>

#include <memory>

namespace wristwise::python {

namespace py = pybind11;

/// A Python object that C++ may copy and drop on any thread, without holding the interpreter lock.
class PythonReference {
 public:
  explicit PythonReference(py::object object)
      : object_(new py::object(std::move(object)), [](py::object* held) {
          const py::gil_scoped_acquire lock;
          delete held;
        }) {}

  /// To be used under the interpreter lock.
  const py::object& get() const { return *object_; }

 private:
  std::shared_ptr<py::object> object_;
};

}  // namespace wristwise::python
