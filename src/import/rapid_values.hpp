#pragma once

#include <map>
#include <string>

#include "import/program_move.hpp"
#include "import/tokens.hpp"

namespace wristwise {

/// The data that a RAPID module declares: targets and speeds.
class RapidValues {
 public:
  /// "jointtarget j1 := [...];" from the type on; data of other types are left out.
  void read_data(TokenReader& reader);
  /// "j1 := [...];" of a target or speed that is declared
  bool has(const std::string& name) const;
  void assign(TokenReader& reader);

  /// By name or in place.
  void read_joint_target(TokenReader& reader, ProgramMove& move) const;
  void read_pose_target(TokenReader& reader, ProgramMove& move) const;
  /// speeddata and its switches \V and \T
  void read_speed(TokenReader& reader, ProgramMove& move) const;

 private:
  using Numbers = std::vector<double>;
  void assign(const std::string& name, const std::string& type, TokenReader& reader);
  Numbers numbers(TokenReader& reader, const std::string& type) const;

  std::map<std::string, std::string> types_;
  std::map<std::string, Numbers> values_;
};

}  // namespace wristwise
