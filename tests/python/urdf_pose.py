"""The pose of a URDF's link in numpy, from the format's definition: an oracle for the tests."""

import xml.etree.ElementTree as ElementTree

import numpy
from urdf_kinematics import origin, shift, turn, vector


def tip_pose(urdf, base, tip, posture):
    """For joint values (rad, m) by name: shape (4, 4)."""
    joints = {joint.find("child").get("link"): joint
              for joint in ElementTree.parse(urdf).getroot().findall("joint")}
    pose = numpy.eye(4)
    while tip != base:
        joint = joints[tip]
        motion = numpy.array(origin(joint.find("origin")))
        if joint.get("type") != "fixed":
            axis = vector(joint.find("axis"), "xyz", [1, 0, 0])
            value = posture[joint.get("name")]
            slides = joint.get("type") == "prismatic"
            motion = motion @ numpy.array(shift(*(value * x for x in axis)) if slides
                                          else turn(axis, value))
        pose = motion @ pose
        tip = joint.find("parent").get("link")
    return pose
