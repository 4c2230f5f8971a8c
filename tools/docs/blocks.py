"""Fenced blocks of code in the manual's pages."""
import dataclasses
import pathlib
import re
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Block:
    page: pathlib.Path
    line: int
    language: str
    text: str
    excuse: str  # of a block that nothing runs: why


def pages(names):
    if names:
        return [pathlib.Path(name).resolve() for name in names]
    return [p for p in (ROOT / "README.md", ROOT / "CONTRIBUTING.md") if p.exists()] + sorted(ROOT.glob("docs/**/*.md"))


def blocks(page):
    """The page's blocks, in order. A comment `<!-- not run: why -->` on the line before one is its excuse."""
    text = page.read_text()
    for match in re.finditer(r"^( *)```(\w*)[^\n]*\n(.*?)^\1```", text, flags=re.S | re.M):
        before = text[:match.start()].rstrip("\n").rsplit("\n", 1)[-1]
        excuse = re.fullmatch(r"\s*<!-- not run: (.*) -->\s*", before)
        yield Block(page, text.count("\n", 0, match.start()) + 1, match.group(2), textwrap.dedent(match.group(3)),
                    excuse.group(1) if excuse else "")


def run_by(page):
    """The check that takes programs and commands out of this page itself, if there is one."""
    name = str(page.relative_to(ROOT))
    return next((check for check in sorted((ROOT / "tools/check").glob("*.sh")) if name in check.read_text()), None)
