#!/usr/bin/env python3
"""Puts what tools/phone.sh's kit measured on devices into a page, between <!-- phones --> and <!-- /phones -->.

usage: tools/phone_table.py [--page FILE.md] RESULT.json...
A section a device; one that is there already, of the same name and the same processor's bits, is replaced. The page is
docs/performance.md without --page. If any result is not what the kit writes, one line says where, and nothing is written.
"""
import argparse
import html
import json
import math
import os
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "performance.md"
BEGIN, END = "<!-- phones -->\n", "<!-- /phones -->\n"
MOST_BYTES = 1 << 20
PATHS = ("ubo", "texture", "feedback", "compute", "cpu")
GPU_ROWS = ("ssd/p", "ssd/pn", "ssd/pnm", "as/p", "as/pn", "as/pnm")
CPU_ROWS = ("sample", "local_to_model", "build_palette", "skin/rigid/p", "skin/ssd/p", "skin/as/p", "skin/rigid/pn",
            "skin/ssd/pn", "skin/as/pn")


class Refusal(Exception):
    """place: rule: what to do."""


def refuse(place, rule, todo="take what the kit wrote, as it is"):
    raise Refusal(f"{place}: {rule}: {todo}")


def is_text(value):
    return isinstance(value, str) and len(value) <= 1000 and re.fullmatch(r"[ -~]*", value) is not None


def is_number(value):
    return type(value) in (int, float) and 0 <= value <= 1e12 and math.isfinite(value)


def is_count(value):
    return type(value) is int and 0 < value < 1 << 32


KINDS = {  # what a member may be, and how it is called
    "text": (is_text, "must be a text of printable ASCII"),
    "number": (is_number, "must be a number from 0 to 1e12"),
    "count": (is_count, "must be a positive whole number"),
    "flag": (lambda value: isinstance(value, bool), "must be true or false"),
    "hash": (lambda value: is_text(value) and re.fullmatch("[0-9A-F]{16}", value), "must be 16 hexadecimal digits"),
    "date": (lambda value: is_text(value) and re.fullmatch(r"\d{4}-\d\d-\d\d", value), "must be a date, YYYY-MM-DD"),
    "abi": (lambda value: value in ("arm64", "armv7"), "must be arm64 or armv7"),
    "path": (lambda value: value in PATHS, "must be one of " + ", ".join(PATHS)),
    "choice": (lambda value: value in (*PATHS, "none"), "must be one of " + ", ".join((*PATHS, "none"))),
    "format": (lambda value: type(value) is int and value == 1, "must be 1"),
}
PATH_ROW = {"path": "path", "verdict": "text", "position_error": "number", "normal_error": "number", "ns": "number",
            "ns_per_pass": "number"}
# Members by name; a list is an array of what it holds. "name or error": an object that may be {"error": text} instead.
SHAPE = {
    "format": "format", "marrow": "text", "date": "date", "abi": "abi",
    "device": {"name": "text", "cpu": "text", "system": "text", "machine": "text"},
    "bits or error": {"hash": "hash", "kit": "hash", "same": "flag", "differ": ["text"]},
    "self_test or error": {"renderer": "text", "version": "text", "paths": [PATH_ROW],
                           "choice": [{"passes": "count", "characters": "count", "path": "choice"}]},
    "cpu or error": {"rows": [{"name": "text", "items": "count", "ns": "number"}]},
    "gpu": {f"{path} or error": {"rows": [{"name": "text", "ns": "number"}]} for path in PATHS},
}


def check(value, shape, place):
    if isinstance(shape, str):
        holds, rule = KINDS[shape]
        if not holds(value):
            refuse(place, rule)
    elif isinstance(shape, list):
        if not isinstance(value, list):
            refuse(place, "must be an array")
        for i, item in enumerate(value):
            check(item, shape[0], f"{place}[{i}]")
    else:
        if not isinstance(value, dict):
            refuse(place, "must be an object")
        names = [name.removesuffix(" or error") for name in shape]
        for name in value:
            if name not in names:
                refuse(place, f"has a member {json.dumps(name)[:40]} that nobody knows")
        for name, key in zip(names, shape):
            inner = name if place == "the file" else f"{place}.{name}"
            if name not in value:
                refuse(inner, "is missing")
            fails = key != name and isinstance(value[name], dict) and "error" in value[name]
            check(value[name], {"error": "text"} if fails else shape[key], inner)


def check_names(rows, key, wanted, place):
    if [row[key] for row in rows] != list(wanted):
        refuse(place, "must have the rows " + ", ".join(wanted) + " in this order", "use the kit and the table of one version")


def unique(pairs):
    if len({name for name, _ in pairs}) != len(pairs):
        refuse("the file", "an object has two members of one name")
    return dict(pairs)


def never(word):
    refuse("the file", f"{word} is no number of JSON")


def read(path):
    """The result in a file. Raises Refusal."""
    try:
        with open(path, "rb") as stream:
            data = stream.read(MOST_BYTES + 1)
    except OSError as error:
        refuse("the file", error.strerror, "give a file that can be read")
    if len(data) > MOST_BYTES:
        refuse("the file", f"is longer than {MOST_BYTES} bytes")
    try:
        result = json.loads(data.decode("utf-8"), object_pairs_hook=unique, parse_constant=never)
    except json.JSONDecodeError as error:
        refuse(f"line {error.lineno}, column {error.colno}", error.msg, "let run.sh end, and fetch the file again")
    except (ValueError, RecursionError):
        refuse("the file", "is no JSON: bytes that are no UTF-8, too many digits, or too deep")
    check(result, SHAPE, "the file")
    if "paths" in result["self_test"]:
        check_names(result["self_test"]["paths"], "path", PATHS, "self_test.paths")
    if "rows" in result["cpu"]:
        check_names(result["cpu"]["rows"], "name", CPU_ROWS, "cpu.rows")
    for path in PATHS:
        if "rows" in result["gpu"][path]:
            check_names(result["gpu"][path]["rows"], "name", GPU_ROWS, f"gpu.{path}.rows")
    return result


def plain(text):
    """As Markdown that shows the text."""
    return re.sub(r"([\\`*_\[\]|#~])", r"\\\1", html.escape(text, quote=False))


def table(rows):
    head, *rest = ["| " + " | ".join(cells) + " |" for cells in rows]
    return [head, "|" + "---|" * len(rows[0]), *rest]


def ns(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def bits_line(bits):
    if "error" in bits:
        return f"Bits: {plain(bits['error'])}."
    if bits["same"]:
        return f"Bits: the same, {bits['hash']}."
    return f"**Bits differ**: {bits['hash']}, not {bits['kit']}; stages: {', '.join(map(plain, bits['differ'])) or '–'}."


def path_table(result):
    test, gpu = result["self_test"], result["gpu"]
    lines = [["path", "self-test", "position error, m", "normal error", "ns a vertex", "a further pass",
              *(f"{name.upper().split('/')[0]} {name.split('/')[1]}" for name in GPU_ROWS)]]
    for i, path in enumerate(PATHS):
        tried = test["paths"][i] if "paths" in test else None
        cells = ["–"] * 5
        if tried:
            cells = [plain(tried["verdict"]), f"{tried['position_error']:.2g}", f"{tried['normal_error']:.2g}",
                     ns(tried["ns"]), ns(tried["ns_per_pass"])]
        rows = gpu[path].get("rows")
        lines.append([f"`{path}`", *cells, *([ns(row["ns"]) for row in rows] if rows else ["–"] * len(GPU_ROWS))])
    return table(lines)


def section(result):
    device, test, cpu = result["device"], result["self_test"], result["cpu"]
    lines = [heading(result), "", f"{plain(device['cpu'])}; {plain(device['system'])}, {plain(device['machine'])};"
             f" {result['date']}, Marrow {plain(result['marrow'])}.", bits_line(result["bits"])]
    if "error" in test:
        lines += [f"Self-test: {plain(test['error'])}."]
    else:
        lines += [f"{plain(test['renderer'])}; {plain(test['version'])}. `choose` takes "
                  + "; ".join(f"passes {c['passes']}, characters {c['characters']}: `{c['path']}`" for c in test["choice"])
                  + "."]
    errors = {path: result["gpu"][path]["error"] for path in PATHS if "error" in result["gpu"][path]}
    if len(errors) < len(PATHS) or "error" not in test:
        lines += ["", *path_table(result)]
    failed = [f"`{path}`: {plain(why)}" for path, why in errors.items() if why != test.get("error")]
    if failed:
        lines += ["", "Not measured: " + "; ".join(failed) + "."]
    if "error" in cpu:
        lines += ["", f"On the CPU: {plain(cpu['error'])}."]
    else:
        lines += ["", "On the CPU, ns a joint or a vertex:", "",
                  *table([[f"`{name}`" for name in CPU_ROWS], [ns(row["ns"]) for row in cpu["rows"]]])]
    return "\n".join(lines) + "\n"


def heading(result):
    return f"### {plain(result['device']['name'].strip()) or 'unnamed'}, {result['abi']}"


def put(page, results):
    """The page's text with the results in it. Raises Refusal."""
    before, begin, rest = page.partition(BEGIN)
    inside, end, after = rest.partition(END)
    if not begin or not end:
        refuse(f"{BEGIN.strip()} … {END.strip()}", "are not both in the page, a line each", "add them where tables go")
    sections = {}
    for text in re.split(r"^(?=### )", inside, flags=re.MULTILINE):
        if text.strip():
            sections[text.split("\n", 1)[0]] = text.rstrip("\n") + "\n"
    for result in results:
        sections[heading(result)] = section(result)
    return before + begin + "\n" + "\n".join(sections.values()) + "\n" + end + after


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0], description=__doc__.split("\n")[0])
    parser.add_argument("--page", default=str(PAGE))
    parser.add_argument("results", nargs="+")
    arguments = parser.parse_args()
    at = arguments.page
    try:
        results = []
        for at in arguments.results:
            results.append(read(at))
        at = arguments.page
        page = pathlib.Path(at)
        text = put(page.read_text(encoding="utf-8"), results)
        new = page.with_name(page.name + ".new")
        new.write_text(text, encoding="utf-8")
        os.replace(new, page)
    except Refusal as refusal:
        print(f"{at}: {refusal}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"{at}: the file: {error.strerror}: give a page that can be read and written", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
