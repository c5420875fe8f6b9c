#pragma once

// How numbers cross the border: Eigen on this side, numpy on the other. Arrays are copied both
// ways. What Python receives is read-only, so that a change that would be lost is an error. What
// Python gives may be any array-like of real numbers, of the one shape that is expected.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <vector>

#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"

namespace wristwise::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Dimensions = std::vector<py::ssize_t>;

/// An array that is not what is expected; Python sees InvalidInput. Whoever knows the name of the
/// attribute puts it in front.
struct BadArray {
  std::string problem;   ///< "an array of shape (3,)"
  std::string expected;  ///< "numbers of shape (joints,)"
};

inline constexpr py::ssize_t kAnyLength = -1;

/// @param shape one entry for each dimension, kAnyLength where that is free
/// @param expected the shape in words, for the message
/// @throws BadArray for another shape, what is no real number, and NaN
Numbers numbers_of_shape(py::handle source, const Dimensions& shape, const char* expected);

/// A new array that Python cannot write to, filled by the caller through `data`.
py::array_t<double> read_only_array(const Dimensions& shape, double*& data);

JointVector joint_vector(py::handle source);
std::vector<JointVector> joint_vectors(py::handle source);
std::vector<double> values(py::handle source);
Pose pose(py::handle source);
std::vector<Pose> poses(py::handle source);
std::vector<Eigen::Vector3d> points(py::handle source);
std::vector<std::array<int, 3>> triangles(py::handle source);

py::object to_numpy(const JointVector& q);
py::object to_numpy(const std::vector<JointVector>& rows);
py::object to_numpy(const std::vector<double>& values);
py::object to_numpy(const Pose& pose);
py::object to_numpy(const std::vector<Pose>& poses);
py::object to_numpy(const std::vector<Eigen::Vector3d>& points);
py::object to_numpy(const std::vector<std::array<int, 3>>& triangles);

/// A matrix of fixed rows; of fixed columns too, or any number of them.
template <int rows, int columns, int options, int max_rows, int max_columns>
py::object matrix_to_numpy(
    const Eigen::Matrix<double, rows, columns, options, max_rows, max_columns>& matrix) {
  double* data = nullptr;
  py::array array = columns == 1 ? read_only_array({matrix.rows()}, data)
                                 : read_only_array({matrix.rows(), matrix.cols()}, data);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) *data++ = matrix(i, j);
  return std::move(array);
}

template <int rows, int columns>
Eigen::Matrix<double, rows, columns> fixed_matrix(py::handle source, const char* expected) {
  const Numbers array = numbers_of_shape(
      source, columns == 1 ? Dimensions{rows} : Dimensions{rows, columns}, expected);
  Eigen::Matrix<double, rows, columns> matrix;
  const double* data = array.data();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) matrix(i, j) = *data++;
  return matrix;
}

}  // namespace wristwise::python

// The type texts are those of the docstrings; the stub generator knows `Array[...]`.
#define WRISTWISE_ARRAY_CASTER(Type, text, from_python, to_python)     \
  template <>                                                          \
  struct type_caster<Type> {                                           \
    PYBIND11_TYPE_CASTER(Type, const_name(text));                      \
    bool load(handle source, bool) {                                   \
      value = from_python;                                             \
      return true;                                                     \
    }                                                                  \
    static handle cast(const Type& cpp, return_value_policy, handle) { \
      return wristwise::python::to_python(cpp).release();              \
    }                                                                  \
  }

namespace pybind11::detail {

WRISTWISE_ARRAY_CASTER(wristwise::JointVector, "Array[joints]",
                       wristwise::python::joint_vector(source), to_numpy);
WRISTWISE_ARRAY_CASTER(std::vector<wristwise::JointVector>, "Array[N, joints]",
                       wristwise::python::joint_vectors(source), to_numpy);
WRISTWISE_ARRAY_CASTER(std::vector<double>, "Array[N]", wristwise::python::values(source),
                       to_numpy);
WRISTWISE_ARRAY_CASTER(wristwise::Pose, "Array[4, 4]", wristwise::python::pose(source), to_numpy);
WRISTWISE_ARRAY_CASTER(std::vector<wristwise::Pose>, "Array[N, 4, 4]",
                       wristwise::python::poses(source), to_numpy);
WRISTWISE_ARRAY_CASTER(std::vector<Eigen::Vector3d>, "Array[N, 3]",
                       wristwise::python::points(source), to_numpy);
using Triangles = std::vector<std::array<int, 3>>;
WRISTWISE_ARRAY_CASTER(Triangles, "IntArray[N, 3]", wristwise::python::triangles(source), to_numpy);
WRISTWISE_ARRAY_CASTER(wristwise::Vector6, "Array[6]",
                       (wristwise::python::fixed_matrix<6, 1>(source, "(6,): x, y, z, rx, ry, rz")),
                       matrix_to_numpy);
WRISTWISE_ARRAY_CASTER(Eigen::Vector3d, "Array[3]",
                       (wristwise::python::fixed_matrix<3, 1>(source, "(3,): x, y, z")),
                       matrix_to_numpy);
WRISTWISE_ARRAY_CASTER(Eigen::Matrix3d, "Array[3, 3]",
                       (wristwise::python::fixed_matrix<3, 3>(source, "(3, 3): a rotation")),
                       matrix_to_numpy);

/// Only towards Python.
template <>
struct type_caster<wristwise::Jacobian> {
  static constexpr auto name = const_name("Array[6, joints]");
  static handle cast(const wristwise::Jacobian& matrix, return_value_policy, handle) {
    return wristwise::python::matrix_to_numpy(matrix).release();
  }
};

}  // namespace pybind11::detail

#undef WRISTWISE_ARRAY_CASTER
