#!/usr/bin/env python3
"""Tests of cooking on many machines. Called by tools/check/machines.sh.

usage: run.py MARROW WORK [PART ...]     parts: shards cache bazel slurm
"""
import importlib
import pathlib
import sys
import time
import traceback
import types

from common import ROOT, Skipped


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    parts = sys.argv[3:] or ['shards', 'cache', 'bazel', 'slurm']
    t = types.SimpleNamespace(marrow=pathlib.Path(sys.argv[1]).resolve(), work=pathlib.Path(sys.argv[2]).resolve(), root=ROOT)
    failed = skipped = 0
    for part in parts:
        for test in importlib.import_module(part).TESTS:
            began, name = time.monotonic(), f'{part}: {test.__name__.replace("_", " ")}'
            try:
                said = test(t)
                print(f'ok      {name}{f": {said}" if said else ""} ({time.monotonic() - began:.1f} s)', flush=True)
            except Skipped as why:
                skipped += 1
                print(f'skipped {name}: {why}', flush=True)
            except Exception:  # pylint: disable=broad-except
                failed += 1
                print(f'FAILED  {name}', flush=True)
                traceback.print_exc()
    sys.exit(1 if failed else 3 if skipped else 0)


if __name__ == '__main__':
    main()
