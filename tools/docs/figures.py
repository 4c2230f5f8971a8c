#!/usr/bin/env python3
"""Finds figures of README.md's table of costs that differ from those that were measured.

usage: tools/docs/figures.py

A figure is measured in one page. The section "What it costs" repeats some of them: each number in its table must stand
in a page that the section links to. Exit 1 if one does not.
"""
import re
import sys

import blocks

NUMBER = r"\d{1,3}(?: \d{3})+(?!\d)|\d+(?:\.\d+)*"


def section(text, title):
    return re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", text, flags=re.S | re.M).group(1)


def rows(text):
    """Of a table the cells of each row, without heading."""
    lines = [line for line in text.split("\n") if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def main():
    costs = section((blocks.ROOT / "README.md").read_text(), "What it costs")
    links = re.findall(r"\]\((docs/[^)#]+)", costs)
    measured = {number for link in links for number in re.findall(NUMBER, (blocks.ROOT / link).read_text())}
    missing = [(row[0], number) for row in rows(costs) for number in re.findall(NUMBER, row[1])
               if number not in measured]
    for row, number in missing:
        print(f"README.md: {row}: {number} stands in none of {', '.join(links)}")
    return 1 if missing or not rows(costs) else 0


if __name__ == "__main__":
    sys.exit(main())
