#include "task/checked_description.hpp"

#include <fmt/format.h>

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void name_if_empty(std::string& where, const std::string& name) {
  if (where.empty()) where = name;
}

void require_finite(bool finite, const std::string& where) {
  if (!finite) throw InvalidInput(where, "a value that is not finite", "numbers in m, rad and s");
}

/// One name for each of `count` parts of a list.
void name_items(std::vector<std::string>& where, std::size_t count, const std::string& list,
                const char* item) {
  if (where.empty()) {
    for (std::size_t i = 0; i < count; ++i)
      where.push_back(fmt::format("{}, {} {}", list, item, i + 1));
  }
  if (where.size() != count)
    throw InvalidInput(list, fmt::format("{} names for {} {}s", where.size(), count, item),
                       "one for each, or none");
}

/// Names and checks the shape of a segment.
struct ShapeCheck {
  const std::string& where;

  void operator()(const LineSegment& line) const {
    require_finite(line.from.matrix().allFinite() && line.to.matrix().allFinite(), where);
  }

  void operator()(const ArcSegment& arc) const {
    require_finite(arc.from.matrix().allFinite() && arc.center.allFinite() &&
                       arc.axis.allFinite() && std::isfinite(arc.angle),
                   where);
  }

  void operator()(PoseListSegment& list) const {
    name_items(list.where, list.poses.size(), where, "pose");
    for (std::size_t i = 0; i < list.poses.size(); ++i)
      require_finite(list.poses[i].matrix().allFinite(), list.where[i]);
    if (list.times.empty()) return;
    if (list.times.size() != list.poses.size())
      throw InvalidInput(where,
                         fmt::format("{} times for {} poses", list.times.size(), list.poses.size()),
                         "one for each, or none");
    for (std::size_t i = 0; i < list.times.size(); ++i)
      require_finite(std::isfinite(list.times[i]), list.where[i]);
  }

  void operator()(JointListSegment& list) const {
    name_items(list.where, list.postures.size(), where, "joint waypoint");
  }
};

}  // namespace

SeamDescription checked_description(SeamDescription description) {
  name_if_empty(description.where, "seam");
  for (std::size_t i = 0; i < description.segments.size(); ++i) {
    Segment& segment = description.segments[i];
    name_if_empty(segment.where, fmt::format("segment {}", i + 1));
    std::visit(ShapeCheck{segment.where}, segment.shape);
    if (!std::holds_alternative<JointListSegment>(segment.shape))
      segment.tolerance.validate(segment.where);
  }
  if (description.run_in) name_if_empty(description.run_in->where, "run-in");
  if (description.run_out) name_if_empty(description.run_out->where, "run-out");
  return description;
}

}  // namespace wristwise
