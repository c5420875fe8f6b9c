#pragma once

// Readers of exported programs, by regular expressions; they share nothing with the writers nor
// with the readers of the program under test.

#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace wristwise::test {

struct ReadPoint {
  std::map<std::string, double> axes;  ///< by name: A1 or J1, E1: deg or mm
  double time = 0;                     ///< s, from the first point
  bool welding = false;                ///< on the move that ends here
};

struct ReadProgram {
  std::string name;
  std::vector<ReadPoint> points;
  bool arc_left_on = false;
};

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline std::vector<double> numbers_of(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '[' || c == ']') c = ' ';
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (double value = 0; stream >> value;) numbers.push_back(value);
  return numbers;
}

inline ReadProgram read_krl_export(const std::string& text) {
  const std::regex point(R"(^\s*S?PTP \{E6AXIS: (.*)\}$)"), axis(R"(([AE][1-6]) (-?[0-9.]+))");
  const std::regex part(R"(^\s*TIME_BLOCK PART=([0-9.]+)$)"),
      end(R"(^\s*TIME_BLOCK END=([0-9.]+)$)");
  const std::regex name(R"(^DEF (\w+)\(\)$)");
  ReadProgram program;
  std::vector<double> shares;
  bool at_next_end = false;  // what the arc will be at the end of the next move
  double duration = 0;
  bool on = false;
  std::smatch match;
  for (const std::string& line : lines_of(text)) {
    if (std::regex_match(line, match, name)) program.name = match[1];
    if (std::regex_match(line, match, point)) {
      ReadPoint next;
      next.welding = on;
      const std::string list = match[1];
      for (std::sregex_iterator it(list.begin(), list.end(), axis), none; it != none; ++it)
        next.axes[(*it)[1]] = std::stod((*it)[2]);
      program.points.push_back(next);
      on = at_next_end;
    } else if (std::regex_match(line, match, part)) {
      shares.push_back(std::stod(match[1]));
    } else if (std::regex_match(line, match, end)) {
      duration = std::stod(match[1]);
    } else if (line == "$OUT[1]=TRUE" || line == "$OUT[1]=FALSE") {
      on = at_next_end = line == "$OUT[1]=TRUE";
    } else if (line == "  TRIGGER WHEN PATH=0 DELAY=0 DO $OUT[1]=TRUE") {
      at_next_end = true;
    } else if (line == "  TRIGGER WHEN PATH=0 DELAY=0 DO $OUT[1]=FALSE") {
      at_next_end = false;
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < shares.size() && i + 1 < program.points.size(); ++i)
    program.points[i + 1].time = (sum += shares[i]) / 100 * duration;
  program.arc_left_on = on;
  return program;
}

inline ReadProgram read_rapid_export(const std::string& text) {
  const std::regex move(
      R"(^\s*MoveAbsJ \[(\[[^\]]*\]),(\[[^\]]*\])\]\\NoEOffs,v1000(?:\\T:=([0-9.]+))?,(\w+),\w+\\WObj:=\w+;$)");
  const std::regex name(R"(^\s*PROC (\w+)\(\)$)");
  ReadProgram program;
  double time = 0;
  bool on = false;
  std::smatch match;
  for (const std::string& line : lines_of(text)) {
    if (std::regex_match(line, match, name)) program.name = match[1];
    if (line == "    SetDO doWeld,1;") on = true;
    if (line == "    SetDO doWeld,0;") on = false;
    if (!std::regex_match(line, match, move)) continue;
    if (match[3].matched) time += std::stod(match[3]);
    ReadPoint point;
    point.time = time;
    point.welding = on;
    const std::vector<double> robot = numbers_of(match[1]), external = numbers_of(match[2]);
    for (std::size_t k = 0; k < robot.size(); ++k)
      point.axes["A" + std::to_string(k + 1)] = robot[k];
    for (std::size_t k = 0; k < external.size(); ++k)
      if (external[k] < 8e9) point.axes["E" + std::to_string(k + 1)] = external[k];
    program.points.push_back(point);
  }
  program.arc_left_on = on;
  return program;
}

inline ReadProgram read_ls_export(const std::string& text) {
  const std::regex name(R"(^/PROG  (\w+)$)");
  const std::regex move(R"(^ *\d+:J P\[(\d+)\] (\d+%|[0-9.]+m?sec) (FINE|CNT\d+)    ;$)");
  const std::regex weld(R"(^ *\d+:  Arc (Start|End)\[1\] ;$)");
  const std::regex position(R"(P\[(\d+)\]\{([^}]*)\};)"),
      axis(R"(([JE][1-6])= *(-?[0-9.]+) *(deg|mm))");
  ReadProgram program;
  std::vector<int> indices;
  double time = 0;
  bool on = false;
  std::smatch match;
  for (const std::string& line : lines_of(text)) {
    if (std::regex_match(line, match, name)) program.name = match[1];
    if (std::regex_match(line, match, weld)) on = match[1] == "Start";
    if (!std::regex_match(line, match, move)) continue;
    const std::string speed = match[2];
    if (speed.find("msec") != std::string::npos)
      time += std::stod(speed) / 1000;
    else if (speed.find("sec") != std::string::npos)
      time += std::stod(speed);
    indices.push_back(std::stoi(match[1]));
    program.points.push_back({{}, time, on});
  }
  std::map<int, std::map<std::string, double>> positions;
  for (std::sregex_iterator it(text.begin(), text.end(), position), none; it != none; ++it) {
    const std::string body = (*it)[2];
    for (std::sregex_iterator a(body.begin(), body.end(), axis); a != none; ++a)
      positions[std::stoi((*it)[1])][(*a)[1]] = std::stod((*a)[2]);
  }
  for (std::size_t i = 0; i < indices.size(); ++i) program.points[i].axes = positions[indices[i]];
  program.arc_left_on = on;
  return program;
}

/// Rows of numbers under `name:` in each point of a JointTrajectory.
struct ReadTrajectory {
  std::vector<std::string> joints;
  std::vector<double> times;
  std::vector<std::vector<double>> positions, velocities, accelerations;
};

inline ReadTrajectory read_ros_export(const std::string& text) {
  const std::regex key(R"(^ *(?:- )?(\w+):(.*)$)"), item(R"(^ *- ([^:]+)$)");
  ReadTrajectory read;
  std::string current;
  std::smatch match;
  for (const std::string& line : lines_of(text)) {
    if (line == "multi_dof_joint_trajectory:") break;
    if (std::regex_match(line, match, key)) {
      current = match[1];
      if (current == "positions") {
        read.positions.emplace_back();
        read.velocities.emplace_back();
        read.accelerations.emplace_back();
      }
      if (current == "time_from_start") read.times.push_back(0);
      if (read.times.empty()) continue;
      if (current == "sec") read.times.back() += std::stod(match[2]);
      if (current == "nanosec") read.times.back() += std::stod(match[2]) * 1e-9;
    } else if (std::regex_match(line, match, item)) {
      if (current == "joint_names") read.joints.push_back(match[1]);
      if (current == "positions") read.positions.back().push_back(std::stod(match[1]));
      if (current == "velocities") read.velocities.back().push_back(std::stod(match[1]));
      if (current == "accelerations") read.accelerations.back().push_back(std::stod(match[1]));
    }
  }
  return read;
}

}  // namespace wristwise::test
