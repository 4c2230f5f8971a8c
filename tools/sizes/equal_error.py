"""Marrow's bytes where its error is as large as a peer's: neither is helped by promising more or less."""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import textwrap

import peers

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ("joint_max", "joint_rms", "vertex_max", "vertex_rms")
NEAR = 0.97  # of the peer's error, or more, that ours is to be
MOST_TRIES = 10


def of_peer(model, setting, folder):
    """What posed_error.cjs says of a peer's file; None where it cannot be compared."""
    with tempfile.TemporaryDirectory() as work:
        made = pathlib.Path(work) / "out.glb"
        try:
            peers.make(model, setting, folder, made)
            return peers.posed_error(model, made, folder)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return None


def matched(model, wanted, cook):
    """The coarsest promise found with which none of our four errors exceeds the peer's; and by how much each does."""
    promise, best = wanted["joint_max"], None
    with tempfile.TemporaryDirectory() as work:
        exported = pathlib.Path(work) / "out.glb"
        for _ in range(MOST_TRIES):
            # Not beyond 1 % or below a millionth: there other limits count.
            promise = min(max(promise, 1e-6), 1e-2)
            we = cook(model, ("--clip-error", f"{100 * promise:.7f}%"), exported)
            error = peers.posed_error(model, exported, ROOT / "build/peers")
            if not error:
                return None
            share = max(error[f] / wanted[f] for f in FIGURES if wanted[f])
            if share <= 1 and (not best or share > best["share"]):
                best = {"promise": promise, "share": share, "error": error, "we": we}
            if NEAR <= share <= 1 or share == 0:
                break
            promise *= (1 + NEAR) / 2 / share
    return best


HEAD = ("| model | --clip-error | joints: largest, RMS | vertices: largest, RMS | clips | ratio | zstd | whole | ratio | zstd |\n"
        "|---|---|---|---|---|---|---|---|---|---|")
NOTES = """## At gltfpack's own error

Here neither file is helped by promising more or less. The peer is `gltfpack -cz -af 0`. Marrow has that `--clip-error`
with which the largest of four errors is 97 to 100 % of gltfpack's.

The four are those of joints and of vertices, each the largest and the root mean square. They are taken at up to 240
moments of all clips together, against the source. Both files are read as glTF, ours by `marrow export`
(`tools/sizes/posed_error.cjs`). Errors are shares of gltfpack's. Bytes are as above.
"""


def table(found, them, setting, cook):
    """Lines of Markdown, how many models, and their medians.

    found: a name's model; them: a name's figures of peers; cook(model, options, glTF to write).
    """
    out, ratios, missing = [NOTES, HEAD], [[] for _ in range(4)], []
    for name, model in found.items():
        peer = (them.get(name) or {}).get(setting)
        if not peer or not peer["animation"]:
            continue
        best = matched(model, peer["posed"], cook) if peer.get("posed") else None
        if not best:
            missing.append(name)
            continue
        we, shares = best["we"], [best["error"][f] / peer["posed"][f] if peer["posed"][f] else 0 for f in FIGURES]
        found_ratios = [we[part] / peer[part] for part in ("animation", "animation_zstd", "whole", "whole_zstd")]
        for column, value in zip(ratios, found_ratios):
            column.append(value)
        cells = [name, f"{100 * best['promise']:.4f} %", f"{shares[0]:.2f}, {shares[1]:.2f}", f"{shares[2]:.2f}, {shares[3]:.2f}",
                 f"{we['animation']} / {we['animation_zstd']}", *[f"{r:.2f}" for r in found_ratios[:2]],
                 f"{we['whole']} / {we['whole_zstd']}", *[f"{r:.2f}" for r in found_ratios[2:]]]
        out.append("| " + " | ".join(cells) + " |")
        print(f"sizes: {name} at {setting}'s error", file=sys.stderr)
    medians = [f"{statistics.median(column):.2f}" if column else "–" for column in ratios]
    out.append(f"| **median** | | | | | {medians[0]} | {medians[1]} | | {medians[2]} | {medians[3]} |")
    if missing:
        out += ["", textwrap.fill("These cannot be compared: " + ", ".join(missing) + ".", 120)]
    return out + [""], len(ratios[0]), medians
