// A solver with IKFast's interface for the flange of the KUKA KR 5 arc, from its published closed
// form. Compiled as C++ and as C library, and in variants that are wrong.

#include "ikfast/ikfast_interface.hpp"
#include "kuka_kr5_arc.hpp"
#include "ortho_parallel.hpp"

#ifndef JOINTS
#define JOINTS 6
#endif
#ifndef SHORTER  // m, of the column: a robot that is another one
#define SHORTER 0
#endif

IKFAST_API int GetNumFreeParameters() { return 0; }
IKFAST_API int* GetFreeParameters() { return nullptr; }
IKFAST_API int GetNumJoints() { return JOINTS; }
IKFAST_API int GetIkRealSize() { return sizeof(double); }
IKFAST_API int GetIkType() { return 0x67000001; }

IKFAST_API bool ComputeIk(const double* eetrans, const double* eerot, const double*,
                          ikfast::IkSolutionListBase<double>& solutions) {
  solutions.Clear();
  wristwise::Pose flange = wristwise::Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    flange.translation()[row] = eetrans[row];
    for (int column = 0; column < 3; ++column)
      flange.linear()(row, column) = eerot[3 * row + column];
  }
  flange.translation().z() += SHORTER;
  for (const wristwise::JointVector& q : wristwise::test::ortho_parallel(flange)) {
    std::vector<ikfast::IkSingleDOFSolutionBase<double>> joints(6);
    for (std::size_t j = 0; j < 6; ++j)
      joints[j].foffset = std::remainder(q[static_cast<Eigen::Index>(j)], 2 * std::acos(-1.0));
    solutions.AddSolution(joints, {});
  }
  return solutions.GetNumSolutions() > 0;
}

#ifndef WITHOUT_FK
IKFAST_API void ComputeFk(const double* joints, double* eetrans, double* eerot) {
  const Eigen::VectorXd q = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(joints);
  const Eigen::Matrix4d flange = wristwise::test::kr5::tool0(q);
  for (int row = 0; row < 3; ++row) {
    eetrans[row] = flange(row, 3);
    for (int column = 0; column < 3; ++column) eerot[3 * row + column] = flange(row, column);
  }
}
#endif
