#include "collision/signed_distance.hpp"

#include <optional>

#include "collision/nearest_points.hpp"
#include "collision/penetration.hpp"
#include "collision/point_distance.hpp"

namespace wristwise {

namespace {

// m; with bounds nearer to each other than this the nearest points are the answer, otherwise the
// lower bound is
constexpr double kCertified = 1e-7;
// m; nearer than this the difference of the nearest points no longer gives the normal
constexpr double kTouching = 1e-9;

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

/// Both points at half the distance along the normal from the middle between them, so that
/// point_b - point_a = distance * normal to the last digit.
SignedDistance about_middle(const CertifiedDistance& found, double distance,
                            const Eigen::Vector3d& normal) {
  const Eigen::Vector3d middle = (found.on_a + found.on_b) / 2;
  return {distance, middle - distance / 2 * normal, middle + distance / 2 * normal, normal};
}

SignedDistance from_separated(const CertifiedDistance& found) {
  if (found.upper - found.lower <= kCertified) {
    return {found.upper, found.on_a, found.on_b, (found.on_b - found.on_a) / found.upper};
  }
  return about_middle(found, found.lower, found.normal);
}

SignedDistance between_cores(const PlacedShape& a, const PlacedShape& b) {
  const Eigen::Vector3d offset = b.pose.translation() - a.pose.translation();
  const double length = offset.norm();
  const Eigen::Vector3d guess =
      length > 0 ? Eigen::Vector3d(offset / length) : Eigen::Vector3d::UnitX();
  const CertifiedDistance apart = nearest_points(a, b, guess);
  if (apart.upper > kTouching && apart.lower > 0) return from_separated(apart);
  const CertifiedDistance overlap = penetration(a, b);
  return about_middle(overlap, overlap.lower, overlap.normal);
}

}  // namespace

SignedDistance signed_distance(const PlacedShape& a, const PlacedShape& b) {
  if (const auto answer = closed_form(a, b)) return *answer;
  if (const auto answer = closed_form(b, a)) return swapped(*answer);
  return grown(between_cores(a, b), core_margin(a), core_margin(b));
}

}  // namespace wristwise
