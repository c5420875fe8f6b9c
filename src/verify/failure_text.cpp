#include "verify/failure_text.hpp"

#include <fmt/format.h>

#include "wristwise/tolerance.hpp"

namespace wristwise::text {

namespace {

constexpr double kDegrees = 57.29577951308232;

std::string amount(int coordinate, double excess) {
  return coordinate < 3 ? fmt::format("{:.4g} mm", excess * 1e3)
                        : fmt::format("{:.4g} deg", excess * kDegrees);
}

const char* name(int coordinate) { return kCoordinateNames[static_cast<std::size_t>(coordinate)]; }

}  // namespace

std::string coverage(double first, double last, double start, double end) {
  return fmt::format("runs from {:.6g} s to {:.6g} s, the seam from {:.6g} s to {:.6g} s", first,
                     last, start, end);
}

std::string posture(std::size_t waypoint, double time, const std::string& joint, double error) {
  return fmt::format("waypoint {} ({:.4g} s): {} is {:.3g} off the posture that is given", waypoint,
                     time, joint, error);
}

std::string joint_range(std::size_t waypoint, double time, const std::string& joint, double excess,
                        double lower, double upper) {
  return fmt::format("waypoint {} ({:.4g} s): {} is {:.3g} outside its range [{:.6g}, {:.6g}]",
                     waypoint, time, joint, excess, lower, upper);
}

std::string waypoint_box(std::size_t waypoint, double time, int coordinate, double excess) {
  return fmt::format("waypoint {} ({:.4g} s): {} is {} outside its tolerance", waypoint, time,
                     name(coordinate), amount(coordinate, excess));
}

std::string between_box(double time, int coordinate, double excess) {
  return fmt::format("between waypoints ({:.4g} s): {} is {} outside its tolerance", time,
                     name(coordinate), amount(coordinate, excess));
}

std::string skipped_waypoint(std::size_t waypoint, double time, int coordinate, double excess) {
  return fmt::format("waypoint {} of the problem ({:.4g} s) has no row, and {} is {} outside there",
                     waypoint, time, name(coordinate), amount(coordinate, excess));
}

std::string joint_limit(const std::string& joint, double time, double excess) {
  return fmt::format("{} is {:.3g} beyond its limit after {:.4g} s", joint, excess, time);
}

std::string rate(int derivative, const std::string& joint, double time, double ratio) {
  constexpr std::array<const char*, 4> kNames = {"", "velocity", "acceleration", "jerk"};
  return fmt::format("{} of {} is {:.7g} times its limit at {:.4g} s",
                     kNames[static_cast<std::size_t>(derivative)], joint, ratio, time);
}

std::string clearance(const std::pair<std::string, std::string>& pair, double time, double distance,
                      double required) {
  return fmt::format("{} - {}: {:.4g} mm apart at {:.4g} s, {:.4g} mm required", pair.first,
                     pair.second, distance * 1e3, time, required * 1e3);
}

std::string seam_time_coverage(double first, double last, double start, double end) {
  return fmt::format("seam_time runs from {:.6g} s to {:.6g} s, the seam from {:.6g} s to {:.6g} s",
                     first, last, start, end);
}

std::string seam_time_decreases(double time, double rate) {
  return fmt::format("seam_time runs back after t = {:.6g} s, at a rate of {:.3g}", time, rate);
}

std::string too_fast(double time, double rate) {
  return fmt::format("runs the seam at {:.6g} times its speed after t = {:.6g} s", rate, time);
}

std::string off_pace(double time, double rate, double prescribed) {
  return fmt::format(
      "runs the seam at {:.6g} times its speed at t = {:.6g} s, where the problem asks for {:.6g}",
      rate, time, prescribed);
}

std::string not_at_rest(int derivative, const std::string& joint, double time, double rate) {
  return fmt::format("joint {} is not at rest at t = {:.6g} s: {} {:.3g}", joint, time,
                     derivative == 1 ? "speed" : "acceleration", rate);
}

}  // namespace wristwise::text
