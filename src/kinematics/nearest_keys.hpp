#pragma once

#include <Eigen/Core>
#include <vector>

namespace wristwise {

/// Finds the points nearest to another one (Euclidean) by a tree of halved boxes.
class NearestKeys {
 public:
  static constexpr int kMostCoordinates = 9;
  using Key = Eigen::Matrix<double, kMostCoordinates, 1>;  ///< unused coordinates are zero

  struct Neighbour {
    double square = 0;  ///< of the distance
    int index = 0;      ///< of the point
    bool operator<(const Neighbour& other) const {
      return square != other.square ? square < other.square : index < other.index;
    }
  };

  explicit NearestKeys(std::vector<Key> keys);

  /// The `count` nearest, the nearest first; fewer where there are fewer points.
  void find(const Key& key, std::size_t count, std::vector<Neighbour>& nearest) const;

 private:
  struct Node {
    int begin = 0, end = 0;   // of order_
    int low = -1, high = -1;  // children; -1: a leaf
    int coordinate = 0;
    double split = 0;
  };

  int build(int begin, int end);
  void search(int node, const Key& key, std::size_t count, std::vector<Neighbour>& heap) const;

  std::vector<Key> keys_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace wristwise
