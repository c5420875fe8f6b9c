#include "graph/known_checks.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

KnownChecks::KnownChecks(const std::vector<Rung>& rungs, const EdgeRules& rules)
    : rungs_(rungs), rules_(rules), usable_(rungs.size()), moves_(rungs.size()) {}

bool KnownChecks::is_usable(int worker, std::size_t rung, Eigen::Index index) {
  if (!rules_.is_usable) return true;
  if (usable_[rung].empty()) {
    usable_[rung].assign(static_cast<std::size_t>(rungs_[rung].size()), kUnknown);
  }
  signed char& known = usable_[rung][static_cast<std::size_t>(index)];
  if (known == kUnknown) {
    known = rules_.is_usable(worker, rung, rungs_[rung].vertex(index)) ? kUsable : kBlocked;
  }
  return known == kUsable;
}

KnownChecks::Move KnownChecks::move(std::size_t interval, Eigen::Index from, Eigen::Index to,
                                    const JointVector& q_from, const JointVector& q_to) const {
  Move move{from, to, {}};
  for (Eigen::Index j = 0; j < rules_.period.size(); ++j) {
    if (std::isinf(rules_.period[j])) continue;
    const double without =
        rungs_[interval + 1].positions(to, j) - rungs_[interval].positions(from, j);
    move.turns[static_cast<std::size_t>(j)] =
        static_cast<std::int16_t>(std::lround((q_to[j] - q_from[j] - without) / rules_.period[j]));
  }
  return move;
}

std::size_t KnownChecks::usable_checks() const {
  std::size_t sum = 0;
  for (const auto& rung : usable_) {
    sum += rung.size() - static_cast<std::size_t>(std::count(rung.begin(), rung.end(), kUnknown));
  }
  return sum;
}

std::size_t KnownChecks::blocked() const {
  std::size_t sum = 0;
  for (const auto& rung : usable_) {
    sum += static_cast<std::size_t>(std::count(rung.begin(), rung.end(), kBlocked));
  }
  return sum;
}

std::size_t KnownChecks::clear_checks() const {
  std::size_t sum = 0;
  for (const Moves& moves : moves_) sum += moves.size();
  return sum;
}

bool KnownChecks::any_move_blocked() const {
  return std::any_of(moves_.begin(), moves_.end(), [](const Moves& moves) {
    return std::any_of(moves.begin(), moves.end(), [](const auto& move) { return !move.second; });
  });
}

}  // namespace wristwise
