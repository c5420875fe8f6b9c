#include "array_casters.hpp"

#include <cmath>

namespace wristwise::python {

namespace {

constexpr double kRigid = 1e-6;  // how far a rotation matrix given may be from an orthonormal one

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

[[noreturn]] void fail(const std::string& problem, const char* expected) {
  throw BadArray{problem, std::string("numbers of shape ") + expected};
}

py::array array_of(py::handle source, const char* expected) {
  py::array array = py::array::ensure(source);
  if (!array) {
    PyErr_Clear();
    fail("no array of numbers: " + py::repr(py::type::of(source)).cast<std::string>(), expected);
  }
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u' && kind != 'f')
    fail("an array of dtype " + py::str(array.dtype()).cast<std::string>(), expected);
  return array;
}

void expect_shape(const py::array& array, const Dimensions& shape, const char* expected) {
  bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t i = 0; fits && i < shape.size(); ++i)
    fits = shape[i] == kAnyLength || shape[i] == array.shape(static_cast<py::ssize_t>(i));
  if (!fits) fail("an array of shape " + shape_text(array), expected);
}

/// From 16 numbers, row by row.
Pose rigid_pose(const double* data) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(data);
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool bottom = matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), kRigid);
  const bool orthonormal = (rotation * rotation.transpose()).isIdentity(kRigid);
  if (!matrix.allFinite() || !bottom || !orthonormal || rotation.determinant() < 0)
    throw BadArray{"a matrix that is no rigid transformation",
                   "a pose: [[R, p], [0, 0, 0, 1]] with a right-handed rotation R"};
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

double* copy_pose(const Pose& pose, double* data) {
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>{data} = pose.matrix();
  return data + 16;
}

template <class Row>
py::object rows_to_numpy(const std::vector<Row>& rows, Eigen::Index width) {
  double* data = nullptr;
  py::array array = read_only_array({static_cast<py::ssize_t>(rows.size()), width}, data);
  for (const Row& row : rows)
    for (Eigen::Index i = 0; i < width; ++i) *data++ = row(i);
  return std::move(array);
}

}  // namespace

Numbers numbers_of_shape(py::handle source, const Dimensions& shape, const char* expected) {
  const py::array array = array_of(source, expected);
  expect_shape(array, shape, expected);
  Numbers numbers = Numbers::ensure(array);
  const double* data = numbers.data();
  for (py::ssize_t i = 0; i < numbers.size(); ++i)
    if (std::isnan(data[i])) fail("an array with NaN", expected);
  return numbers;
}

py::array_t<double> read_only_array(const Dimensions& shape, double*& data) {
  py::array_t<double> array(shape);
  data = array.mutable_data();
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

JointVector joint_vector(py::handle source) {
  const char* expected = "(joints,)";
  const Numbers array = numbers_of_shape(source, {kAnyLength}, expected);
  if (array.size() > kMaxJoints) fail("an array of shape " + shape_text(array), expected);
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.size());
}

std::vector<JointVector> joint_vectors(py::handle source) {
  const char* expected = "(N, joints)";
  const Numbers array = numbers_of_shape(source, {kAnyLength, kAnyLength}, expected);
  if (array.shape(1) > kMaxJoints) fail("an array of shape " + shape_text(array), expected);
  std::vector<JointVector> rows;
  rows.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    rows.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(array.data() + i * array.shape(1), array.shape(1)));
  return rows;
}

std::vector<double> values(py::handle source) {
  const Numbers array = numbers_of_shape(source, {kAnyLength}, "(N,)");
  return {array.data(), array.data() + array.size()};
}

Pose pose(py::handle source) {
  return rigid_pose(numbers_of_shape(source, {4, 4}, "(4, 4): a pose").data());
}

std::vector<Pose> poses(py::handle source) {
  const Numbers array = numbers_of_shape(source, {kAnyLength, 4, 4}, "(N, 4, 4): poses");
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    poses.push_back(rigid_pose(array.data() + 16 * i));
  return poses;
}

std::vector<Eigen::Vector3d> points(py::handle source) {
  const Numbers array = numbers_of_shape(source, {kAnyLength, 3}, "(N, 3): points");
  std::vector<Eigen::Vector3d> points;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) points.emplace_back(array.data() + 3 * i);
  return points;
}

std::vector<std::array<int, 3>> triangles(py::handle source) {
  const char* expected = "(N, 3): whole numbers, three corners each";
  const Numbers array = numbers_of_shape(source, {kAnyLength, 3}, expected);
  std::vector<std::array<int, 3>> triangles(static_cast<std::size_t>(array.shape(0)));
  const double* data = array.data();
  for (std::array<int, 3>& triangle : triangles) {
    for (int& corner : triangle) {
      const double index = *data++;
      if (index < 0 || index > 1e9 || index != std::floor(index))
        fail("a corner that is no index", expected);
      corner = static_cast<int>(index);
    }
  }
  return triangles;
}

py::object to_numpy(const JointVector& q) { return matrix_to_numpy(q); }

py::object to_numpy(const std::vector<JointVector>& rows) {
  return rows_to_numpy(rows, rows.empty() ? 0 : rows.front().size());
}

py::object to_numpy(const std::vector<double>& values) {
  double* data = nullptr;
  py::array array = read_only_array({static_cast<py::ssize_t>(values.size())}, data);
  std::copy(values.begin(), values.end(), data);
  return std::move(array);
}

py::object to_numpy(const Pose& pose) {
  double* data = nullptr;
  py::array array = read_only_array({4, 4}, data);
  copy_pose(pose, data);
  return std::move(array);
}

py::object to_numpy(const std::vector<Pose>& poses) {
  double* data = nullptr;
  py::array array = read_only_array({static_cast<py::ssize_t>(poses.size()), 4, 4}, data);
  for (const Pose& pose : poses) data = copy_pose(pose, data);
  return std::move(array);
}

py::object to_numpy(const std::vector<Eigen::Vector3d>& points) { return rows_to_numpy(points, 3); }

py::object to_numpy(const std::vector<std::array<int, 3>>& triangles) {
  py::array_t<int> array({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  int* data = array.mutable_data();
  for (const std::array<int, 3>& triangle : triangles)
    for (const int corner : triangle) *data++ = corner;
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return std::move(array);
}

}  // namespace wristwise::python
