#include "task/corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "task/corner_blend.hpp"
#include "task/path_point.hpp"
#include "task/pose_difference.hpp"
#include "task/seam_pace.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;  // rad
constexpr double kLeastAngle = 1e-3;              // rad, of a corner
constexpr double kSharpest = 170 * kDegree;       // rad, of a corner that is rounded off
constexpr double kLeastLength = 1e-9;             // m, of what is left of a stretch
constexpr double kLeastTime = 1e-9;               // s, likewise
constexpr double kRoundOff = 1e-9;                // relative
constexpr double kSpannedTolerance = 1e-9;        // rad

double degrees(double angle) { return angle / kDegree; }

bool is_path(const Stretch& stretch) { return stretch.piece.kind != SeamPiece::Kind::move; }

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool lies_in(const ToleranceBox& box, const Pose& frame, const Pose& pose) {
  return box_excess(box, deviation(box, frame, pose)).tail<3>().maxCoeff() <= kSpannedTolerance;
}

class CornerTreatment {
 public:
  CornerTreatment(const SeamDescription& description, std::vector<Stretch>& stretches)
      : description_(description), options_(description.corners), stretches_(stretches) {}

  void run() {
    const std::vector<Corner> corners = find_corners(stretches_);
    // From the last on, so that the numbers of those before stay as they are.
    for (auto corner = corners.rbegin(); corner != corners.rend(); ++corner) {
      if (options_.kind == CornerOptions::Kind::stop) stop_at(*corner);
      if (options_.kind == CornerOptions::Kind::slow) slow_down_at(*corner);
      if (options_.kind == CornerOptions::Kind::blend) round_off(*corner);
    }
    const auto is_used_up = [](const Stretch& stretch) {
      return is_path(stretch) && stretch.piece.length() < kLeastLength &&
             stretch.duration.value_or(0) < kLeastTime;
    };
    stretches_.erase(std::remove_if(stretches_.begin(), stretches_.end(), is_used_up),
                     stretches_.end());
  }

 private:
  [[noreturn]] void fail(const Corner& corner, const std::string& problem,
                         const std::string& expected) const {
    throw InvalidInput("the corner at the start of " + stretches_[corner.before + 1].where, problem,
                       expected);
  }

  const ToleranceBox& box_of(const Stretch& stretch) const {
    return description_.segments[stretch.segment].tolerance;
  }

  /// Whether the torch may keep its orientation where the frame jumps.
  bool is_spanned(const Stretch& before, const Stretch& after) const {
    return lies_in(box_of(before), before.piece.to, after.piece.from) &&
           lies_in(box_of(after), after.piece.from, before.piece.to);
  }

  void stop_at(const Corner& corner) {
    stretches_[corner.before].end_rate = 0;
    if (corner.turn <= kLeastAngle) return;
    const Stretch& before = stretches_[corner.before];
    const Stretch& after = stretches_[corner.before + 1];
    Stretch turn;
    turn.piece.from = before.piece.to;
    turn.piece.to = before.piece.to;
    turn.piece.to.linear() = after.piece.from.linear();
    turn.segment = after.segment;
    turn.where = after.where;
    turn.stands = true;
    turn.end_rate = 0;
    turn.duration = corner.turn / options_.turn_rate;
    // Nothing has to turn: the frame takes no longer than a ramp (F22).
    if (is_spanned(before, after))
      turn.duration = std::min(*turn.duration, options_.ramp_time / kRestToRest);
    stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(corner.before) + 1, turn);
  }

  void slow_down_at(const Corner& corner) {
    if (corner.turn > kLeastAngle &&
        !is_spanned(stretches_[corner.before], stretches_[corner.before + 1]))
      fail(corner,
           fmt::format("the frame turns by {:.3g} deg at once, more than the tolerance spans",
                       degrees(corner.turn)),
           "corners: stop or blend, or a wider tolerance");
    stretches_[corner.before].end_rate = options_.speed_ratio;
  }

  void round_off(const Corner& corner) {
    if (!corner.bend) fail(corner, "a turn on the spot can't be rounded off", "corners: stop");
    if (*corner.bend > kSharpest || corner.turn > kSharpest)
      fail(corner,
           fmt::format(
               "the path bends by {:.3g} deg and the frame turns by {:.3g} deg: too sharp to "
               "be rounded off",
               degrees(*corner.bend), degrees(corner.turn)),
           fmt::format("at most {:.0f} deg, or corners: stop", degrees(kSharpest)));
    Stretch& before = stretches_[corner.before];
    Stretch& after = stretches_[corner.before + 1];
    const double first = share_of(corner, before), last = share_of(corner, after);
    Stretch blend;
    blend.segment = after.segment;
    blend.where = after.where;
    blend.piece = blended(path_point(before.piece, 1 - first), path_point(after.piece, last));
    if (before.duration || after.duration)
      blend.duration = first * nominal_duration(before, description_) +
                       last * nominal_duration(after, description_);
    shorten(before, 0, 1 - first);
    shorten(after, last, 1);
    stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(corner.before) + 1, blend);
  }

  /// What the rounding takes of what is left of a stretch, from 0 to 1.
  double share_of(const Corner& corner, const Stretch& stretch) const {
    const double length = stretch.piece.length(), distance = options_.distance;
    if (distance > length * (1 + kRoundOff))
      fail(corner,
           fmt::format(
               "rounding off from {:.6g} m away does not fit, {:.6g} m are left of a segment",
               distance, length),
           "a shorter `blend`");
    const double bent = distance * path_point(stretch.piece, 0).curvature.norm();
    if (bent > 1 + kRoundOff)
      fail(corner,
           fmt::format("rounding off from {:.6g} m away, on an arc of a smaller radius", distance),
           "a shorter `blend`");
    return std::min(1.0, distance / length);
  }

  SeamPiece blended(const PathPoint& from, const PathPoint& to) const {
    SeamPiece piece;
    piece.kind = SeamPiece::Kind::curve;
    piece.from = from.frame;
    piece.to = to.frame;
    piece.curve = std::make_shared<const CornerBlend>(from, to, options_.distance);
    return piece;
  }

  static void shorten(Stretch& stretch, double from, double to) {
    stretch.piece = part_of(stretch.piece, from, to);
    if (stretch.duration) *stretch.duration *= to - from;
  }

  const SeamDescription& description_;
  const CornerOptions& options_;
  std::vector<Stretch>& stretches_;
};

}  // namespace

std::vector<Corner> find_corners(const std::vector<Stretch>& stretches) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
    if (!is_path(stretches[i]) || !is_path(stretches[i + 1])) continue;
    const PathPoint end = path_point(stretches[i].piece, 1);
    const PathPoint start = path_point(stretches[i + 1].piece, 0);
    const bool runs_on = !end.tangent.isZero(0), starts_off = !start.tangent.isZero(0);
    Corner corner;
    corner.before = i;
    corner.turn = turn_between(end.frame, start.frame);
    if (runs_on && starts_off) corner.bend = angle_between(end.tangent, start.tangent);
    const bool is_bent = corner.bend ? *corner.bend > kLeastAngle : runs_on != starts_off;
    if (is_bent || corner.turn > kLeastAngle) corners.push_back(corner);
  }
  return corners;
}

void treat_corners(const SeamDescription& description, std::vector<Stretch>& stretches) {
  if (description.corners.kind != CornerOptions::Kind::keep)
    CornerTreatment(description, stretches).run();
}

}  // namespace wristwise
