#pragma once

#include <string>
#include <vector>

class TiXmlElement;

namespace wristwise {

/// Leaves of a URDF what makes up kinematics and collision shapes: elements that other programs
/// read (visuals, materials, inertias, transmissions, gazebo, ros2_control, calibration, ...) may
/// be incomplete without harm, and urdfdom would refuse the file for them.
/// @param visual_as_collision links without a collision element take their visual ones
/// @return names of the links that have visual but no collision elements
std::vector<std::string> clean_urdf(TiXmlElement& robot, bool visual_as_collision);

/// @throws InvalidInput where the file still holds xacro, a link has two parents, joints go round
/// in a loop, or more joints follow one another than a robot has.
void require_expanded_tree(const TiXmlElement& robot, const std::string& where);

}  // namespace wristwise
