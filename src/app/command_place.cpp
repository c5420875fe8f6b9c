#include <unistd.h>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/output_folder.hpp"
#include "app/placement_summary.hpp"
#include "app/required_file.hpp"
#include "io/placement_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

/// An internal error becomes a failed result that says so. @throws InvalidInput
PlacementResult run(const PlacementRequest& request, const PlanOptions& options, int& exit_code) {
  try {
    PlacementResult result = place(request, options);
    exit_code = exit_code_of(result.status);
    return result;
  } catch (const InvalidInput&) {
    throw;
  } catch (const std::exception& error) {
    PlacementResult result;
    result.status = Status::failed;
    result.diagnosis.push_back(
        {std::nullopt, "internal_error", error.what(), "please report this with the problem file"});
    exit_code = kInternalError;
    return result;
  }
}

}  // namespace

int run_place(const PlaceCommand& command, const Settings& settings) {
  require_file(command.problem, "a problem file", ".yaml");
  const std::filesystem::path folder = output_folder(command.out, command.problem);
  const PlacementRequest request = load_placement(command.problem, load_options(settings));
  Console console(settings);
  int exit_code = kInternalError;
  const PlacementResult result = run(request, console.plan_options(request.problem), exit_code);
  write_placement(folder, request, result, command.problem);
  print(placement_summary(request, result, folder, Paint(settings.colour, STDOUT_FILENO)));
  return exit_code;
}

}  // namespace wristwise::app
