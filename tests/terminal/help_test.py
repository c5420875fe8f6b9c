"""Help: every example of it runs as it stands, in the order in which it stands."""

import os
import re
import subprocess
import unittest

from program import PROGRAM, SOURCE, ProgramTest, environment, run


def help_of(*arguments):
    status, out, err = run([*arguments, "--help"], "/")
    assert status == 0 and not err, err
    return out.decode()


def commands():
    table = help_of().split("\nCommands\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+) ", table, re.MULTILINE)


def examples(text):
    return re.findall(r"^  (wristwise .*)$", text.split("\nExamples\n")[1].split("\n\n")[0],
                      re.MULTILINE)


class Help(ProgramTest):
    def run_examples(self, lines):
        (self.folder / "bin").mkdir()
        (self.folder / "bin/wristwise").symlink_to(PROGRAM)
        env = environment(PATH=f"{self.folder}/bin:{os.environ['PATH']}")
        for line in lines:
            done = subprocess.run(["bash", "-c", line], cwd=self.folder, env=env,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
            self.assertEqual(done.returncode, 0, line + "\n" + done.stdout.decode())

    def test_commands(self):
        self.assertEqual(commands(),
                         ["new", "plan", "smooth", "check", "compare", "place", "info"])

    def test_the_examples_of_the_program_run(self):
        lines = examples(help_of())
        self.assertGreaterEqual(len(lines), 3)
        self.run_examples(lines)

    def test_says_purpose_usage_examples_exit_status_and_docs(self):
        for command in commands():
            text = help_of(command)
            for heading in ("Usage", "What to do", "Every command", "Examples", "Exit status",
                            "Read on"):
                self.assertIn(f"\n{heading}\n", text, command)
            self.assertGreaterEqual(len(examples(text)), 2, command)
            for page in re.findall(r"docs/\S+\.md", text):
                self.assertTrue((SOURCE / page).is_file(), page)
            for line in text.splitlines():
                if not line.startswith("  wristwise "):
                    self.assertLessEqual(len(line), 80, line)

    def test_the_word_help(self):
        for command in commands():
            status, out, _ = run(["help", command], "/")
            self.assertEqual(status, 0)
            self.assertEqual(out.decode(), help_of(command))
        self.assertEqual(run(["help"], "/")[1].decode(), help_of())


def add_test_of_examples(command):
    setattr(Help, f"test_the_examples_of_{command}_run",
            lambda self: self.run_examples(examples(help_of(command))))


for name in commands():
    add_test_of_examples(name)

if __name__ == "__main__":
    unittest.main()
