#pragma once

#include <utility>
#include <vector>

#include "wristwise/clearance.hpp"

namespace wristwise {

/// The links that have shapes, in chain order, and then the objects; shapes in the frame of the
/// joint that carries them. @throws InvalidInput for a name given twice or an unusable shape.
std::vector<ClearanceModel::Body> collision_bodies(const Robot& robot, const Scene& scene);

/// Indices of the pairs of bodies whose distance counts by the scene's scope, first < second, not
/// regarding permanent contacts. @throws InvalidInput for a listed name that is unknown, or a
/// listed pair that does not move against itself.
std::vector<std::pair<int, int>> body_pairs(const std::vector<ClearanceModel::Body>& bodies,
                                            const Robot& robot, const Scene& scene);

}  // namespace wristwise
