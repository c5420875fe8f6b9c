#pragma once

#include <utility>
#include <vector>

#include "wristwise/clearance.hpp"

namespace wristwise {

/// The links that have shapes, in chain order, and then the objects; shapes in the frame of the
/// joint that carries them. @throws InvalidInput for a name given twice, an unusable shape, or an
/// object fixed to an unknown link.
std::vector<ClearanceModel::Body> collision_bodies(const Robot& robot, const Scene& scene);

/// Indices of the pairs of bodies whose distance counts by the scene's scope, first < second, not
/// regarding permanent contacts. @throws InvalidInput for a listed name that is unknown, or a
/// listed pair that does not move against itself.
std::vector<std::pair<int, int>> body_pairs(const std::vector<ClearanceModel::Body>& bodies,
                                            const Robot& robot, const Scene& scene);

/// Whether contact of a pair at every posture says nothing about the motion: two links, two bodies
/// that do not move against each other, or an object and a link that one joint joins to the link
/// that the object names.
bool may_stay_in_contact(const std::vector<ClearanceModel::Body>& bodies, const Robot& robot,
                         const Scene& scene, const std::pair<int, int>& pair);

}  // namespace wristwise
