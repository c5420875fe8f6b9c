#pragma once

namespace wristwise::test {

/// Sliding axes x and y that carry a turn about z.
inline constexpr const char* kGantryUrdf = R"(<?xml version="1.0"?>
<robot name="gantry">
  <link name="base"/>
  <link name="beam"/>
  <link name="carriage"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="tip"/>
  <joint name="x" type="prismatic"><parent link="base"/><child link="beam"/><axis xyz="1 0 0"/>
    <limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
  <joint name="y" type="prismatic"><parent link="beam"/><child link="carriage"/>
    <axis xyz="0 1 0"/><limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
  <joint name="turn" type="revolute"><parent link="carriage"/><child link="tip"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>
)";

}  // namespace wristwise::test
