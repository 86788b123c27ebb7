"""What scripts/instruction-counts says of counts that have grown, without counting any."""

import contextlib
import importlib.machinery
import importlib.util
import io
import pathlib
import subprocess
import tempfile
import tomllib
import unittest
from unittest import mock

SCRIPT = pathlib.Path(__file__).resolve().parent.parent / "scripts" / "instruction-counts"


def load_script():
    loader = importlib.machinery.SourceFileLoader("instruction_counts", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    with mock.patch("sys.dont_write_bytecode", True):
        loader.exec_module(module)
    return module


def outcome_of(function):
    """What it returns, or what it exits with: a code or a message."""
    try:
        return function()
    except SystemExit as end:
        return end.code


script = load_script()
RECORDED = {"sphere": 1000, "terrain": 2000, "sheets": 3000}


class InstructionCounts(unittest.TestCase):
    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        self.record = pathlib.Path(folder) / "record.toml"
        self.record.write_text(script.record_text("g++ 12", RECORDED))
        self.enterContext(mock.patch.object(script, "RECORD", self.record))

    def run_script(self, counts, *options, compiler="g++ 12"):
        """The exit code or message, and what is printed, where the counts are these."""
        printed = io.StringIO()
        with (mock.patch.object(script, "compiler_of", lambda build: compiler),
              mock.patch.object(script, "count_all", lambda build: counts),
              mock.patch("sys.argv", ["instruction-counts", *options]), contextlib.redirect_stdout(printed)):
            return outcome_of(script.main) or 0, printed.getvalue()

    def test_growth_up_to_5_percent_and_any_decrease_pass_silently(self):
        for terrain in (20, 2000, 2080, 2100):
            code, printed = self.run_script(RECORDED | {"terrain": terrain})
            self.assertEqual(code, 0)
            self.assertNotRegex(printed, "WARNING|FAILURE")

    def test_growth_over_5_percent_warns(self):
        for terrain in (2101, 2120, 2300):
            code, printed = self.run_script(RECORDED | {"terrain": terrain})
            self.assertEqual(code, 0)
            self.assertRegex(printed, r"terrain .* WARNING: over 5 %")
            self.assertEqual(printed.count("WARNING"), 1)

    def test_growth_over_15_percent_fails_whatever_the_others_do(self):
        for terrain in (2301, 2320, 9000):
            code, printed = self.run_script({"sphere": 10, "terrain": terrain, "sheets": 3180})
            self.assertEqual(code, 1)
            self.assertRegex(printed, r"terrain .* FAILURE: over 15 %")
            self.assertRegex(printed, r"sheets .* WARNING: over 5 %")

    def test_counts_of_another_compiler_are_not_compared(self):
        code, printed = self.run_script(RECORDED | {"terrain": 9000}, compiler="g++ 13")
        self.assertEqual(code, 0)
        self.assertIn("9,000", printed)
        self.assertIn("Not compared: the record is of g++ 12, these are of g++ 13", printed)
        self.assertNotRegex(printed, "WARNING|FAILURE")

    def test_record_makes_the_counts_the_record(self):
        counts = RECORDED | {"terrain": 9000}
        code, _ = self.run_script(counts, "--record", compiler='g++ "13"')
        self.assertEqual(code, 0)
        self.assertEqual(tomllib.loads(self.record.read_text()), {"compiler": 'g++ "13"', "instructions": counts})

    def test_without_a_record_or_with_one_of_other_scenes_the_script_fails(self):
        self.assertIn("other scenes", self.run_script({"sphere": 1000})[0])
        self.record.unlink()
        self.assertIn("is missing", self.run_script(RECORDED)[0])

    def test_the_count_is_what_valgrind_collected_and_nothing_collected_fails(self):
        self.assertEqual(self.count_from(0, "==7== Events    : Ir\n==7== Collected : 123\n==7== \n"), 123)
        self.assertIn("nothing was counted", self.count_from(0, "==7== Collected : 0\n"))
        self.assertIn("nothing was counted", self.count_from(2, "==7== Collected : 123\n"))
        self.assertIn("nothing was counted", self.count_from(0, "valgrind: no such tool\n"))

    def count_from(self, code, errors):
        run = subprocess.CompletedProcess([], code, "", errors)
        with mock.patch("subprocess.run", return_value=run):
            return outcome_of(lambda: script.count(pathlib.Path("build"), "sphere"))

    def test_without_valgrind_the_script_fails(self):
        with mock.patch("shutil.which", return_value=None):
            self.assertIn("valgrind is missing", outcome_of(lambda: script.count_all(pathlib.Path("build"))))


if __name__ == "__main__":
    unittest.main()
