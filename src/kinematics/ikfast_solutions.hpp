#pragma once

#include <vector>

#include "wristwise/joints.hpp"

// The classes through which a generated solver hands its solutions over, with the members and the
// order of virtual functions of ikfast.h (versions 61 and later).
namespace ikfast {

/// A joint value: fmul * free[freeind] + foffset; without freeind foffset alone.
template <typename T>
class IkSingleDOFSolutionBase {
 public:
  T fmul = 0, foffset = 0;
  signed char freeind = -1;
  unsigned char jointtype = 0;
  unsigned char maxsolutions = 1;
  unsigned char indices[5] = {255, 255, 255, 255, 255};
};

template <typename T>
class IkSolutionBase;

template <typename T>
class IkSolutionListBase {
 public:
  virtual ~IkSolutionListBase() = default;
  virtual std::size_t AddSolution(const std::vector<IkSingleDOFSolutionBase<T>>& joints,
                                  const std::vector<int>& free) = 0;
  virtual const IkSolutionBase<T>& GetSolution(std::size_t index) const = 0;
  virtual std::size_t GetNumSolutions() const = 0;
  virtual void Clear() = 0;
};

}  // namespace ikfast

namespace wristwise {

/// Takes solutions down as postures, joints that a solution leaves free at zero.
class IkFastSolutions final : public ikfast::IkSolutionListBase<double> {
 public:
  std::size_t AddSolution(const std::vector<ikfast::IkSingleDOFSolutionBase<double>>& joints,
                          const std::vector<int>& free) override;
  const ikfast::IkSolutionBase<double>& GetSolution(std::size_t index) const override;
  std::size_t GetNumSolutions() const override { return postures_.size(); }
  void Clear() override { postures_.clear(); }

  const std::vector<JointVector>& postures() const { return postures_; }

 private:
  std::vector<JointVector> postures_;
};

}  // namespace wristwise
