#!/usr/bin/env python3
"""Finds links of a site that lead nowhere: files that are not there, and headings.

usage: tools/docs/links.py FOLDER    exit 1 if there are any; links to other sites are not tried
"""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], {"", "__tabbed", "top"}
        self.feed(path.read_text(errors="replace"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes.get("id"), attributes.get("name")}
        for key in ("href", "src"):
            if attributes.get(key):
                self.links.append(attributes[key])


def dead_links(folder):
    pages = {path.resolve(): Page(path) for path in folder.rglob("*.html")}
    for path, page in sorted(pages.items()):
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc or link.startswith("javascript:") or "${" in link:
                continue
            target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
            if target.is_dir():
                target /= "index.html"
            if not target.exists():
                yield path, link
            elif url.query:  # a page that reads its address: what follows is no anchor
                continue
            elif target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors:
                yield path, link


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    dead = [(path.relative_to(folder), link) for path, link in dead_links(folder) if path.name != "404.html"]
    for path, link in dead:
        print(f"{path}: {link}: leads nowhere", file=sys.stderr)
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())
