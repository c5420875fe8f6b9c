#pragma once

// A symmetric positive definite matrix of 6 x 6 blocks, five of them below the diagonal: the shape
// of stage 2's normal equations for six joints, as a quintic's control point meets its five
// neighbours. One factorisation and solution of it is the least that an iteration can cost.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace wristwise::benchmarks {

class BlockBanded {
 public:
  static constexpr int kBelow = 5;
  using Block = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::Matrix<double, 6, 1>;

  explicit BlockBanded(int size)
      : size_(size), blocks_(static_cast<std::size_t>(size) * (kBelow + 1), Block::Zero()) {}

  int size() const { return size_; }
  /// Of the lower half. @pre 0 <= row - column <= kBelow
  Block& at(int row, int column) { return blocks_[index(row, column)]; }
  const Block& at(int row, int column) const { return blocks_[index(row, column)]; }

  /// Becomes L with L L^T = the matrix.
  void factorise() {
    for (int i = 0; i < size_; ++i) {
      const int first = std::max(0, i - kBelow);
      for (int j = first; j <= i; ++j) {
        Block& block = at(i, j);
        for (int k = first; k < j; ++k) block.noalias() -= at(i, k) * at(j, k).transpose();
        if (j < i) {
          at(j, j).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(
              block);
        } else {
          block = Block(block.llt().matrixL());
        }
      }
    }
  }

  /// Solves L L^T x = b in place. @pre factorised
  void solve(std::vector<Vector>& b) const {
    const auto entry = [&b](int i) -> Vector& { return b[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < size_; ++i) {
      for (int k = std::max(0, i - kBelow); k < i; ++k) entry(i) -= at(i, k) * entry(k);
      at(i, i).triangularView<Eigen::Lower>().solveInPlace(entry(i));
    }
    for (int i = size_ - 1; i >= 0; --i) {
      for (int k = i + 1; k <= std::min(size_ - 1, i + kBelow); ++k) {
        entry(i) -= at(k, i).transpose() * entry(k);
      }
      at(i, i).triangularView<Eigen::Lower>().transpose().solveInPlace(entry(i));
    }
  }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row * (kBelow + 1) + row - column);
  }

  int size_;
  std::vector<Block> blocks_;
};

}  // namespace wristwise::benchmarks
