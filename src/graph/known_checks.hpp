#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <unordered_map>
#include <vector>

#include "graph/ladder_graph.hpp"

namespace wristwise {

/// What has been asked of EdgeRules::is_usable and is_clear, so that nothing is asked twice.
/// Configurations are those of the rungs without copies: copies of a configuration, and moves whose
/// ends are shifted by the same turns, share an answer.
class KnownChecks {
 public:
  KnownChecks(const std::vector<Rung>& rungs, const EdgeRules& rules);

  bool is_blocked(std::size_t rung, Eigen::Index index) const {
    return !usable_[rung].empty() && usable_[rung][static_cast<std::size_t>(index)] == kBlocked;
  }
  bool is_unknown(std::size_t rung, Eigen::Index index) const {
    return rules_.is_usable &&
           (usable_[rung].empty() || usable_[rung][static_cast<std::size_t>(index)] == kUnknown);
  }
  /// Asks where it is not known. Threads may ask about different rungs.
  bool is_usable(int worker, std::size_t rung, Eigen::Index index);

  /// A move between copies of two configurations.
  struct Move {
    Eigen::Index from = 0, to = 0;
    std::array<std::int16_t, kMaxJoints> turns{};  ///< of the end less those of the start
    bool operator==(const Move& other) const {
      return from == other.from && to == other.to && turns == other.turns;
    }
  };
  struct MoveHash {
    std::size_t operator()(const Move& move) const {
      std::uint64_t hash = static_cast<std::uint64_t>(move.from) * 0x9E3779B97F4A7C15u;
      hash = (hash ^ static_cast<std::uint64_t>(move.to)) * 0xC2B2AE3D27D4EB4Fu;
      std::array<std::uint64_t, sizeof move.turns / sizeof(std::uint64_t)> words{};
      std::memcpy(words.data(), move.turns.data(), sizeof words);
      for (const std::uint64_t word : words)
        hash = (hash ^ word ^ (hash >> 29)) * 0x165667B19E3779F9u;
      return static_cast<std::size_t>(hash ^ (hash >> 29));
    }
  };
  using Moves = std::unordered_map<Move, bool, MoveHash>;  ///< -> clear

  Move move(std::size_t interval, Eigen::Index from, Eigen::Index to, const JointVector& q_from,
            const JointVector& q_to) const;

  const Moves& moves(std::size_t interval) const { return moves_[interval]; }
  void add(std::size_t interval, const Moves& moves) {
    moves_[interval].insert(moves.begin(), moves.end());
  }

  std::size_t usable_checks() const;
  std::size_t blocked() const;  ///< configurations
  std::size_t clear_checks() const;
  bool any_move_blocked() const;

 private:
  enum : signed char { kUnknown, kUsable, kBlocked };
  const std::vector<Rung>& rungs_;
  const EdgeRules& rules_;
  std::vector<std::vector<signed char>> usable_;  ///< empty where nothing was asked
  std::vector<Moves> moves_;
};

}  // namespace wristwise
