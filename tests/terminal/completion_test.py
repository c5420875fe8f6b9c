"""Tab completion in bash against what the program itself says of its commands and options."""

import re
import subprocess
import unittest

from help_test import commands, help_of
from program import SOURCE, ProgramTest

SCRIPT = SOURCE / "src/app/completion/wristwise.bash"

ASK_BASH = r"""
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMPREPLY=()
COMP_LINE="${COMP_WORDS[*]}"; COMP_POINT=${#COMP_LINE}
_wristwise wristwise
printf '%s\n' "${COMPREPLY[@]}"
"""

def options(text):
    """Options of a help text with the choices that their descriptions name."""
    found = {}
    for group in text.split("\n\n"):
        for match in re.finditer(r"^  (?:-\w, )?(--[a-z-]+)( [A-Z,]+)?  ", group, re.MULTILINE):
            found[match[1]] = match[2] is not None
    return found


class Completion(ProgramTest):
    def complete(self, *words):
        done = subprocess.run(["bash", "-c", ASK_BASH, "bash", SCRIPT, "wristwise", *words],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=60)
        self.assertEqual(done.stderr, b"")
        return done.stdout.decode().split()

    def test_commands(self):
        self.assertEqual(sorted(self.complete("")), sorted([*commands(), "help"]))
        self.assertEqual(self.complete("sm"), ["smooth"])
        self.assertEqual(self.complete("--quiet", "--threads", "2", "pl"), ["plan", "place"])
        self.assertEqual(sorted(self.complete("help", "")), sorted(commands()))

    def test_options_are_those_of_the_help(self):
        self.assertEqual(sorted(self.complete("--")), sorted(options(help_of())))
        for command in commands():
            of_help = options(help_of(command))
            self.assertGreaterEqual(len(of_help), 5)
            self.assertEqual(sorted(self.complete(command, "--")), sorted(of_help), command)
            for option in of_help:
                self.assertIn(option, self.complete(command, option[:-1]))

    def test_options_with_a_value_wait_for_it(self):
        """After an option that takes a value no other option and no argument is offered."""
        for command in commands():
            for option, takes_value in options(help_of(command)).items():
                after = self.complete(command, option, "")
                argument = self.complete(command, "")
                offered = [word for word in after if not (self.folder / word).exists()]
                if takes_value:
                    self.assertNotIn("--quiet", self.complete(command, option, "--qu"), option)
                    known = re.search(r"^  (?:-\w, )?" + option + r" .*\n(?:   .*\n)*",
                                      help_of(command), re.MULTILINE)[0]
                    for word in offered:
                        self.assertIn(word, known)
                else:
                    self.assertEqual(after, argument, f"{command} {option}")

    def test_fixed_values(self):
        self.assertEqual(self.complete("plan", "--mode", ""), ["two-stage", "graph-only"])
        self.assertEqual(self.complete("plan", "--mode", "g"), ["graph-only"])
        self.assertEqual(self.complete("--color", "a"), ["auto", "always"])
        self.assertEqual(self.complete("plan", "--mode", "=", "g"), ["graph-only"])
        self.assertEqual(self.complete("plan", "--mode", "="), ["two-stage", "graph-only"])
        self.assertEqual(self.complete("--color", "=", "never", "inf"), ["info"])
        self.assertEqual(self.complete("info", "--collision-from", "v"), ["visual"])
        self.assertEqual(self.complete("new", "a.yaml", "--seam", ""), ["line", "arc", "csv"])

    def test_lists_with_commas(self):
        formats = ["krl", "rapid", "ls", "trajectory_msgs", "moveit"]
        for command in ("plan", "smooth"):
            self.assertEqual(self.complete(command, "--export", ""), formats)
        self.assertEqual(self.complete("plan", "--export", "krl,"),
                         ["krl," + name for name in formats[1:]])
        self.assertEqual(self.complete("plan", "--export", "krl,ls,r"), ["krl,ls,rapid"])

    def test_files_by_their_extension(self):
        (self.folder / "a.csv").touch()
        (self.folder / "notes.txt").touch()
        problems = self.complete("plan", "problems/")
        self.assertIn("problems/task_c_wrist_singularity.yaml", problems)
        self.assertNotIn("problems/l_profile.stl", problems)
        self.assertEqual(self.complete("plan", "pr"), ["problems/"])
        self.assertEqual(sorted(self.complete("check", "p.yaml", "")),
                         ["a.csv", "problems/", "robots/"])
        self.assertEqual(self.complete("info", "robots/planar_3r/"),
                         ["robots/planar_3r/planar_3r.urdf"])
        self.assertEqual(self.complete("new", "x.yaml", "--robot", "robots/planar_3r/"),
                         ["robots/planar_3r/planar_3r.urdf"])
        self.assertEqual(self.complete("smooth", "--limits", "robots/planar_3r/"),
                         ["robots/planar_3r/joint_limits.yaml"])
        self.assertEqual(sorted(self.complete("smooth", "--joints", "")),
                         ["a.csv", "problems/", "robots/"])


if __name__ == "__main__":
    unittest.main()
