#pragma once

// The interface of a solver that IKFast generates, as its ikfast.h (version 61) declares it;
// written down apart from the library's own.

#include <cstddef>
#include <vector>

namespace ikfast {

template <typename T>
struct IkSingleDOFSolutionBase {
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
  virtual ~IkSolutionListBase() {}
  virtual std::size_t AddSolution(const std::vector<IkSingleDOFSolutionBase<T>>& vinfos,
                                  const std::vector<int>& vfree) = 0;
  virtual const IkSolutionBase<T>& GetSolution(std::size_t index) const = 0;
  virtual std::size_t GetNumSolutions() const = 0;
  virtual void Clear() = 0;
};

}  // namespace ikfast

#ifdef IKFAST_CLIBRARY
#define IKFAST_API extern "C"
#else
#define IKFAST_API
#endif
