"""What all plain structs have in common."""

import copy
import inspect
import pickle
import re

import numpy
import pytest

import wristwise

STRUCTS = [cls for cls in vars(wristwise).values()
           if inspect.isclass(cls) and hasattr(cls, "__signature__")]
NO_DEFAULT = {"Box", "Sphere", "Cylinder", "ConvexHull", "Shape", "SceneObject", "JointBox",
              "LineSegment", "ArcSegment", "PoseListSegment", "JointListSegment", "Segment"}


def fields_of(cls):
    return [name for name, member in vars(cls).items() if isinstance(member, property)]


def header_members(source, header, struct):
    """Members of a C++ struct: name -> text of its default, or None. An oracle for our own."""
    text = (source / "include" / "wristwise" / header).read_text()
    body = re.search(r"struct " + struct + r" \{(.*?)\n\};", text, re.DOTALL).group(1)
    body = re.sub(r"//.*", "", body)
    body = re.sub(r"enum class \w+ \{.*?\};|\{\}", "", body, flags=re.DOTALL)
    while re.search(r"<[^<>]*>", body):
        body = re.sub(r"<[^<>]*>", "", body)
    members = {}
    for statement in body.split(";"):
        if "(" in statement.replace("()", "") or statement.split()[:1] == ["using"]:
            continue
        for declarator in statement.split(","):
            name, _, default = (part.strip() for part in declarator.partition("="))
            if name:
                members[name.split()[-1]] = default or None
    return members


def value_of(text, cls):
    text = text.replace("std::numeric_limits::infinity()", "float('inf')")
    if "::" in text:
        enum, member = text.split("::")[:2]
        return getattr(getattr(cls, enum, None) or getattr(wristwise, enum), member, None)
    return {"true": True, "false": False}.get(text, None) if text in ("true", "false") else eval(text)


@pytest.mark.parametrize("header, struct", [
    ("options.hpp", "CostOptions"), ("options.hpp", "GraphOptions"),
    ("options.hpp", "RefineOptions"), ("verification.hpp", "VerificationOptions"),
    ("smoothing.hpp", "SmoothingOptions"), ("placement.hpp", "PlacementOptions"),
    ("numeric_inverse_kinematics.hpp", "NumericIkOptions"), ("mesh.hpp", "MeshOptions"),
    ("problem.hpp", "Problem"), ("problem.hpp", "LoadOptions"), ("scene.hpp", "Scene"),
    ("verification.hpp", "Verification"), ("plan.hpp", "PlanResult"),
    ("plan.hpp", "GraphStatistics"), ("plan.hpp", "RefineStatistics"), ("plan.hpp", "Seed"),
    ("plan.hpp", "Diagnosis"), ("plan.hpp", "FailureCounts"), ("plan.hpp", "SlowedStretch"),
    ("placement.hpp", "PlacementResult"), ("placement.hpp", "PlacementMeasure"),
    ("export_options.hpp", "ControllerAxis"), ("corner_options.hpp", "CornerOptions"),
    ("seam_description.hpp", "SeamDescription"), ("seam_description.hpp", "RunDescription"),
    ("seam_description.hpp", "LineSegment"), ("seam_description.hpp", "ArcSegment"),
    ("seam_description.hpp", "PoseListSegment"), ("seam_description.hpp", "JointListSegment"),
    ("seam_description.hpp", "Segment"),
])
def test_names_and_defaults_are_those_of_the_header(source, header, struct):
    members = {{"with": "with_", "from": "from_"}.get(name, name): default
               for name, default in header_members(source, header, struct).items()}
    cls = getattr(wristwise, struct)
    assert set(fields_of(cls)) == set(members)
    if cls not in STRUCTS or struct in NO_DEFAULT:
        return  # a result, which the library makes, or one that cannot do without values
    instance = cls()
    for name, text in members.items():
        if text and not re.search("Zero|Identity|nullopt|{}", text):
            assert getattr(instance, name) == value_of(text, cls), name


@pytest.mark.parametrize("cls", STRUCTS, ids=lambda cls: cls.__name__)
def test_keywords_repr_replace_and_pickle(cls):
    if cls.__name__ in NO_DEFAULT:
        with pytest.raises(TypeError, match="is missing"):
            cls()
        return
    instance = cls()
    assert repr(instance) == f"{cls.__name__}()"
    assert list(inspect.signature(cls).parameters) == fields_of(cls)
    same = cls(**{name: getattr(instance, name) for name in fields_of(cls)})
    assert repr(same) == repr(instance)
    assert repr(pickle.loads(pickle.dumps(instance))) == repr(instance)
    assert repr(instance.replace()) == repr(copy.deepcopy(instance)) == repr(instance)
    with pytest.raises(TypeError, match="has no attribute 'colour'"):
        cls(colour=1)
    with pytest.raises(TypeError):
        cls(1)


def test_a_misspelt_keyword_is_met_with_the_right_one():
    with pytest.raises(TypeError, match="no attribute 'joint_moton'; did you mean 'joint_motion'?"):
        wristwise.CostOptions(joint_moton=2)
    with pytest.raises(AttributeError):
        wristwise.CostOptions().joint_moton = 2


def test_a_wrong_type_names_what_is_expected():
    with pytest.raises(TypeError, match="CostOptions.jerk: 'much'; expected float"):
        wristwise.CostOptions(jerk="much")
    with pytest.raises(TypeError, match="GraphOptions.turns: 'all'; expected wristwise.Turns"):
        wristwise.GraphOptions().turns = "all"
    with pytest.raises(TypeError, match="Problem.cost: None; expected wristwise.CostOptions"):
        wristwise.Problem(cost=None)
    with pytest.raises(TypeError, match="GraphOptions.seeds: 1.5; expected int"):
        wristwise.GraphOptions(seeds=1.5)
    with pytest.raises(TypeError, match="Problem.inverse_kinematics|inverse_kinematics: 3"):
        wristwise.Problem(inverse_kinematics=3)
    with pytest.raises(wristwise.InvalidInput, match="CostOptions.jerk: NaN"):
        wristwise.CostOptions(jerk=float("nan"))


def test_a_repr_tells_what_differs_from_the_defaults():
    cost = wristwise.CostOptions(jerk=2, joint_weights=[1, 2])
    assert repr(cost) == "CostOptions(jerk=2.0, joint_weights=[1.0, 2.0])"
    assert repr(wristwise.Sphere(radius=0.5)) == "Sphere(radius=0.5)"
    path = wristwise.JointPath(times=range(50), positions=numpy.zeros((50, 6)))
    assert repr(path) == "JointPath(times=<array (50,)>, positions=<array (50, 6)>)"


def test_options_are_changed_in_place():
    problem = wristwise.Problem()
    problem.cost.jerk = 5
    problem.exports.krl.tool = 7
    assert problem.cost.jerk == 5 and problem.exports.krl.tool == 7
    cost = wristwise.CostOptions(jerk=6)
    problem.cost = cost
    cost.jerk = 7
    assert problem.cost.jerk == 6


def test_an_option_outlives_its_problem():
    cost = wristwise.Problem(cost=wristwise.CostOptions(jerk=5)).cost
    assert cost.jerk == 5


def test_what_would_be_lost_is_an_error(seam_problem):
    result = wristwise.plan_graph_only(seam_problem)
    with pytest.raises(ValueError, match="read-only"):
        result.path.positions[0, 0] = 0
    with pytest.raises(AttributeError):
        result.status = wristwise.Status.failed
    with pytest.raises(AttributeError):
        seam_problem.task.waypoints.append(None)
    with pytest.raises(AttributeError):
        seam_problem.task.waypoints[0].time = 3
    with pytest.raises(TypeError):
        seam_problem.graph.redundancy["rail"] = 0.1
    with pytest.raises(ValueError, match="read-only"):
        wristwise.CostOptions(joint_weights=[1, 2]).joint_weights[0] = 3


def test_copies_are_independent(seam_problem):
    twin = copy.deepcopy(seam_problem)
    twin.cost.jerk = 9
    twin.task.waypoints = twin.task.waypoints[:3]
    assert seam_problem.cost.jerk == 1 and len(seam_problem.task.waypoints) == 50
    moved = twin.task.waypoints[0].replace(time=-1)
    assert moved.time == -1 and twin.task.waypoints[0].time == 0


def test_a_problem_and_its_result_can_be_pickled(seam_problem):
    result = wristwise.plan(seam_problem)
    again = pickle.loads(pickle.dumps(result))
    assert repr(again) == repr(result)
    assert numpy.array_equal(again.trajectory.positions, result.trajectory.positions)
    replanned = wristwise.plan(pickle.loads(pickle.dumps(seam_problem)))
    assert numpy.array_equal(replanned.trajectory.positions, result.trajectory.positions)


def test_what_a_file_made_and_python_cannot_is_not_pickled(load):
    with pytest.raises(TypeError, match="SeamCurve"):
        pickle.dumps(load("corner_stop"))
