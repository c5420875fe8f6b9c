"""Forward kinematics of a URDF, written from the format's definition: an oracle for the tests."""

import math
import xml.etree.ElementTree as ElementTree


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def turn(axis, angle):
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    d = 1 - c
    return [[c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0],
            [0, 0, 0, 1]]


def shift(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def vector(element, key, default):
    text = element.get(key) if element is not None else None
    return [float(part) for part in text.split()] if text else default


def origin(element):
    xyz = vector(element, "xyz", [0, 0, 0])
    roll, pitch, yaw = vector(element, "rpy", [0, 0, 0])
    turned = product(product(turn([0, 0, 1], yaw), turn([0, 1, 0], pitch)), turn([1, 0, 0], roll))
    return product(shift(*xyz), turned)


def tip_position(urdf, base, tip, posture):
    """The position of a link for joint values (rad, m) by name."""
    joints = {joint.find("child").get("link"): joint
              for joint in ElementTree.parse(urdf).getroot().findall("joint")}
    pose = shift(0, 0, 0)
    while tip != base:
        joint = joints[tip]
        motion = origin(joint.find("origin"))
        if joint.get("type") != "fixed":
            axis = vector(joint.find("axis"), "xyz", [1, 0, 0])
            value = posture[joint.get("name")]
            slides = joint.get("type") == "prismatic"
            motion = product(motion, shift(*(value * x for x in axis)) if slides else turn(axis, value))
        pose = product(motion, pose)
        tip = joint.find("parent").get("link")
    return [pose[i][3] for i in range(3)]
