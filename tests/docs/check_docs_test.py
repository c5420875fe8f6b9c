"""check_docs_test.py SOURCE BUILD: faults planted into a page must be found, and a page without any
must pass."""

import pathlib
import shutil
import sys
import tempfile
import unittest

import check_docs
import result_keys
from pages import Page

SOURCE = pathlib.Path(sys.argv[1]).resolve()
BUILD = pathlib.Path(sys.argv[2]).resolve()
INFO = "build/wristwise info robots/planar_3r/planar_3r.urdf"


class Planted(unittest.TestCase):
    """A source tree with one page of ours in it."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="wristwise_planted_")
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        for name in ["src", "include", "tests", "problems", "robots", "bootstrap.sh", ".ci"]:
            (self.root / name).symlink_to(SOURCE / name)
        (self.root / "docs").mkdir()
        for name in ["formulation.md", "problem-file.schema.json"]:
            shutil.copy(SOURCE / "docs" / name, self.root / "docs" / name)
        (self.root / "README.md").write_text("# wristwise\n")

    def page(self, text):
        (self.root / "docs/page.md").write_text(text)

    def commands(self, text, language="sh"):
        self.page(f"```{language}\n{text}\n```\n")
        return check_docs.command_faults(self.root, BUILD, ["docs/page.md"])

    def printed(self, sample):
        self.page(f"```sh\n{INFO}\n```\n```console\n{sample}\n```\n")
        return check_docs.command_faults(self.root, BUILD, ["docs/page.md"])

    def of_page(self, faults):
        return [fault for fault in faults if fault.startswith("docs/page.md")]

    def inline(self, text):
        self.page(text)
        return self.of_page(check_docs.inline_faults(self.root, BUILD))

    def references(self, text):
        self.page(text)
        return self.of_page(check_docs.reference_faults(self.root))

    def snippets(self, text):
        self.page(text)
        return self.of_page(check_docs.snippet_faults(self.root))


class Commands(Planted):
    def test_what_works_passes(self):
        self.assertEqual(self.commands(INFO), [])
        self.assertEqual(self.commands("wristwise info robots/planar_3r/planar_3r.urdf"), [])
        self.assertEqual(self.commands(f"{INFO} \\\n  --quiet\nls problems > list.txt"), [])

    def test_what_fails_is_found(self):
        self.assertTrue(self.commands("false"))
        self.assertTrue(self.commands(f"false\n{INFO}"))
        self.assertTrue(self.commands("false | true"))
        self.assertTrue(self.commands(INFO.replace("info", "inform")))
        self.assertTrue(self.commands(INFO.replace("planar_3r.urdf", "planar_4r.urdf")))
        self.assertTrue(self.commands(f"{INFO} --no-such-option"))
        self.assertTrue(self.commands(f"$ {INFO} --no-such-option", "console"))

    def test_exit_status_is_the_one_stated(self):
        wrong = INFO.replace("planar_3r.urdf", "planar_4r.urdf")
        self.assertEqual(self.commands(f"{wrong}   # exit status 2"), [])
        self.assertTrue(self.commands(f"{wrong}   # exit status 1"))
        self.assertTrue(self.commands(f"{INFO}   # exit status 2"))

    def test_by_hand_is_not_run_but_looked_at(self):
        self.assertEqual(self.commands("false   # by hand: as root"), [])
        self.assertTrue(self.commands(f"{INFO} --no-such-option   # by hand"))
        self.assertTrue(self.commands("build/tests/no_benchmark   # by hand"))
        self.assertTrue(self.commands(
            "build/tests/graph_benchmark --benchmark_filter=NoSuch   # by hand"))
        self.assertTrue(self.commands(f"{INFO} \\\n  --no-such-option   # by hand"))

    def test_bootstrap_is_what_ci_runs(self):
        self.assertEqual(self.commands("./bootstrap.sh && true"), [])
        self.assertTrue(self.commands("./bootstrap.sh && false"))
        self.assertTrue(self.commands("./bootstrap.sh everything"))
        of_ci = (SOURCE / ".ci/run").read_text().strip().splitlines()[-1]
        self.assertEqual(self.commands(of_ci), [])
        self.assertTrue(self.commands(of_ci.replace("ctest", "no_such_ctest")))

    def test_samples_are_what_is_printed(self):
        self.assertEqual(self.printed("planar_3r: base_link to ...\n...\nbodies\n..."), [])
        self.assertTrue(self.printed("planar_4r: base_link to ..."))
        self.assertTrue(self.printed("bodies\n...\nplanar_3r: base_link to ..."))
        self.assertTrue(self.printed("planar_3r: base_link to torch_tip, 4 joints"))
        self.assertEqual(self.commands(f"$ {INFO}\nplanar_3r: ...", "console"), [])
        self.assertTrue(self.commands(f"$ {INFO}\nplanar_4r: ...", "console"))

    def test_files_with_a_name_are_written(self):
        def faults(first_line):
            self.page(f"```yaml\n{first_line}\ngraph: {{seeds: 2}}\n```\n"
                      "```sh\ngrep -q 'seeds: 2' my/part.yaml\n```\n")
            return check_docs.command_faults(self.root, BUILD, ["docs/page.md"])
        self.assertEqual(faults("# my/part.yaml"), [])
        self.assertTrue(faults("# my/other.yaml"))

    def test_nothing_is_written_into_the_source(self):
        before = sorted((SOURCE / "problems").iterdir())
        self.assertEqual(self.commands("touch problems/new.yaml"), [])
        self.assertEqual(sorted((SOURCE / "problems").iterdir()), before)


class Inline(Planted):
    def test_what_exists_passes(self):
        self.assertEqual(self.inline("`wristwise plan problems/planar_3r.yaml --no-report`"), [])
        self.assertEqual(self.inline("`graph_benchmark --benchmark_filter=KnownGraph`"), [])
        self.assertEqual(self.inline("`acceptance/placement_test`, `ctest -R docs.references`, `--mode`"), [])
        self.assertEqual(self.inline("```text\nwristwise plan P.yaml\n     [--mode graph-only]\n```"), [])

    def test_sections_of_benchmarks_have_a_command(self):
        def faults(text):
            (self.root / "docs/benchmarks.md").write_text(f"# Benchmarks\n## One\n{text}\n")
            return check_docs.inline_faults(self.root, BUILD)
        self.assertEqual(faults("`graph_benchmark` takes 1 s"), [])
        self.assertTrue(faults("`it` takes 1 s"))
        self.assertTrue(faults("`graph_benchmark` takes 1 s\n## Two\n2 s"))

    def test_what_does_not_is_found(self):
        for text in ["wristwise plan problems/planar_4r.yaml", "wristwise plan --no-reports",
                     "time build/wristwise --threads 1 planned", "--no-reports", "wristwise draw",
                     "graph_benchmark --benchmark_filter=NoSuch", "no_such_benchmark",
                     "random_seams_report --seeds 1", "acceptance/no_such_test", "no_such_test",
                     "ctest --test-dir build -R no_such_test", "tests/no_such.py a"]:
            with self.subTest(text):
                self.assertTrue(self.inline(f"| a | `{text}` |"))
        self.assertTrue(self.inline("```text\nwristwise plan P.yaml\n     [--modes graph-only]\n```"))


class References(Planted):
    def test_what_exists_passes(self):
        self.assertEqual(self.references(
            "# A page\n[a](#a-page) [b](../README.md#wristwise) [c](https://example.org) (F3) "
            "`src/plan.cpp`, `src/task/{pose,seam}.cpp`, `src/io/*_section.cpp`, `plan.cpp`, "
            "`CostOptions::vertex_cost`, `[x](y.md)`"), [])

    def test_what_does_not_is_found(self):
        for text in ["[a](no_such.md)", "[a](#no-such)", "[a](../README.md#no-such)",
                     "![a](pictures/no_such.svg)", "`src/no_such.cpp`", "`src/task/{pose,no}.cpp`",
                     "`no_such.cpp`", "(F999)", "`CostOptions::no_such`", "`NoSuch::cost`"]:
            with self.subTest(text):
                self.assertEqual(len(self.references(f"# A page\n{text}\n")), 1)

    def test_formulas_have_code_and_test(self):
        page = self.root / "docs/formulation.md"
        text = page.read_text()
        for old, new in [("### (F9) ", "### (F999) "), ("Code: `src/", "In `src/"), ("| F9 |", "| F8 |")]:
            page.write_text(text.replace(old, new, 1))
            with self.subTest(old):
                self.assertTrue(check_docs.reference_faults(self.root))
        page.write_text(text)
        self.assertEqual(self.references("# A page"), [])

    def test_drawings_are_small_xml(self):
        drawing = self.root / "docs/a.svg"
        for content, faults in [("<svg/>", 0), ("<svg>", 1), (f"<svg>{'a' * 70000}</svg>", 1)]:
            drawing.write_text(content)
            self.assertEqual(len(self.references("![a](a.svg)")), faults)



class Architecture(Planted):
    """With sources of its own, so that the real ones may change."""

    def setUp(self):
        super().setUp()
        for name in ["src", "tests"]:
            (self.root / name).unlink()
        for name, text in [("src/task/pose.cpp", ""), ("src/task/seam.cpp", ""), ("tests/a.cpp", ""),
                           ("src/app/main.cpp", "#include <CLI/CLI.hpp>\n"),
                           ("src/verify/check.cpp", '#include "task/pose.hpp"\n')]:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text)

    def faults(self, row):
        (self.root / "docs/architecture.md").write_text(f"{row}\n")
        return [fault for fault in check_docs.reference_faults(self.root)
                if fault.startswith("docs/architecture.md")]

    def test_names_in_folders(self):
        self.assertEqual(self.faults("| `src/task/` | pose (`pose`, `sea*`) |"), [])
        self.assertEqual(len(self.faults("| `src/task/` | pose (`pose`, `no_such`) |")), 1)

    def test_libraries(self):
        self.assertEqual(self.faults("| CLI11 | `src/app/main.cpp`, `tests/` | a |"), [])
        self.assertEqual(self.faults("| CLI11 | `src/task/pose.cpp`, `src/{app,task}/*.cpp` | a |"), [])
        self.assertTrue(self.faults("| CLI11 | `tests/` | a |"))
        self.assertTrue(self.faults("| Ceres | `src/refine/spline_solver.cpp` | a |"))

    def test_the_check_includes_nothing_of_what_it_checks(self):
        self.assertEqual(self.faults("| a | b |"), [])
        (self.root / "src/verify/check.cpp").write_text('#include "graph/rung.hpp"\n')
        self.assertEqual(len(self.faults("| a | b |")), 1)


class Snippets(Planted):
    def test_what_is_right_passes(self):
        self.assertEqual(self.snippets(
            "```yaml\npath:\n  speed: 10 mm/s\n  run_in: 10 mm\n```\n"
            "```yaml\ngraph:\n  samples: {rz: 10 deg}\n  ...\n```\n"
            "```json\n{\"a\": 1}\n```\n```xml\n<a/><b/>\n```\n`path.run_in`, `graph.first_turns`"), [])

    def test_what_is_wrong_is_found(self):
        for text in ["```yaml\npath:\n  no_such_key: 1\n```", "```yaml\nno_such_section: 1\n```",
                     "```yaml\npath: {\n```", "```yaml\npath: {segments: [{line: {form: 1}}]}\n```",
                     "```json\n{a: 1}\n```", "```xml\n<a>\n```", "```cpp\nint no_such_code();\n```",
                     "```\nwithout a language\n```", "`path.no_such`"]:
            with self.subTest(text):
                self.assertEqual(len(self.snippets(text)), 1)

    def test_code_of_examples_passes(self):
        example = sorted((SOURCE / "docs/examples").glob("*.cpp"))[0].read_text()
        (self.root / "docs/examples").symlink_to(SOURCE / "docs/examples")
        self.assertEqual(self.snippets(f"```cpp\n{example}```"), [])
        self.assertTrue(self.snippets(f"```cpp\n{example.replace('main(', 'mane(')}```"))


class Defaults(Planted):
    def setUp(self):
        super().setUp()
        shutil.copy(SOURCE / "docs/problem-file.md", self.root / "docs")

    def faults_with(self, file, old, new):
        text = (SOURCE / "docs" / file).read_text()
        self.assertEqual(text.count(old), 1, old)
        (self.root / "docs" / file).write_text(text.replace(old, new))
        return check_docs.default_faults(self.root, BUILD)

    def test_what_is_used_is_stated(self):
        self.assertEqual(check_docs.default_faults(self.root, BUILD), [])

    def test_other_defaults_are_found(self):
        row = "| `smoothing_time` | s | 2.5 |"
        self.assertEqual(len(self.faults_with("problem-file.md", row, row.replace("2.5", "2.4"))), 1)
        shutil.copy(SOURCE / "docs/problem-file.md", self.root / "docs")
        for old, new in [('"default": "$OUT[1]=TRUE"', '"default": "$OUT[2]=TRUE"'),
                         ('"default": 2.5', '"default": 2.4'), ('"default": "4 ms"', '"default": "5 ms"')]:
            with self.subTest(old):
                self.assertTrue(self.faults_with("problem-file.schema.json", old, new))


class ResultKeys(Planted):
    def faults(self, text):
        (self.root / "docs/results.md").write_text(text)
        keys = {"status", "refine.rounds", "refine.terms.name", "peaks.JOINT.jerk"}
        return result_keys.faults(Page(self.root, "docs/results.md"), keys)

    def test_each_key_is_described(self):
        text = ("## result.json\n| `status` | | a |\n| `refine.rounds`, `refine.terms.name` | | b |\n"
                "| `peaks.JOINT.jerk` | | c |\n")
        self.assertEqual(self.faults(text), [])
        self.assertEqual(len(self.faults(text.replace("`refine.rounds`, ", ""))), 1)
        self.assertEqual(len(self.faults(text.replace("`status`", "`status`, `state`"))), 1)

    def test_keys_of_a_result(self):
        result = {"a": {"q1": {"x": 1}}, "list": [{"b": 1}, {"c": []}], "none": None}
        self.assertEqual(result_keys.keys_of(result, "", {"q1"}),
                         {"a.JOINT.COORDINATE", "list.b", "list.c", "none"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
