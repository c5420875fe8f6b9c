#!/usr/bin/env python3
"""Plans every shipped problem in both modes, checks what was written, and prints one table.

    tests/benchmarks/shipped_problems.py build/wristwise            # all of problems/
    tests/benchmarks/shipped_problems.py build/wristwise problems/task_a_cylinder.yaml

Time: of the processor, one thread, the whole process. Check: `wristwise check` of the written
trajectory. Speed: the largest share of a joint's speed limit. Acceleration and jerk: the largest
of all joints, from differences of the waypoints. Clearance: the least of all t."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

MODES = ("graph-only", "two-stage")
HEADER = ("problem", "joints", "waypoints", "mode", "plan", "check", "CPU s", "speed",
          "acceleration", "jerk", "clearance mm")


def run(command):
    """Exit code, standard output and seconds of the processor."""
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        output.seek(0)
        return (os.waitstatus_to_exitcode(status), output.read(),
                usage.ru_utime + usage.ru_stime)


def peak(peaks, what):
    return f"{max(joint[what] for joint in peaks.values()):.2g}"


def row(program, problem, mode, folder):
    out = pathlib.Path(folder) / problem.stem / mode
    code, _, seconds = run([program, "plan", problem, "--mode", mode, "--out", out, "--quiet",
                            "--threads", "1"])
    if code not in (0, 1):
        return [problem.stem, "", "", mode, f"exit {code}", "", f"{seconds:.2f}", "", "", "", ""]
    result = json.loads((out / "result.json").read_text(encoding="utf-8"))
    cells = [problem.stem, len(result["joints"]), result["waypoints"], mode, result["status"]]
    if result["status"] != "solved":
        return cells + ["", f"{seconds:.2f}", "", "", "", ""]
    _, output, _ = run([program, "check", problem, out / "trajectory.csv", "--json"])
    verification = json.loads(output)
    clearance = verification["clearance_m"]
    return cells + ["passed" if verification["passed"] else "FAILED", f"{seconds:.2f}",
                    f"{verification['velocity_ratio']:.2g}",
                    peak(result["peaks"], "acceleration"), peak(result["peaks"], "jerk"),
                    "" if clearance is None else f"{1000 * clearance:.1f}"]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    root = pathlib.Path(__file__).resolve().parents[2]
    problems = [pathlib.Path(name) for name in sys.argv[2:]]
    print("| " + " | ".join(HEADER) + " |")
    print("|" + "---|" * len(HEADER))
    with tempfile.TemporaryDirectory() as folder:
        for problem in problems or sorted((root / "problems").glob("*.yaml")):
            for mode in MODES:
                cells = row(sys.argv[1], problem, mode, folder)
                print("| " + " | ".join(map(str, cells)) + " |", flush=True)


if __name__ == "__main__":
    main()
