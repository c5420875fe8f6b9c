#pragma once

#include <string>
#include <utility>

namespace wristwise::text {

/// One line for each way a trajectory can fail: what, where, by how much. Times in s; excesses in m
/// for coordinates 0-2, rad for 3-5.
std::string coverage(double first, double last, double start, double end);
std::string posture(std::size_t waypoint, double time, const std::string& joint, double error);
std::string joint_range(std::size_t waypoint, double time, const std::string& joint, double excess,
                        double lower, double upper);
std::string waypoint_box(std::size_t waypoint, double time, int coordinate, double excess);
std::string between_box(double time, int coordinate, double excess);
std::string skipped_waypoint(std::size_t waypoint, double time, int coordinate, double excess);
std::string joint_limit(const std::string& joint, double time, double excess);
std::string rate(int derivative, const std::string& joint, double time, double ratio);
std::string clearance(const std::pair<std::string, std::string>& pair, double time, double distance,
                      double required);
std::string seam_time_coverage(double first, double last, double start, double end);
std::string seam_time_decreases(double time, double rate);
std::string too_fast(double time, double rate);
std::string off_pace(double time, double rate, double prescribed);
std::string not_at_rest(int derivative, const std::string& joint, double time, double rate);

}  // namespace wristwise::text
