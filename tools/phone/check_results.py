"""Checks results of the kit, the page that phone_table.py makes of them, and that it refuses spoilt ones.

usage: check_results.py FOLDER     with arm64.json, armv7.json, crashed.json, stub.json; called by tools/check/phone.sh
"""
import copy
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE.parent / "phone_table.py"
DOCS = HERE.parents[1] / "docs" / "performance.md"
work = pathlib.Path(sys.argv[1])
page = work / "page.md"
failures = 0


def expect(holds, what):
    global failures
    if not holds:
        print(f"check/phone: {what}", file=sys.stderr)
        failures += 1


def put(*results):
    return subprocess.run([sys.executable, str(TABLE), "--page", str(page), *map(str, results)], capture_output=True,
                          text=True)


def check_arm64(result):
    expect(result["bits"]["same"] is True and result["bits"]["differ"] == [], "arm64: other bits")
    paths = result["self_test"]["paths"]
    expect([row["path"] for row in paths] == ["ubo", "texture", "feedback", "compute", "cpu"], "arm64: other paths")
    for row in paths:
        # On a driver in software any path may be slow.
        expect(row["verdict"] in ("usable", "much slower than another path"), f"arm64: {row['path']}: {row['verdict']}")
        expect(row["position_error"] < 0.001 and row["normal_error"] < 0.005, f"arm64: {row['path']}: errors")
        expect(row["ns"] > 0, f"arm64: {row['path']}: not timed")
    expect(len(result["self_test"]["choice"]) == 4, "arm64: not four choices")
    expect("llvmpipe" in result["self_test"]["renderer"], "arm64: another driver")
    for path, part in result["gpu"].items():
        expect(len(part.get("rows", [])) == 6 and all(row["ns"] > 0 for row in part["rows"]), f"arm64: gpu.{path}")
    expect(len(result["cpu"]["rows"]) == 9 and all(row["ns"] > 0 for row in result["cpu"]["rows"]), "arm64: cpu")


def check_armv7(result):
    expect(result["bits"]["same"] is True, "armv7: other bits")
    expect(result["self_test"].get("error", "").startswith("no EGL"), "armv7: its self-test does not say: no EGL")
    expect(all("no EGL" in part.get("error", "") for part in result["gpu"].values()), "armv7: gpu does not say: no EGL")
    expect(len(result["cpu"]["rows"]) == 9 and all(row["ns"] > 0 for row in result["cpu"]["rows"]), "armv7: cpu")


def check_crashed(test):
    """Of a self-test that was told of two paths that had crashed."""
    crashed = [row["path"] for row in test["paths"] if row["verdict"] == "crashed when last tried"]
    expect(crashed == ["ubo", "texture"], f"arm64: crashed are {crashed}")
    expect(all(choice["path"] not in crashed for choice in test["choice"]), "arm64: a path that crashed is chosen")


def check_stub(result):
    """What run.sh makes of programs that say other bits, and that crash."""
    bits = result["bits"]
    expect((bits["hash"], bits["same"], bits["differ"]) == ("00000000000000AB", False, ["a, b"]), f"stub: {bits}")
    expect(result["self_test"] == {"error": "tried thrice"}, f"stub: {result['self_test']}")
    crash = {"error": "the program ended with code 139"}
    for path, part in result["gpu"].items():
        expect(part == (crash if path == "compute" else {"error": "a stub"}), f"stub: gpu.{path}: {part}")


def check_page(arm64):
    shutil.copy(DOCS, page)
    text = page.read_text()
    outside = text.split("<!-- phones -->")[0], text.split("<!-- /phones -->")[1]
    expect(put(work / "arm64.json", work / "armv7.json").returncode == 0, "good results are refused")
    once = page.read_text()
    expect("### an \\| emulated &lt;!-- board, arm64\n" in once and "### a second, armv7\n" in once, "no section a device")
    cell = f"| {arm64['cpu']['rows'][0]['ns']:.3g} |" if arm64["cpu"]["rows"][0]["ns"] < 1000 else "| "
    expect(cell in once, "the page lacks what `sample` costs")
    expect((once.split("<!-- phones -->")[0], once.split("<!-- /phones -->")[1]) == outside, "the page changed elsewhere")
    expect(put(work / "armv7.json", work / "arm64.json").returncode == 0, "good results are refused the second time")
    expect(page.read_text() == once, "the same results again change the page")
    newer = copy.deepcopy(arm64)
    newer["date"], newer["bits"]["same"], newer["bits"]["differ"] = "2031-01-31", False, ["sample"]
    (work / "newer.json").write_text(json.dumps(newer))
    expect(put(work / "newer.json", work / "stub.json").returncode == 0, "a newer result is refused")
    expect(page.read_text().count("### an ") == 1 and "2031-01-31" in page.read_text(), "a newer result replaces none")
    expect("stages: sample." in page.read_text() and "stages: a, b." in page.read_text(), "the page hides other bits")
    expect("`compute`: the program ended with code 139" in page.read_text(), "the page hides a crash")


def spoilt(arm64):
    """(bytes, what the refusal must say) of each."""
    def with_change(change):
        other = copy.deepcopy(arm64)
        change(other)
        return json.dumps(other).encode()

    whole = json.dumps(arm64).encode()
    yield whole[:-2], "line 1, column"
    yield b"", "line 1, column 1"
    yield whole.replace(b'"arm64"', b'"ARM\xff"', 1), "no UTF-8"
    yield b"[" * 100000, "too deep"
    yield whole + b" " * (1 << 20), "is longer than"
    yield whole.replace(b'"format": 1', b'"format": 1, "format": 1', 1), "two members"
    yield whole.replace(b'"items": 44', b'"items": NaN', 1), "NaN"
    yield whole.replace(b'"items": 44', b'"items": 1e999', 1), "cpu.rows[0].items: must be a positive whole number"
    yield whole.replace(b'"items": 44', b'"items": ' + b"4" * 5000, 1), "too many digits"
    yield with_change(lambda r: r.pop("bits")), "bits: is missing"
    yield with_change(lambda r: r["gpu"].pop("compute")), "gpu.compute: is missing"
    yield with_change(lambda r: r.update(more=1)), 'has a member "more"'
    yield with_change(lambda r: r.update(format=True)), "format: must be 1"
    yield with_change(lambda r: r["device"].update(name="a\n<!-- /phones -->")), "device.name: must be a text"
    yield with_change(lambda r: r["bits"].update(hash="0x1")), "bits.hash: must be 16"
    yield with_change(lambda r: r["self_test"]["paths"].pop()), "self_test.paths: must have the rows"
    yield with_change(lambda r: r["self_test"]["paths"][2].update(ns=-1)), "self_test.paths[2].ns: must be a number"
    yield with_change(lambda r: r["self_test"]["choice"][1].update(path="vulkan")), "self_test.choice[1].path: must be"
    yield with_change(lambda r: r["gpu"]["ubo"]["rows"].reverse()), "gpu.ubo.rows: must have the rows"
    yield with_change(lambda r: r.update(cpu=[])), "cpu: must be an object"


def check_refusals(arm64):
    shutil.copy(DOCS, page)
    before, bad = page.read_text(), work / "bad.json"
    for data, words in spoilt(arm64):
        bad.write_bytes(data)
        done = put(work / "armv7.json", bad)
        expect(done.returncode == 1 and done.stderr.count("\n") == 1 and done.stderr.startswith(f"{bad}: ")
               and words in done.stderr, f"not refused by {words!r}: {done.returncode}: {done.stderr[-300:]}")
    expect(page.read_text() == before, "a refused result changed the page")
    page.write_text("no markers\n")
    expect("are not both in the page" in put(work / "armv7.json").stderr, "a page without markers is not refused")


results = {abi: json.loads((work / f"{abi}.json").read_text()) for abi in ("arm64", "armv7", "stub")}
check_arm64(results["arm64"])
check_armv7(results["armv7"])
check_crashed(json.loads((work / "crashed.json").read_text()))
check_stub(results["stub"])
check_page(results["arm64"])
check_refusals(results["arm64"])
print(f"check/phone: {'good' if failures == 0 else f'{failures} failures'}", file=sys.stderr)
sys.exit(min(failures, 1))
