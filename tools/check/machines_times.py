#!/usr/bin/env python3
"""Measures what engines take to cook 2 000 files on two cores, and what they take when nothing has changed.

usage: machines_times.py MARROW [COUNT [TINY]]     2 000 files, and 10 000 tiny ones

Perfect packing is the seconds that one thread takes for all files in one process, over two. docs/cooking/many_machines.md has
the table. Engines that are not there are left out, and told.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'tests/machines'))
# pylint: disable=wrong-import-position
from bazel import Workspace
from common import Skipped, empty, files_of, make_models, nginx, run
from slurm import Cluster
import types


def timed(what):
    began = time.monotonic()
    what()
    return time.monotonic() - began


def processes(*commands):
    for one in [subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL) for command in commands]:
        assert one.wait() == 0


def write_ninja(t, folder, names, out):
    rule = (f'rule cook\n  command = {t.marrow} cook $in -o $out --jobs 1 --depfile $out.d\n  depfile = $out.d\n  deps = gcc\n')
    builds = ''.join(f'build {out}/{pathlib.Path(name).with_suffix(".mrw")}: cook {folder}/{name}\n' for name in names)
    (out / 'build.ninja').write_text(rule + builds)
    return out / 'build.ninja'


def with_ninja(t):
    out = empty(t.work / 'ninja')
    file = write_ninja(t, t.models, files_of(t.models), out)
    return timed(lambda: run('ninja', '-f', file, '-j2', cwd=out))


def with_bazel(t):
    workspace = Workspace(t, 'times')
    shutil.copytree(t.models, workspace.folder / 'in')
    (workspace.folder / 'BUILD').write_text('load("@rules_marrow//:defs.bzl", "marrow_library")\n'
                                            'marrow_library(name = "all", srcs = glob(["in/**/*.glb"]))\n')
    workspace.bazel('build', '--nobuild', '//...')
    first = timed(lambda: workspace.build('--jobs=2'))
    again = timed(lambda: workspace.build('--jobs=2'))
    workspace.bazel('shutdown')
    print(f'  bazel, nothing changed: {again:.2f} s')
    return first


def with_slurm(t):
    with Cluster(t.work / 'slurm') as cluster:
        def cook():
            last = cluster.submit(t, 16, cluster.folder / 'farm', t.models, '-o', cluster.folder / 'out',
                                  '--cache', cluster.folder / 'cache')
            cluster.wait(last, 3600)
        return timed(cook)


def cold(t):
    report, plan = t.work / 'one.json', t.work / 'plan.json'
    took = timed(lambda: run(t.marrow, 'cook', t.models, '-o', t.work / 'one', '--jobs', '1', '--report', report))
    perfect = took / 2
    print(f'{len(files_of(t.models))} files: {took:.1f} s on one thread, perfect packing {perfect:.1f} s')
    planned = timed(lambda: run(t.marrow, 'cook', t.models, '-o', t.work / 'out', '--plan', plan, '--history', report))
    print(f'  the plan itself: {planned:.1f} s')
    cook = [t.marrow, 'cook', t.models, '-o']
    ways = {
        'marrow cook': lambda: timed(lambda: run(*cook, empty(t.work / 'threads'), '--jobs', '2')),
        'two shards, by size': lambda: timed(lambda: processes(
            *([*cook, t.work / 'two', '--jobs', '1', '--shard', f'{i}/2'] for i in (1, 2)))),
        'two shards, by history': lambda: timed(lambda: processes(
            *([*cook, t.work / 'two', '--jobs', '1', '--shard', f'{i}/2', '--history', report] for i in (1, 2)))),
        'ninja': lambda: with_ninja(t), 'Bazel': lambda: with_bazel(t), 'Slurm': lambda: with_slurm(t)}
    for name, way in ways.items():
        try:
            seconds = way()
            print(f'  {name}: {seconds:.1f} s, {seconds / perfect:.2f} of perfect', flush=True)
        except Skipped as why:
            print(f'  {name}: {why}')
    print(run(sys.executable, ROOT / 'tools/farm/simulate.py', plan).stdout)


def write_tiny(folder, count):
    scene = json.loads((ROOT / 'tests/golden/tiny.gltf').read_text())
    for i in range(count):
        scene['nodes'][0]['name'] = f'n{i}'
        path = folder / f'{i // 500:02}' / f'{i:05}.gltf'
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(scene))
        if i % 500 == 0:
            for beside in (ROOT / 'tests/golden').glob('tiny*.bin'):
                shutil.copy(beside, path.parent)


def warm(t, count):
    tiny = empty(t.work / 'tiny')
    write_tiny(tiny, count)
    local = [t.marrow, 'cook', tiny, '-o', t.work / 'tiny-out', '--cache', t.work / 'tiny-cache']
    first = timed(lambda: run(*local))
    print(f'{count} tiny files: {first:.1f} s, with the cache warm {min(timed(lambda: run(*local)) for _ in range(3)):.2f} s')
    out = empty(t.work / 'tiny-ninja')
    file = write_ninja(t, tiny, [name for name in files_of(tiny) if name.endswith('.gltf')], out)
    first = timed(lambda: run('ninja', '-f', file, '-j2', cwd=out))
    again = min(timed(lambda: run('ninja', '-f', file, '-j2', cwd=out)) for _ in range(3))
    print(f'  ninja: {first:.1f} s, nothing changed {again:.2f} s')
    with nginx(empty(t.work / 'tiny-nginx'), 'dav_methods PUT; create_full_put_path on;') as address:
        server = [*local[:-1], address]
        filled = timed(lambda: run(*server))
        print(f'  nginx: filled in {filled:.1f} s, warm {min(timed(lambda: run(*server)) for _ in range(2)):.2f} s')


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    tiny = int(sys.argv[3]) if len(sys.argv) > 3 else 10000
    with tempfile.TemporaryDirectory() as work:
        t = types.SimpleNamespace(marrow=pathlib.Path(sys.argv[1]).resolve(), work=pathlib.Path(work), root=ROOT)
        os.chmod(work, 0o755)
        t.models = t.work / 'models'
        if tiny > 0:
            warm(t, tiny)
        if count > 0:
            make_models(t.models, count)
            cold(t)


if __name__ == '__main__':
    main()
