#pragma once

/// @file
/// All public headers.

/// @mainpage
/// A weld seam in, a smooth, collision-free, verified joint trajectory out. Data flows one way:
///
/// - read: load_problem() gives a Problem; load_robot(), load_mesh(), read_joint_path() its parts
/// - plan: plan(), plan_graph_only(), smooth() give a PlanResult; place() looks for a better place
/// - check: check(), verify() give a Verification
/// - write: write_path(), write_trajectory(), write_dense(), write_program()
///
/// A Problem is a plain struct: it may be filled in without a file, and any part of one that was
/// read may be replaced (CostOptions::vertex_cost, Problem::inverse_kinematics, Scene::objects).
///
/// SI units throughout: m, rad, s. Base frame is the frame of the chain's first link, path frame
/// that of a waypoint: z along the torch towards the part, y along the weld. n is the number of
/// joints. Labels such as F14 are those of docs/formulation.md. Input that cannot be used throws
/// InvalidInput; no solution is a result with a diagnosis. The library never prints, and its
/// results do not depend on the number of threads.
///
/// @include 01_plan_a_seam.cpp

#include "wristwise/visibility.hpp"

/// Everything of the library is in this namespace.
namespace WRISTWISE_PUBLIC wristwise {}

#include "wristwise/clearance.hpp"
#include "wristwise/corner_options.hpp"
#include "wristwise/error.hpp"
#include "wristwise/export_options.hpp"
#include "wristwise/geometry.hpp"
#include "wristwise/ikfast_inverse_kinematics.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/joint_box.hpp"
#include "wristwise/joints.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/mesh.hpp"
#include "wristwise/monitor.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"
#include "wristwise/options.hpp"
#include "wristwise/placement.hpp"
#include "wristwise/plan.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/problem.hpp"
#include "wristwise/program_file.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/robot_program.hpp"
#include "wristwise/scene.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/seam_description.hpp"
#include "wristwise/smoothing.hpp"
#include "wristwise/swept_clearance.hpp"
#include "wristwise/tolerance.hpp"
#include "wristwise/trajectory.hpp"
#include "wristwise/trajectory_file.hpp"
#include "wristwise/urdf.hpp"
#include "wristwise/verification.hpp"
#include "wristwise/version.hpp"
#include "wristwise/visibility.hpp"
