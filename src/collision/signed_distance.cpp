#include "collision/signed_distance.hpp"

#include <optional>

#include "collision/fcl_nearest_points.hpp"
#include "collision/nearest_points.hpp"
#include "collision/normal_search.hpp"
#include "collision/penetration.hpp"
#include "collision/point_distance.hpp"

namespace wristwise {

namespace {

// m; bounds that are nearer to each other than this prove the answer
constexpr double kCertified = 1e-8;
// m; nearer than this, the difference of the nearest points no longer gives the normal
constexpr double kTouching = 1e-9;
// m; in contact no deeper than this every common point is as good as the deepest
constexpr double kShallow = 1e-7;

SignedDistance grown(const SignedDistance& core, double margin_a, double margin_b) {
  return {core.distance - margin_a - margin_b, core.point_a + margin_a * core.normal,
          core.point_b - margin_b * core.normal, core.normal};
}

SignedDistance swapped(const SignedDistance& d) {
  return {d.distance, d.point_b, d.point_a, -d.normal};
}

SignedDistance sphere_to_sphere(const PlacedShape& a, const PlacedShape& b) {
  const Eigen::Vector3d from = a.pose.translation();
  const Eigen::Vector3d to = b.pose.translation();
  const double distance = (to - from).norm();
  const Eigen::Vector3d normal =
      distance > 0 ? Eigen::Vector3d((to - from) / distance) : Eigen::Vector3d::UnitX();
  return grown({distance, from, to, normal}, core_margin(a), core_margin(b));
}

template <class Solid>
SignedDistance solid_to_sphere(const Solid& solid, const PlacedShape& a, const PlacedShape& b) {
  const Eigen::Vector3d center = b.pose.translation();
  const PointDistance local = point_distance(solid, a.pose.inverse(Eigen::Isometry) * center);
  const Eigen::Vector3d normal = a.pose.linear() * local.normal;
  return grown({local.distance, center - local.distance * normal, center, normal}, 0,
               core_margin(b));
}

std::optional<SignedDistance> closed_form(const PlacedShape& a, const PlacedShape& b) {
  if (!std::holds_alternative<Sphere>(b.geometry)) return std::nullopt;
  if (std::holds_alternative<Sphere>(a.geometry)) return sphere_to_sphere(a, b);
  if (const auto* box = std::get_if<Box>(&a.geometry)) return solid_to_sphere(*box, a, b);
  if (const auto* rod = std::get_if<Cylinder>(&a.geometry)) return solid_to_sphere(*rod, a, b);
  return std::nullopt;
}

bool open(const CertifiedDistance& found) { return !(found.upper - found.lower <= kCertified); }

/// How far the points are from lying opposite each other along the normal.
double off_normal(const CertifiedDistance& found) {
  return (found.on_b - found.on_a - found.lower * found.normal).norm();
}

/// The distance is that of the plane, which is never too large. Both points lie at half of it from
/// the middle between them, so that point_b - point_a = distance * normal to the last digit.
SignedDistance about_middle(const CertifiedDistance& found) {
  const Eigen::Vector3d middle = (found.on_a + found.on_b) / 2;
  const Eigen::Vector3d half = found.lower / 2 * found.normal;
  return {found.lower, middle - half, middle + half, found.normal};
}

/// The points where the cores all but touch once b is moved out along the normal.
void move_to_contact(const PlacedShape& a, const PlacedShape& b, CertifiedDistance& found) {
  const Eigen::Vector3d way_out = (kShallow - found.lower) * found.normal;
  Pose pose = b.pose;
  pose.translation() += way_out;
  const CertifiedDistance contact = nearest_points(a, {b.geometry, pose}, found.normal);
  found.on_a = contact.on_a;
  found.on_b = contact.on_b - way_out;
}

SignedDistance between_cores(const PlacedShape& a, const PlacedShape& b) {
  if (const auto found = fcl_nearest_points(a, b, kCertified)) return about_middle(*found);
  const Eigen::Vector3d offset = b.pose.translation() - a.pose.translation();
  const double length = offset.norm();
  const Eigen::Vector3d guess =
      length > 0 ? Eigen::Vector3d(offset / length) : Eigen::Vector3d::UnitX();
  const CertifiedDistance apart = nearest_points(a, b, guess);
  if (apart.lower > kTouching && !open(apart)) return about_middle(apart);

  CertifiedDistance overlap = penetration(a, b);
  if (open(overlap)) search_normal(a, b, overlap);
  if (apart.lower > overlap.lower + kCertified) return about_middle(apart);
  if (overlap.lower > -kShallow) {
    // The sides of the polytope may not reach the place of contact, but any common point is near.
    overlap.on_a = apart.on_a;
    overlap.on_b = apart.on_b;
  }
  if (off_normal(overlap) > kShallow) move_to_contact(a, b, overlap);
  return about_middle(overlap);
}

}  // namespace

SignedDistance signed_distance(const PlacedShape& a, const PlacedShape& b) {
  if (const auto answer = closed_form(a, b)) return *answer;
  if (const auto answer = closed_form(b, a)) return swapped(*answer);
  return grown(between_cores(a, b), core_margin(a), core_margin(b));
}

}  // namespace wristwise
