#include "kinematics/nearest_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wristwise {
namespace {

using Key = NearestKeys::Key;

TEST(NearestKeys, FindsWhatALoopOverAllPointsFinds) {
  std::mt19937 random(1);
  std::normal_distribution<double> value;
  for (const int points : {1, 5, 100, 3000}) {
    for (const int coordinates : {1, 4, 9}) {
      std::vector<Key> keys(static_cast<std::size_t>(points), Key::Zero());
      const auto fill = [&](Key& key) {
        for (int k = 0; k < coordinates; ++k) key[k] = std::round(4 * value(random)) / 4;  // ties
      };
      for (Key& key : keys) fill(key);
      const NearestKeys tree(keys);
      for (int trial = 0; trial < 20; ++trial) {
        Key wanted = Key::Zero();
        fill(wanted);
        std::vector<NearestKeys::Neighbour> all, found;
        for (int i = 0; i < points; ++i)
          all.push_back({(keys[static_cast<std::size_t>(i)] - wanted).squaredNorm(), i});
        std::sort(all.begin(), all.end());
        tree.find(wanted, 20, found);
        ASSERT_EQ(found.size(), std::min<std::size_t>(20, all.size()));
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, all[i].index);
      }
    }
  }
}

TEST(NearestKeys, NoneAskedForNoneFound) {
  std::vector<NearestKeys::Neighbour> found(3);
  NearestKeys({Key::Zero()}).find(Key::Ones(), 0, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace wristwise
