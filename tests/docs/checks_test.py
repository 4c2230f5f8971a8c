"""What checks the manual finds each kind of fault in small pages that are made for it, and none in good ones.

usage: python3 tests/docs/checks_test.py
"""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/docs"))
# pylint: disable=wrong-import-position
import api_comments
import blocks
import commands
import figures
import links
import pages
import prose
import snippets


class Made(unittest.TestCase):
    """In a folder of its own, which the tools take for the sources'."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for module in (api_comments, blocks, pages):
            patch = mock.patch.object(module, "ROOT", self.root)
            patch.start()
            self.addCleanup(patch.stop)
        snippets.sources.cache_clear()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def run_main(self, tool, *arguments):
        """(exit code or its text, what it says)."""
        said = io.StringIO()
        with mock.patch.object(sys, "argv", [tool.__name__, *map(str, arguments)]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            try:
                code = tool.main()
            except SystemExit as stop:
                code = stop.code
        return code, said.getvalue()


class Blocks(Made):
    def test_text_line_language_and_excuse(self):
        page = self.write("docs/a.md", "# A\n\n```sh\nls\n```\n\n<!-- not run: it is slow -->\n```cpp\nint a;\n```\n"
                                       "- In a list:\n\n  ```c\n  int b;\n    int c;\n  ```\n\n```\nnothing\n```\n")
        found = [(b.line, b.language, b.text, b.excuse) for b in blocks.blocks(page)]
        self.assertEqual(found, [(3, "sh", "ls\n", ""), (8, "cpp", "int a;\n", "it is slow"),
                                 (13, "c", "int b;\n  int c;\n", ""), (18, "", "nothing\n", "")])

    def test_pages_and_who_runs_them(self):
        readme, page = self.write("README.md", ""), self.write("docs/deep/a.md", "")
        check = self.write("tools/check/a.sh", "blocks sh docs/deep/a.md\n")
        self.assertEqual(blocks.pages([]), [readme, page])
        self.assertEqual(blocks.pages([str(page)]), [page])
        self.assertEqual([blocks.run_by(readme), blocks.run_by(page)], [None, check])


class Snippets(Made):
    def setUp(self):
        super().setUp()
        self.write("tests/a.cpp", "int main() {\n  first();\n  second();\n  third();\n}\n")

    def found_in(self, language, text, before=""):
        return self.run_main(snippets, self.write("docs/a.md", f"{before}```{language}\n{text}```\n"))

    def test_what_stands_in_a_file(self):
        for text in ("first();\nsecond();\n", "    first();\n    second();\n", "first();\n…\nthird();\n",
                     "first();\n// …\n}\n"):
            self.assertEqual(self.found_in("cpp", text), (0, ""), text)

    def test_what_does_not(self):
        for text in ("fourth();\n", "first();\nthird();\n", "second();\n…\nfirst();\n", "first(); second();\n",
                     "irst();\n"):
            code, said = self.found_in("cpp", text)
            self.assertEqual(code, 1, text)
            self.assertIn("docs/a.md:1: in no file of the tests", said)
        self.assertEqual(self.found_in("python", "first();\n")[0], 1)  # of another language

    def test_what_is_left_out(self):
        self.assertEqual(self.found_in("cpp", "fourth();\n", "<!-- not run: a sketch -->\n"), (0, ""))
        self.assertEqual(self.found_in("text", "fourth();\n"), (0, ""))
        self.write("tools/check/a.sh", "docs/a.md")
        self.assertEqual(self.found_in("cpp", "fourth();\n"), (0, ""))


class Commands(Made):
    def ran(self, text):
        files = self.root / "files"
        files.mkdir(exist_ok=True)
        (files / "hero.glb").write_text("hero\n")
        return commands.run_page("/nowhere/marrow", self.write("docs/a.md", text), files)

    def test_what_fails(self):
        failures, count, _ = self.ran("```sh\ntrue\necho why >&2; exit 3\n```\n\n```sh\ntest -e absent\n```\n")
        self.assertEqual(count, 3)
        self.assertEqual(failures, ["docs/a.md:1: exit code 3: echo why >&2; exit 3\n  why",
                                    "docs/a.md:6: exit code 1: test -e absent\n  "])

    def test_what_does_not(self):
        failures, count, _ = self.ran("```sh\n# a remark\n\ngrep -q hero hero.glb\necho a \\\n  b >b.txt\n```\n\n"
                                      "```sh\ngrep -q 'a b' b.txt\n```\n\n```cpp\nfalse\n```\n\n"
                                      "<!-- not run: it fails -->\n```sh\nfalse\n```\n")
        self.assertEqual((failures, count), ([], 3))

    def test_each_page_has_a_folder_of_its_own(self):
        self.assertEqual(self.ran("```sh\ntouch mine\n```\n")[0], [])
        self.assertEqual(len(self.ran("```sh\ntest -e mine\n```\n")[0]), 1)


class Misspelt(Made):
    """Commands that are not run, of a program that has one command with two options."""

    def found(self, command):
        self.write("marrow", "#!/bin/sh\n[ \"$1 $2\" = 'cook --help' ] && printf 'cook\\n  -o,--output F   a file; not --in\\n  --lod N\\n'\n")
        (self.root / "marrow").chmod(0o755)
        commands.options_of.cache_clear()
        text = f"<!-- not run: it is slow -->\n```sh\n# marrow eat\nls --lods\n{command}\n```\n\n```sh\nmarrow run\n```\n"
        return commands.misspelt(str(self.root / "marrow"), self.write("docs/a.md", text))

    def test_what_is_refused(self):
        for command, unknown in (("marrow cook a --lods 1", "--lods"), ("marrow cook \\\n  -p=1", "-p"),
                                 ("marrow cook --in a -o b", "--in"), ("marrow bake a --lod 1", "marrow bake")):
            found = self.found(command)
            self.assertEqual(len(found), 1, command)
            self.assertTrue(found[0].startswith(f"docs/a.md:2: no such {unknown}: marrow "), found)

    def test_what_is_not(self):
        for command in ("marrow cook a -o b --lod -1 --output=c", "marrow cook 'a --lods' # --lods", "marrow --version"):
            self.assertEqual(self.found(command), [], command)


class Links(Made):
    def dead(self, body, name="index.html"):
        path = self.write(f"site/{name}", f"<h1 id='here'>A</h1>{body}")
        code, said = self.run_main(links, self.root / "site")
        path.unlink()
        return code, said

    def setUp(self):
        super().setUp()
        self.write("site/b/index.html", "<h2 id='there'>B</h2><a name='old'></a>")
        self.write("site/a picture.png", "")

    def test_what_leads_nowhere(self):
        for link in ("c.html", "b/#where", "b/index.html#where", "#where", "../b/index.html", "b/c.png"):
            code, said = self.dead(f"<a href='{link}'>x</a>")
            self.assertEqual((code, said), (1, f"index.html: {link}: leads nowhere\n"), link)
        self.assertEqual(self.dead("<img src='absent.png'>")[0], 1)

    def test_what_leads_somewhere(self):
        for link in ("b/", "b/#there", "b/index.html#old", "#here", "#", "a%20picture.png", "https://example.org/x",
                     "mailto:a@b", "//example.org"):
            self.assertEqual(self.dead(f"<a href='{link}'>x</a>"), (0, ""), link)
        self.assertEqual(self.dead("<a href='absent'>x</a>", "404.html"), (0, ""))


class Prose(Made):
    KNOWN = {"runs", "stands", "is"}

    def measured(self, text):
        page, said = self.write("a.md", text), io.StringIO()
        with contextlib.redirect_stdout(said):
            return prose.check(page, self.KNOWN, True), said.getvalue()

    def test_good_prose(self):
        good, said = self.measured("# Title without any\n\nIt runs. A [link](to/a/page.md) stands\nhere.\n\n"
                                   "| a table of things | x |\n|---|---|\n| " + "wide " * 40 + "|\n\n"
                                   "```sh\n" + "no prose here, " * 6 + "\n```\n\n- **Item.** It is one.\n")
        self.assertTrue(good, said)
        self.assertIn("4 words", self.measured("It runs. It stands.\n")[1])

    def test_sentences_too_long(self):
        self.assertTrue(self.measured("It runs" + " on" * 13 + ".\n")[0])
        self.assertFalse(self.measured("It runs" + " on" * 14 + ".\n")[0])
        self.assertTrue(self.measured("It runs " + "on and " * 6 + "on. It is.\n")[0])  # in the mean
        self.assertIn("1 over 30", self.measured("It runs " + "on and " * 15 + "on.\n")[1])

    def test_no_verb(self):
        for text in ("It runs. Nothing in here.\n", "- It runs.\n- Nothing in here\n",
                     "It runs.\n\nNothing\nin here\n"):
            good, said = self.measured(text)
            self.assertFalse(good, text)
            self.assertIn("1 without a verb", said)
            self.assertIn("no verb: Nothing in here", said)

    def test_wide_lines(self):
        wide = "It runs. " * 14
        good, said = self.measured(f"It runs.\n\n{wide}\n")
        self.assertFalse(good)
        self.assertIn("a.md:3: wide", said)
        self.assertTrue(self.measured(wide[:119] + "\n")[0])

    def test_verbs(self):
        self.write("index.verb", "  1 a licence\ntry v 1\nmake v 1\nstop v 1\npick_up v 1\n")
        self.write("verb.exc", "ran run\n")
        with mock.patch.object(prose, "WORDNET", self.root):
            known = prose.verbs()
            forms = {"tries", "tried", "trying", "makes", "making", "stops", "stopped", "stopping", "ran", "is"}
            self.assertEqual(forms - known, set())
            self.assertNotIn("pick_up", known)
            page = self.write("bad.md", "Nothing in here.\n")
            self.assertEqual(self.run_main(prose, page)[0], 1)
            self.assertEqual(self.run_main(prose, self.write("good.md", "It tries.\n"))[0], 0)
        with mock.patch.object(prose, "WORDNET", self.root / "absent"):
            self.assertEqual(self.run_main(prose, page)[0], 3)


class Pages(Made):
    def setUp(self):
        super().setUp()
        self.write("tools/docs/mkdocs.yml", "nav:\n  - a.md\n  - deep/b.md\n")
        self.write("tools/docs/site.css", "")
        self.write("docs/a.md", "")
        self.write("docs/deep/b.md", "")
        self.write("docs/images/c.png", "picture")
        self.write("runtime/include/marrow/draw_it.h", "")
        self.write("tools/d.sh", "echo d\n")

    def made(self, text):
        self.write("docs/deep/b.md", text)
        code, said = self.run_main(pages, self.root / "out")
        return code or (self.root / "out/deep/b.md").read_text()

    def test_where_links_lead(self):
        self.write("README.md", "[a](docs/a.md#x)")
        for link, leads in {"../a.md": "../a.md", "../a.md#x": "../a.md#x", "../../README.md": "../index.md",
                            "../../runtime/include/marrow/draw_it.h": "../api/draw__it_8h.html",
                            "../../tools/d.sh": "../source/tools/d.sh.txt", "../images/c.png": "../images/c.png",
                            "https://example.org": "https://example.org", "#x": "#x"}.items():
            self.assertEqual(self.made(f"See [it]({link})."), f"See [it]({leads}).")
        self.assertEqual(self.made("See [it](../../tools)."), "See it.")
        self.assertEqual(self.made("```\n[it](absent.md)\n```\n"), "```\n[it](absent.md)\n```\n")
        self.made("[it](../../tools/d.sh)")
        self.assertEqual((self.root / "out/source/tools/d.sh.txt").read_text(), "echo d\n")
        self.assertEqual((self.root / "out/images/c.png").read_text(), "picture")
        self.assertEqual((self.root / "out/index.md").read_text(), "[a](a.md#x)")

    def test_what_is_refused(self):
        self.assertEqual(self.made("[it](absent.md)"), "docs/deep/b.md: there is no absent.md")
        self.assertEqual(self.made("![it](../images/absent.png)"), "docs/deep/b.md: there is no ../images/absent.png")
        self.write("docs/deep/new.md", "")
        self.assertEqual(self.made(""), "docs/deep/new.md is not in tools/docs/mkdocs.yml")


class ApiComments(Made):
    def test_a_header(self):
        text = api_comments.convert("bounds", """// Boxes of a mesh. More of <them>.
#pragma once

namespace marrow {

// What it has.
struct Box {
  int a = 0, b = 1;                      // of both
  const char* text = "no // comment";    // text,
                                         // and more
};

// Makes one.
MARROW_API void make(Box& box);
MARROW_API void make(Box& box, int a);

}  // namespace marrow
""")
        self.assertEqual([line.rstrip() for line in text[:text.index("/// @}")].split("\n")], [
            "/// @file", "/// @brief Boxes of a mesh.", "",
            "/// @defgroup header_bounds bounds.h: Boxes of a mesh", "/// @ingroup skinning",
            "/// Boxes of a mesh. More of \\<them>.", "#pragma once", "",
            "namespace marrow {", "/// @addtogroup header_bounds", "/// @{", "",
            "/// What it has.", "struct Box {", "/// of both", "  int a = 0;", "/// of both", "  int b = 1;",
            "/// text,", "/// and more", '  const char* text = "no // comment";', "};", "",
            "/// Makes one.", "MARROW_API void make(Box& box);",
            "/// Makes one.", "MARROW_API void make(Box& box, int a);", "", ""])

    def test_plain_text(self):
        self.assertEqual(api_comments.as_text("a@b @c \\d <e> #f `<g> @h`"),
                         "a@b \\@c \\\\d \\<e> \\#f `<g> @h`")

    def test_stages_and_headers(self):
        names = [name for _, headers in api_comments.STAGES.values() for name in headers.split()]
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            self.write(f"runtime/include/marrow/{name}.h", "")
        code, said = self.run_main(api_comments, "--inputs", self.root / "stages.dox")
        self.assertEqual((code, len(said.split())), (None, 1 + len(names)))
        self.assertIn("@defgroup poses Poses", (self.root / "stages.dox").read_text())
        self.write("runtime/include/marrow/brand_new.h", "")
        code, _ = self.run_main(api_comments, "--inputs", self.root / "stages.dox")
        self.assertIn("differ in ['brand_new']", code)
        (self.root / "runtime/include/marrow/brand_new.h").unlink()
        (self.root / "runtime/include/marrow/pose.h").unlink()
        self.assertIn("differ in ['pose']", self.run_main(api_comments, "--inputs", self.root / "stages.dox")[0])


class Figures(Made):
    def test_each_stands_in_a_page_that_is_linked(self):
        self.write("docs/measured.md", "| a | 0.29 | 16 304 |\n\nThe median is 0.47.\n")
        readme = "# A\n\n## What it costs\n\n| what | ratio | when |\n|---|---|---|\n| a | 0.29, {} | 2026 |\n" \
                 "| code | 16 304 bytes | |\n\n[Measured](docs/measured.md)\n\n## More\n\n| b | 7 |\n"
        self.write("README.md", readme.format("0.47"))
        self.assertEqual(self.run_main(figures), (0, ""))
        self.write("README.md", readme.format("0.48"))
        self.assertEqual(self.run_main(figures), (1, "README.md: a: 0.48 stands in none of docs/measured.md\n"))


if __name__ == "__main__":
    unittest.main()
