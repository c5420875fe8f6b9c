#include <algorithm>

#include "kinematics/srdf.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

bool holds(const std::vector<Srdf::Names>& pairs, const std::string& a, const std::string& b) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const Srdf::Names& pair) {
    return pair == Srdf::Names(a, b) || pair == Srdf::Names(b, a);
  });
}

}  // namespace

std::vector<LinkNames> load_disabled_collisions(const std::filesystem::path& srdf,
                                                const Robot& robot) {
  const Srdf read = read_srdf(srdf);
  std::vector<LinkNames> pairs = read.disabled;
  for (const std::string& name : read.never_by_default) {
    for (const Link& other : robot.links()) {
      if (other.name != name && !holds(read.enabled, name, other.name)) {
        pairs.emplace_back(name, other.name);
      }
    }
  }
  return pairs;
}

}  // namespace wristwise
