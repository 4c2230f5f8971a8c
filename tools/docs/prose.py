#!/usr/bin/env python3
"""Measures the prose of Markdown pages: words a sentence, line length, sentences without a verb.

usage: tools/docs/prose.py [--show] PAGE.md ...    (no page: README.md, CHANGELOG.md, CONTRIBUTING.md, all below docs)

A sentence ends at . ! ? or at the end of a paragraph or list item. Code, tables, headings and pictures do not count.
--show prints the long sentences and those without a verb. Exit 1 if a page is over a limit. Verbs come from WordNet
(Debian: wordnet-base); without it, exit 3.
"""
import pathlib
import re
import sys

MEAN_WORDS = 15
LINE = 120
WORDNET = pathlib.Path("/usr/share/wordnet")
AUXILIARIES = set("""am is are was were be been being has have had do does did can could may might must shall should will
would cannot let's isn't aren't doesn't don't""".split())


def verbs():
    """Every form of every verb: {"runs", "ran", ...}."""
    forms = set(AUXILIARIES)
    for line in (WORDNET / "index.verb").read_text().splitlines():
        verb = line.split(" ", 1)[0]
        if not verb or "_" in verb:
            continue
        stem = verb[:-1] if verb.endswith("e") else verb
        third = verb[:-1] + "ies" if re.search("[^aeiou]y$", verb) else verb + "s"
        past = verb[:-1] + "ied" if re.search("[^aeiou]y$", verb) else stem + "ed"
        forms |= {verb, third, verb + "es", past, stem + "ing", verb + verb[-1] + "ed", verb + verb[-1] + "ing"}
    forms |= {line.split()[0] for line in (WORDNET / "verb.exc").read_text().splitlines()}
    return forms


def paragraphs(text):
    """Yields (line number, words) of every paragraph and list item, in plain text."""
    text = re.sub(r"<!--.*?-->", lambda m: "\n" * m.group().count("\n"), text, flags=re.S)
    start, lines, fenced, in_list = 0, [], False, False
    for number, line in enumerate(text.split("\n") + [""], 1):
        bare = line.strip()
        fence = re.match(r"\s*(```|~~~)", line)
        item = re.match(r"\s*([-*+]|\d+\.)\s", line)
        code = line.startswith("    ") and not lines and not in_list
        ends = fence or fenced or not bare or item or bare.startswith(("#", "|", "![", "<", ">", "===", "---")) or code
        if ends and lines:
            yield start, " ".join(lines)
            lines = []
        if fence:
            fenced = not fenced
        elif item and not fenced:
            start, lines, in_list = number, [re.sub(r"^([-*+]|\d+\.)\s+", "", bare)], True
        elif not ends:
            if not lines:
                start = number
            lines.append(bare)
        if bare and not line.startswith(" ") and not item:
            in_list = False


def plain(paragraph):
    """Without Markdown: a link is its text, a piece of code one word."""
    paragraph = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", paragraph)
    paragraph = re.sub(r"`[^`]*`", "code", paragraph)
    paragraph = re.sub(r"\[([^\]]*)\](\([^)]*\)|\[[^\]]*\])?", r"\1", paragraph)
    return re.sub(r"\*\*|__|\*(?=\w)|(?<=\w)\*", "", paragraph)


def sentences(paragraph):
    text = re.sub(r"\b(e\.g|i\.e|etc|cf|vs|no|fig|al)\.", r"\1", plain(paragraph), flags=re.I)
    for sentence in re.split(r"(?<=[.!?])[)\"']*\s+|(?<=[.!?][)\"'])\s+", text):
        words = re.findall(r"[A-Za-z][A-Za-z'’\-]*|\d[\d.,]*", sentence)
        if words:
            yield sentence.strip(), words


def check(page, known, show):
    text = page.read_text()
    counts, long_sentences, verbless = [], [], []
    for number, paragraph in paragraphs(text):
        for sentence, words in sentences(paragraph):
            counts.append(len(words))
            if len(words) > 30:
                long_sentences.append((number, sentence))
            if len(words) > 2 and " = " not in sentence and not any(w.lower() in known or w.lower().endswith("n't") for w in words):
                verbless.append((number, sentence))
    wide = [i for i, line in enumerate(text.split("\n"), 1) if len(line) > LINE and not line.lstrip().startswith("|")
            and "](" not in line and not re.match(r"\s*(\S+\s*)?http", line)]
    mean = sum(counts) / len(counts) if counts else 0
    bad = mean > MEAN_WORDS or wide or verbless
    print(f"{'OVER ' if bad else '     '}{page}: {sum(counts)} words, {mean:.1f} a sentence, {len(long_sentences)} over 30, "
          f"{len(wide)} wide lines, {len(verbless)} without a verb")
    if show:
        for kind, found in (("long", long_sentences), ("no verb", verbless), ("wide", [(n, "") for n in wide])):
            for number, sentence in found:
                print(f"  {page}:{number}: {kind}: {sentence}")
    return not bad


def main():
    if not (WORDNET / "index.verb").exists():
        print("prose: no WordNet here: install wordnet-base", file=sys.stderr)
        return 3
    root = pathlib.Path(__file__).resolve().parents[2]
    pages = [pathlib.Path(a) for a in sys.argv[1:] if a != "--show"]
    pages = pages or [root / p for p in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")] + sorted(root.glob("docs/**/*.md"))
    known = verbs()
    return 0 if all([check(page, known, "--show" in sys.argv) for page in pages if page.exists()]) else 1


if __name__ == "__main__":
    sys.exit(main())
