#pragma once

#include <map>
#include <set>

#include "import/krl_values.hpp"
#include "import/program_move.hpp"

namespace wristwise {

/// The points that a program declares, and what a move to one of them means. Components that a
/// target leaves out keep their values of the move before.
class KrlPoints {
 public:
  /// "XP1 = {...}" or "XP1" after the type; other values than aggregates are not understood.
  void declare(TokenReader& reader);
  bool has(const std::string& name) const { return points_.count(name) > 0; }

  /// The target of a move: an aggregate or the name of a point.
  void read_target(TokenReader& reader, ProgramMove& move);

 private:
  KrlAggregate target(TokenReader& reader) const;
  void set_axes(const KrlAggregate& given, const TokenReader& reader, ProgramMove& move);
  void set_pose(const KrlAggregate& given, const TokenReader& reader, ProgramMove& move);

  std::map<std::string, KrlAggregate> points_;
  KrlAggregate axes_, frame_;  ///< of the move before; empty where it does not say
};

}  // namespace wristwise
