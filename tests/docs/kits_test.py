"""tools/kits.py runs the kits whose inputs have changed and no others, in a folder that is made for it.

usage: python3 tests/docs/kits_test.py
"""
import contextlib
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
# pylint: disable=wrong-import-position
import kits


class Made(unittest.TestCase):
    """Two kits in a repository of their own. Each leaves a letter in ran.txt, which git ignores."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        table = {name: kits.Kit(f"the kit {name}", f"./{name}.sh", f"{name}.sh {name}") for name in ("a", "b")}
        for patch in (mock.patch.object(kits, "ROOT", self.root), mock.patch.object(kits, "STAMPS", "stamps"),
                      mock.patch.object(kits, "KITS", table), mock.patch.dict(os.environ, MARROW_PROGRAM="none")):
            patch.start()
            self.addCleanup(patch.stop)
        for name in "ab":
            self.script(name)
            self.write(f"{name}/deep/input", "1")
        self.write(".gitignore", "ran.txt\n*.log\nbuild/\n")
        subprocess.run(["git", "init", "-q"], cwd=self.root, check=True)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def script(self, name, code=0, then=""):
        self.write(f"{name}.sh", f"#!/bin/sh\nprintf {name} >>ran.txt\n{then}\nexit {code}\n").chmod(0o755)

    def call(self, *words):
        """(exit code, which kits ran, what was said)."""
        ran = self.write("ran.txt", "")
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            try:
                code = kits.main(list(words))
            except SystemExit as stop:
                code = stop.code
        return code, ran.read_text(), said.getvalue()

    def passed(self, *words):
        code, ran, said = self.call(*words)
        self.assertEqual(code, 0, said)
        return ran

    def test_what_has_not_changed_does_not_run(self):
        self.assertEqual(self.passed("run"), "ab")
        self.assertEqual(self.passed("run"), "")
        self.assertEqual(self.passed("--all", "b"), "b")
        self.assertEqual([line.split()[0] for line in (self.root / "stamps").read_text().splitlines()], ["a", "b"])

    def test_each_change_of_an_input_counts(self):
        changes = {
            "its bytes": lambda: self.write("a/deep/input", "2"),
            "a new file": lambda: self.write("a/other", "1"),
            "its name": lambda: (self.root / "a/other").rename(self.root / "a/another"),
            "its absence": lambda: (self.root / "a/another").unlink(),
            "who may run it": lambda: (self.root / "a/deep/input").chmod(0o755),
            "the script": lambda: self.script("a", then="true"),
            "the command": lambda: kits.KITS["a"].command.append("more"),
            "the list": lambda: kits.KITS["a"].inputs.append("b"),
        }
        self.passed("run")
        for what, change in changes.items():
            with self.subTest(what):
                change()
                self.assertEqual(self.passed("run"), "a")
                self.assertEqual(self.passed("run"), "")

    def test_what_git_ignores_does_not_count(self):
        self.passed("run")
        self.write("a/made.log", "1")
        self.write("elsewhere", "1")
        self.assertEqual(self.passed("run"), "")

    def test_a_kit_that_fails_has_no_stamp(self):
        self.passed("run")
        self.script("a", code=1)
        for _ in range(2):
            code, ran, said = self.call("run")
            self.assertEqual((code, ran), (1, "a"))
            self.assertRegex(said, r"a +FAILED, 1 +\d+ s")
        # The stamp from before is of what was before.
        self.script("a")
        self.assertEqual(self.passed("run"), "")

    def test_others_run_beside_one_that_fails(self):
        self.script("a", code=2)
        self.assertEqual(self.call("run")[:2], (1, "ab"))
        self.assertEqual(self.call("run")[:2], (1, "a"))

    def test_a_kit_that_is_skipped_has_no_stamp(self):
        self.script("a", code=3)
        for wanted in ("ab", "a"):
            code, ran, said = self.call("run")
            self.assertEqual((code, ran), (0, wanted))
            self.assertIn("SKIPPED", said)
        self.assertNotIn("a ", (self.root / "stamps").read_text())

    def test_an_input_that_is_not_there_is_an_error(self):
        kits.KITS["b"].inputs.append("gone/file")
        code, _, said = self.call("run")
        self.assertEqual(code, 2)
        self.assertIn("gone/file", said)

    def test_without_git_every_kit_runs(self):
        self.passed("run")
        (self.root / ".git").rename(self.root / "no.git")
        (self.root / "stamps").unlink()
        for _ in range(2):
            code, ran, said = self.call("run")
            self.assertEqual((code, ran), (0, "ab"))
            self.assertIn("no git", said)
        self.assertFalse((self.root / "stamps").exists())

    def test_wrong_calls(self):
        for words in ((), ("walk",), ("run", "c"), ("trace",)):
            self.assertEqual(self.call(*words)[:2], (2, ""), words)

    def test_a_trace_finds_what_is_no_input(self):
        if subprocess.run(["strace", "-o", "/dev/null", "true"], capture_output=True, check=False).returncode != 0:
            self.skipTest("strace is not here, or may not trace")
        self.script("a", then="cd a/deep; cat input >/dev/null; cat ../../ran.txt >/dev/null")
        self.assertEqual(self.passed("trace", "a"), "a")
        self.script("a", then="cd a/deep; cat ../../b/deep/input >/dev/null")
        code, _, said = self.call("trace", "a")
        self.assertEqual(code, 1)
        self.assertIn("a: opens b/deep/input", said)


class Table(unittest.TestCase):
    def test_inputs_are_there_and_every_script_is_one(self):
        for name, kit in kits.KITS.items():
            self.assertTrue(kit.what and name.isidentifier())
            self.assertIn(kit.command[0], kit.inputs, name)
            for path in kit.inputs:
                self.assertTrue(any(kits.ROOT.glob(path)), f"{name}: {path}")

    def test_every_check_of_a_kit_is_in_it(self):
        others = {"docs.sh", "export.sh", "three.sh"}  # run by tools/test.sh and by ctest
        scripts = {path.name for path in (kits.ROOT / "tools/check").glob("*.sh")} - others
        commands = {pathlib.Path(kit.command[0]).name for kit in kits.KITS.values()}
        self.assertEqual(scripts - commands, set())


if __name__ == "__main__":
    unittest.main()
