#include "app/new_problem/shipped_robot.hpp"

#include "wristwise/error.hpp"

namespace wristwise::app {

std::filesystem::path shipped_robot() {
  namespace fs = std::filesystem;
  const fs::path kRobot = fs::path("robots") / "kuka_kr5_arc" / "kuka_kr5_arc.urdf";
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path above = program.parent_path().parent_path();
  for (const fs::path& folder : {above / "share" / "wristwise", above}) {
    if (!program.empty() && fs::exists(folder / kRobot, error)) return folder / kRobot;
  }
  throw InvalidInput("--robot", "is missing, and no robots ship beside this program",
                     "--robot FILE, a robot description (URDF)");
}

}  // namespace wristwise::app
