#!/usr/bin/env python3
"""Copies the manual's pages to where the site is built from, with links that hold there.

usage: tools/docs/pages.py FOLDER

README.md becomes index.md. Where tools/web.sh has built the page of the sample, a comment `<!-- play PART: STATE -->` becomes
that page in a frame, with what its link calls STATE. A link to a public header leads to its page of the API reference, one to another file of the
sources to its text.
"""
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOP = {"README.md": "index.md", "CHANGELOG.md": "CHANGELOG.md", "CONTRIBUTING.md": "CONTRIBUTING.md", "THIRD_PARTY.md": "THIRD_PARTY.md"}
SOURCES = {".cpp", ".h", ".c", ".rs", ".cs", ".ts", ".mjs", ".js", ".py", ".sh", ".glsl", ".json", ".toml", ".gd", ".java", ".swift", ".txt",
           ".md", ".cmake", ""}


def api_page(header):
    """Doxygen's name of a header's page."""
    return "api/" + header.name.replace("_", "__").replace(".", "_8") + ".html"


class Site:
    def __init__(self, folder):
        self.folder = folder
        self.sources = set()

    def target(self, path):
        """Where a file of the sources stands in the site, or None."""
        relative = path.relative_to(ROOT)
        if str(relative) in TOP:
            return TOP[str(relative)]
        if relative.parts[0] == "docs":
            return str(pathlib.PurePosixPath(*relative.parts[1:]))
        for include in ("runtime/include", "platform/egl/include"):
            if str(relative).startswith(include) and path.suffix == ".h":
                return api_page(path)
        if path.is_dir() or path.suffix not in SOURCES:
            return None
        self.sources.add(relative)
        return f"source/{relative}.txt"

    def with_links(self, text, page, place):
        """place: the page's path in the site."""
        def link(match):
            target, _, anchor = match.group(2).partition("#")
            if re.match(r"[a-z]+:", target) or not target:
                return match.group()
            path = (page.parent / target).resolve()
            if not path.exists():
                raise SystemExit(f"{page.relative_to(ROOT)}: there is no {target}")
            found = self.target(path) if ROOT in path.parents else None
            if found is None:
                return match.group(1).strip("[]") if not match.group(1).startswith("!") else match.group()
            up = "../" * (len(pathlib.PurePosixPath(place).parts) - 1)
            return f"{match.group(1)}({up}{found}{'#' + anchor if anchor else ''})"
        parts = re.split(r"(^```.*?^```[^\n]*$)", text, flags=re.S | re.M)
        return "".join(p if p.startswith("```") else re.sub(r"(!?\[[^\]]*\])\(([^)\s]+)\)", link, p) for p in parts)

    def with_frames(self, text, place):
        """Pages where moving says more than a picture."""
        up = "../" * (len(pathlib.PurePosixPath(place).parts) - 1)
        has_page = (ROOT / "build/web/index.html").exists()

        def frame(match):
            if not has_page:
                return ""
            part, state = match.groups()
            return (f'<iframe class="play" title="The sample, to be turned and played" loading="lazy" '
                    f'src="{up}play/index.html?embed={part}#{state}"></iframe>')
        return re.sub(r"<!-- play (\w+): (\S+) -->", frame, text)

    def page(self, path, place):
        out = self.folder / place
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(self.with_links(self.with_frames(path.read_text(), place), path, place))

    def source(self, relative):
        out = self.folder / f"source/{relative}.txt"
        out.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / relative, out)


def main():
    folder = pathlib.Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    site = Site(folder)
    menu = (ROOT / "tools/docs/mkdocs.yml").read_text()
    for name, place in TOP.items():
        if (ROOT / name).exists():
            site.page(ROOT / name, place)
    for path in sorted((ROOT / "docs").rglob("*")):
        place = str(path.relative_to(ROOT / "docs"))
        if path.suffix == ".md" and f" {place}\n" not in menu:
            raise SystemExit(f"docs/{place} is not in tools/docs/mkdocs.yml")
        if path.suffix == ".md":
            site.page(path, place)
        elif path.is_file():
            (folder / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, folder / place)
    for relative in sorted(site.sources):
        site.source(relative)
    (folder / "assets").mkdir(exist_ok=True)
    shutil.copy(ROOT / "tools/docs/site.css", folder / "assets")


if __name__ == "__main__":
    main()
