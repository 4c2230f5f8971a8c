#!/usr/bin/env python3
"""Makes docs/sizes.md: what models take when Marrow cooks them and when others compress them, and how far they move.

usage: tools/sizes/sizes.py [--peers] [--marrow PROGRAM] [-o FILE.md]

Models are those of the folder that MARROW_ASSETS names. What the peers make stands in tools/sizes/peers.json; --peers
measures what is missing there with npm's packages (kept under build/peers); without the file that is everything, and takes
half an hour. Needs zstd.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import textwrap

import equal_error
import peers

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ROOT / "tools/sizes/peers.json"
ANIMATION = "gltfpack -cz"  # and what is compared as a whole file
# The table that other cookers' figures are known for; all other models with meshes come in a second one.
MAIN = ["RiggedFigure", "CesiumMan", "Fox", "raylib_robot", "greenman", "KayKit_Knight", "mannequiny",
        "mannequiny_subdiv_u16w", "godot_robot", "m2m_dragon", "m2m_shark", "m2m_sintel"]


def ours(marrow, model, promise=("--clip-error", "0.05%", "--clip-shell", "3cm"), exported=None):
    """Sizes and the cooker's own errors. exported: where the file goes as glTF, too."""
    with tempfile.TemporaryDirectory() as work:
        out = os.path.join(work, "out.mrw")
        run = subprocess.run([marrow, "cook", str(model), "-o", out, "--json", *promise, "--mesh-codec", "draco-smallest"],
                             check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        if exported:
            subprocess.run([marrow, "export", out, "-o", str(exported)], check=True, stderr=subprocess.DEVNULL)
        report, data = json.loads(run.stdout), pathlib.Path(out).read_bytes()
        info = json.loads(subprocess.run([marrow, "info", out, "--json"], check=True, stdout=subprocess.PIPE).stdout)
    parts = {"geometry": b"", "animation": b"", "structure": b""}
    for section in info["sections"]:
        part = data[section["offset"]:section["offset"] + section["bytes"]]
        parts[{"GEOM": "geometry", "CLIP": "animation"}.get(section["type"], "structure")] += part
    result = {name: len(part) for name, part in parts.items()}
    result["structure"] = len(data) - result["geometry"] - result["animation"]  # header, table and padding too
    result.update({name + "_zstd": peers.zstd_bytes(part) for name, part in parts.items()})
    result["whole"], result["whole_zstd"] = len(data), peers.zstd_bytes(data)
    result["vertices"] = sum(mesh["vertices"] for mesh in report["meshes"])
    result["position_error_m"] = max([mesh["max_position_error_m"] for mesh in report["meshes"]], default=0)
    result["codecs"] = sorted({mesh["codec"] for mesh in report["meshes"]})
    # Clips within a share of their own skeleton, so the largest share counts.
    across = [skeleton["diagonal_m"] for skeleton in info["skeletons"]]
    shares = [clip["max_error_m"] / across[listed["skeleton"]] for clip, listed in zip(report["clips"], info["clips"])
              if across[listed["skeleton"]] > 0]
    result["animation_error"] = max(shares, default=0)
    return result


def best_geometry(settings):
    """The least geometry as it is and after zstd, each with the setting that made it."""
    known = [(s["geometry"], s["geometry_zstd"], name) for name, s in settings.items() if s]
    raw, zstd = min(known), min(known, key=lambda k: k[1])
    return raw[0], raw[2], zstd[1], zstd[2]


def percent(share):
    return "–" if share is None else f"{100 * share:.3f} %"


def ratio(a, b):
    return a / b if b else None


def row(name, we, them):
    cells = [name, str(we["vertices"])]
    cells += [f"{we[p]} / {we[p + '_zstd']}" for p in ("geometry", "animation", "structure", "whole")]
    across = next((s["diagonal"] for s in them.values() if s), None) if them else None
    cells += [percent(we["position_error_m"] / across if across else None), percent(we["animation_error"])]
    return "| " + " | ".join(cells) + " |"


def peer_row(name, we, them, ratios):
    raw, raw_by, zstd, zstd_by = best_geometry(them)
    whole = them.get(ANIMATION)
    cells = [name, f"{raw} / {zstd}", raw_by if raw_by == zstd_by else f"{raw_by}; zstd: {zstd_by}",
             percent(them[raw_by]["position_error"])]
    found = [ratio(we["geometry"], raw), ratio(we["geometry_zstd"], zstd)]
    if whole:
        cells += [f"{whole['animation']} / {whole['animation_zstd']}", percent(whole["animation_error"]),
                  f"{whole['whole']} / {whole['whole_zstd']}"]
        found += [ratio(we[p], whole[p]) if we["animation"] and whole["animation"] else None
                  for p in ("animation", "animation_zstd")]
        found += [ratio(we[p], whole[p]) for p in ("whole", "whole_zstd")]
    else:
        cells += ["–"] * 3
        found += [None] * 4
    for column, value in zip(ratios, found):
        if value is not None:
            column.append(value)
    cells += ["–" if value is None else f"{value:.2f}" for value in found]
    return "| " + " | ".join(cells) + " |"


INTRO = """# Sizes

This page says how many bytes models take when Marrow cooks them, and when others compress them. `tools/sizes/sizes.py`
writes it. Bytes are as they are / after zstd -19. Textures are left out everywhere.

These are the medians of Marrow's bytes by theirs. Below 1 Marrow is smaller.

| table | models | geometry | zstd | clips | zstd | whole file | zstd |
|---|---|---|---|---|---|---|---|
"""
HOW = """
Geometry is compared with the best of nine settings, clips and whole files with `gltfpack -cz`.

## How we measure

**Marrow** cooks by `marrow cook --clip-error 0.05% --clip-shell 3cm --mesh-codec draco-smallest`. So clips keep within
0.05 % of the skeleton's diagonal, on a shell of 3 cm round every joint.

- *Geometry* is the GEOM records, with weights and joints of vertices.
- *Structure* is all else but clips: skeletons, inverse bind matrices, materials, names, header.
- *Errors* are the cooker's own figures. Positions are a share of the model's diagonal, clips of the skeleton's.

**The others** have nine settings, each with 14-bit positions:

| setting | bits of normals, texture coordinates, weights |
|---|---|
"""
NOTES = """
- *Best geometry* is the smallest of the nine settings, once as it is and once after zstd. The table names the setting
  that made each. Inverse bind matrices are left out, as they are of Marrow's.
- *Animation* and the *whole* file are those of `gltfpack -cz -af 0`. Its JSON stays as it stands, without textures.
- The *position error* is the largest distance at rest between a vertex and the nearest of the other file.
- The *animation error* is the largest distance between joints at up to 100 moments a clip. It is a share of the
  skeleton's diagonal, where joints correspond.
- gltfpack drops texture coordinates that no texture uses, and influences beyond four.
"""
HEAD = ("| model | vertices | geometry | animation | structure | whole | position error | clip error |\n"
        "|---|---|---|---|---|---|---|---|")
PEER_HEAD = ("| model | best geometry | by | position error | animation | error | whole | ratio: geometry | zstd | "
             "animation | zstd | whole | zstd |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|")


def not_measured(names):
    return textwrap.fill("Others were not measured for " + ", ".join(names) + ".", 120)


def tables(title, names, we, them):
    """Lines of Markdown, how many models were compared, and the medians of ratios."""
    out = [f"## {title}", "", "### Marrow", "", HEAD]
    out += [row(name, we[name], them.get(name)) for name in names]
    known = [name for name in names if any((them.get(name) or {}).values())]
    ratios = [[] for _ in range(6)]
    out += ["", "### Others", "", PEER_HEAD]
    out += [peer_row(name, we[name], them[name], ratios) for name in known]
    medians = [f"{statistics.median(column):.2f}" if column else "–" for column in ratios]
    out += ["| **median** |" + " |" * 6 + " " + " | ".join(medians) + " |", ""]
    missing = [name for name in names if name not in known]
    if missing:
        out += [not_measured(missing), ""]
        print("sizes: NO PEERS' FIGURES for " + ", ".join(missing) + "; measure them with --peers", file=sys.stderr)
    return out, len(known), medians


def summary(title, count, medians):
    """A row of the first table."""
    anchor = title.lower().replace(" ", "-").replace("'", "")
    return "| " + " | ".join([f"[{title}](#{anchor})", str(count), *medians]) + " |\n"


def models(assets):
    """Name and path of each, the main table's first."""
    listed = [a["file"] for a in json.loads((assets / "manifest.json").read_text())["assets"] if a.get("verts", 1)]
    by_name = {file.rsplit(".", 1)[0]: assets / file for file in listed}
    return {name: by_name[name] for name in [*[m for m in MAIN if m in by_name], *[n for n in by_name if n not in MAIN]]}


def measure_peers(found, known):
    folder = ROOT / "build/peers"
    try:
        peers.install(folder)
    except (OSError, subprocess.CalledProcessError):
        print("sizes: NPM CANNOT BE REACHED: the peers' figures are those of tools/sizes/peers.json", file=sys.stderr)
        return known
    for name, path in found.items():
        of_model = known.setdefault(name, {})
        for setting in peers.SETTINGS:
            if setting not in of_model:
                of_model[setting] = peers.measure(path, setting, folder)
        if of_model[ANIMATION] and "posed" not in of_model[ANIMATION]:
            of_model[ANIMATION]["posed"] = equal_error.of_peer(path, ANIMATION, folder)
        print(f"sizes: {name}", file=sys.stderr)
        FIGURES.write_text(json.dumps(known, indent=1) + "\n")
    return known


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", action="store_true", help="measure the peers where peers.json has no figures")
    parser.add_argument("--marrow", default=str(ROOT / "build/release/tools/marrow"), help="the program")
    parser.add_argument("-o", "--output", default=str(ROOT / "docs/sizes.md"), help="the page to write")
    a = parser.parse_args()
    assets = pathlib.Path(os.environ.get("MARROW_ASSETS", ROOT.parent / "shared/assets"))
    if not (assets / "manifest.json").exists():
        sys.exit(f"sizes: no models at {assets}: set MARROW_ASSETS")
    found = models(assets)
    them = json.loads(FIGURES.read_text()) if FIGURES.exists() else {}
    if a.peers:
        them = measure_peers(found, them)
    we = {name: ours(a.marrow, path) for name, path in found.items()}
    main_lines, *main_row = tables("The main table", [n for n in found if n in MAIN], we, them)
    other_lines, *other_row = tables("All other models", [n for n in found if n not in MAIN], we, them)
    equal_lines, equal_count, equal_medians = equal_error.table(
        found, them, ANIMATION, lambda model, promise, out: ours(a.marrow, model, promise, out))
    page = INTRO + summary("The main table", *main_row) + summary("All other models", *other_row)
    page += summary("At gltfpack's own error", equal_count, ["–", "–", *equal_medians])
    page += HOW + "".join(f"| {name} | {bits} |\n" for name, (_, bits) in peers.SETTINGS.items()) + NOTES + "\n"
    page += "\n".join([*main_lines, *other_lines, *equal_lines])
    codecs = sorted({codec for name in we for codec in we[name]["codecs"]})
    page += "\nIn these tables Marrow's meshes are coded by " + ", ".join(f"`{codec}`" for codec in codecs) + ".\n"
    pathlib.Path(a.output).write_text(page)


if __name__ == "__main__":
    main()
