#!/usr/bin/env python3
"""Cooks scenes that grow in one respect each, 4 times and 16 times, and looks at what comes out: time of processor and
memory must grow no faster than n log n. Prints a table; exit 1 if something grows faster.

usage: tools/check/growth.py MARROW [KIND...]      (the program, optimised; kinds of growing_scenes.py, all by default)
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import growing_scenes

# n log n grows by 4.7 from 4 × 500 to 16 × 500, n² by 16.
MOST_GROWTH = 6.5
LEAST_S, LEAST_MB = 0.05, 6  # what is not told from noise
MOST_S = 10
MOST_MB, MOST_BYTES_A_BYTE = 64, 32
MOST_TRIES = 3  # other programs disturb a measurement, never the other way round
COMMANDS = {"cook": "cook {source} -o {cooked} --jobs 2", "info": "info {cooked}", "diff": "diff {cooked} {cooked}",
            "export": "export {cooked} -o {exported}"}


class Failed(Exception):
    pass


def run(marrow, command, folder, source):
    """Seconds of processor and megabytes."""
    places = {"source": source, "cooked": folder / "cooked.mrw", "exported": folder / "exported.glb"}
    with open(folder / "said.txt", "w+") as said:
        child = subprocess.Popen([marrow] + [word.format(**places) for word in command.split()], stdout=said, stderr=said)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        if child.returncode != 0:
            raise Failed(f"exit {child.returncode}: {said.read()[-300:]}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def growth(few, many, base, least):
    return max(many - base, 0) / max(few - base, least)


class Measured:
    """What a kind took at 1 ×, 4 × and 16 ×, the least of all tries."""

    def __init__(self):
        self.seconds = {name: [float("inf")] * 3 for name in COMMANDS}
        self.mb = {name: [float("inf")] * 3 for name in COMMANDS}
        self.bytes = 0

    def take(self, marrow, kind, folder):
        source = folder / "scene.glb"
        for step in range(3):
            growing_scenes.make(kind, growing_scenes.KINDS[kind][1] * 4**step, source)
            self.bytes = source.stat().st_size
            for name, command in COMMANDS.items():
                seconds, mb = run(marrow, command, folder, source)
                self.seconds[name][step] = min(self.seconds[name][step], seconds)
                self.mb[name][step] = min(self.mb[name][step], mb)

    def complaints(self, base_s, base_mb):
        out = []
        for name in COMMANDS:
            s, mb = self.seconds[name], self.mb[name]
            if growth(s[1], s[2], base_s, LEAST_S) > MOST_GROWTH:
                out.append(f"{name} takes {s[1]:.2f} s, then {s[2]:.2f} s")
            if s[2] > MOST_S:
                out.append(f"{name} takes {s[2]:.2f} s")
            if growth(mb[1], mb[2], base_mb, LEAST_MB) > MOST_GROWTH:
                out.append(f"{name} takes {mb[1]:.0f} MB, then {mb[2]:.0f} MB")
            if name == "cook" and mb[2] > MOST_MB + MOST_BYTES_A_BYTE * self.bytes / 1e6:
                out.append(f"{name} takes {mb[2]:.0f} MB for {self.bytes} bytes")
        return out

    def row(self, kind):
        cook = " / ".join(f"{s:.2f}" for s in self.seconds["cook"])
        others = " | ".join(f"{self.seconds[name][2]:.2f}" for name in ("info", "diff", "export"))
        most = max(mb[2] for mb in self.mb.values())
        return f"| {kind} | {16 * growing_scenes.KINDS[kind][1]:,} | {self.bytes / 1e3:,.0f} | {cook} | {others} | {most:.0f} |"


def main():
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= growing_scenes.KINDS.keys():
        sys.exit(__doc__)
    marrow = os.path.abspath(sys.argv[1])
    failed = False
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        growing_scenes.make("meshes", 1, folder / "least.glb")
        base_s, base_mb = run(marrow, COMMANDS["cook"], folder, folder / "least.glb")
        print("| many | 16 × | kB | cook, s: 1 / 4 / 16 × | info, s | diff, s | export, s | most MB |\n|" + "---|" * 8)
        for kind in sys.argv[2:] or growing_scenes.KINDS:
            measured = Measured()
            try:
                for _ in range(MOST_TRIES):
                    measured.take(marrow, kind, folder)
                    complaints = measured.complaints(base_s, base_mb)
                    if not complaints:
                        break
            except Failed as failure:
                complaints = [str(failure)]
            print(measured.row(kind), flush=True)
            for complaint in complaints:
                print(f"growth: {kind}: {complaint}", file=sys.stderr)
            failed |= bool(complaints)
    sys.exit(1 if failed else 0)


main()
