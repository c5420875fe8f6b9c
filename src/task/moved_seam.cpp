#include "task/moved_seam.hpp"

namespace wristwise {

namespace {

struct Mover {
  const Pose& motion;

  void operator()(LineSegment& line) const {
    line.from = motion * line.from;
    line.to = motion * line.to;
  }
  void operator()(ArcSegment& arc) const {
    arc.from = motion * arc.from;
    arc.center = motion * arc.center;
    arc.axis = motion.linear() * arc.axis;
  }
  void operator()(PoseListSegment& list) const {
    for (Pose& pose : list.poses) pose = motion * pose;
  }
  void operator()(JointListSegment& /*list*/) const {}
};

}  // namespace

SeamDescription moved(SeamDescription seam, const Pose& motion) {
  for (Segment& segment : seam.segments) std::visit(Mover{motion}, segment.shape);
  return seam;
}

}  // namespace wristwise
