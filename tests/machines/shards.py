"""Shares of the work, each as if by a machine of its own."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

from common import empty, expect_same, files_of, make_models, run

NEWT = ['--as', 'fit', '--truth', 'delta-mush']


def together_they_are_one_run(t):
    folder = empty(t.work / 'shards')
    make_models(folder / 'in', 23)
    (folder / 'in/bad.glb').write_bytes(b'glTF')
    one = run(t.marrow, 'cook', folder / 'in', '-o', folder / 'want', '--report', folder / 'want.json', code=3)
    reports = []
    for count in (1, 2, 7, 40):
        empty(folder / 'out')
        for number in range(1, count + 1):
            report = folder / f'{count}-{number}.json'
            done = subprocess.run([t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--shard', f'{number}/{count}',
                                   '--report', report], capture_output=True, text=True)
            assert done.returncode in (0, 3), done.stderr
            reports.append(report)
        expect_same(folder / 'want', folder / 'out')
        merged = folder / 'merged.json'
        done = run(t.marrow, 'report', '--merge', *reports[-count:], '-o', merged, code=3)
        assert done.stderr == one.stderr, 'the same failure'
        names = [report['source']['file'] for report in json.loads(merged.read_text())]
        assert names == sorted(report['source']['file'] for report in json.loads((folder / 'want.json').read_text()))
    for wrong in ('0/2', '3/2', '1', '1/', 'a/b', '1/2/3', '-1/2'):
        run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--shard', wrong, code=1)
    return '24 files in 1, 2, 7 and 40 shares'


def the_plan_foretells(t):
    folder = empty(t.work / 'plan')
    make_models(folder / 'in', 40)
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--jobs', '1', '--report', folder / 'r.json')
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'none', '--plan', folder / 'p.json')
    assert not (folder / 'none').exists(), 'a plan cooks nothing'
    plan = json.loads((folder / 'p.json').read_text())
    seconds = [unit['seconds'] for unit in plan['units']]
    assert seconds == sorted(seconds, reverse=True) and len(seconds) == 40
    took = {report['source']['file']: report['run']['cooking_s'] for report in json.loads((folder / 'r.json').read_text())}

    def worst(history):
        shares = []
        for number in (1, 2, 3, 4):
            report = folder / f's{number}.json'
            run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--shard', f'{number}/4', '--report', report, *history)
            shares.append(sum(took[r['source']['file']] for r in json.loads(report.read_text())))
        return max(shares) * 4 / sum(shares)

    by_size, by_history = worst([]), worst(['--history', folder / 'r.json'])
    assert by_history < 1.05 and by_size < 1.5, (by_history, by_size)
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--plan', folder / 'p.json', '--history', folder / 'r.json')
    plan = json.loads((folder / 'p.json').read_text())
    assert all(unit['seconds_from'] == 'history' for unit in plan['units'])
    return f'the longest of 4 shares is {by_size:.2f} of the mean by size, {by_history:.2f} by history'


def fits_are_units(t):
    folder = empty(t.work / 'fits')
    shutil.copy(t.root / 'tools/sample/newt.glb', folder / 'newt.glb')
    arguments = [folder / 'newt.glb', '--as', 'fit', '--truth', 'delta-mush']
    run(t.marrow, 'cook', *arguments, '-o', folder / 'want.mrw')
    run(t.marrow, 'cook', *arguments, '-o', folder / 'out.mrw', '--plan', folder / 'p.json')
    fits = json.loads((folder / 'p.json').read_text())['units'][0]['fits']
    assert fits and all(fit['vertices'] > 0 and fit['seconds'] > 0 for fit in fits), fits
    cache = empty(folder / 'cache')
    for number in (1, 2):
        run(t.marrow, 'cook', *arguments, '-o', folder / 'out.mrw', '--fits', '--cache', cache, '--shard', f'{number}/2')
    kept = [name for name in files_of(cache) if name.endswith('.fit')]
    assert len(kept) == len(fits) and not (folder / 'out.mrw').exists()
    began = time.monotonic()
    run(t.marrow, 'cook', *arguments, '-o', folder / 'out.mrw', '--cache', cache)
    with_fits = time.monotonic() - began
    assert (folder / 'want.mrw').read_bytes() == (folder / 'out.mrw').read_bytes()
    # What is no fit of the mesh is learnt anew.
    for name in kept:
        body = (cache / name).read_bytes()
        (cache / name).write_bytes(body[:-1] + bytes([body[-1] ^ 1]))
    run(t.marrow, 'cook', *arguments, '-o', folder / 'out.mrw', '--cache', cache, '--clip-error', '0.2mm')
    run(t.marrow, 'cook', *arguments, '-o', folder / 'want.mrw', '--clip-error', '0.2mm')
    assert (folder / 'want.mrw').read_bytes() == (folder / 'out.mrw').read_bytes()
    return f'{len(fits)} fits; cooking with them {with_fits:.1f} s'


def killed(t):
    """A worker that is killed leaves whole files or none, and the next does the rest."""
    folder = empty(t.work / 'killed')
    make_models(folder / 'in', 30)
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'want')
    kills = 0
    for seconds in (0.02, 0.1, 0.3, 0.6, 1.0):
        worker = subprocess.Popen([t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache'],
                                  stdout=subprocess.DEVNULL)
        time.sleep(seconds)
        worker.send_signal(signal.SIGKILL)
        kills += worker.wait() == -signal.SIGKILL
        for name in files_of(folder / 'out') if (folder / 'out').exists() else []:
            if not pathlib.Path(name).name.startswith('.'):
                assert (folder / 'out' / name).read_bytes() == (folder / 'want' / name).read_bytes(), name
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache')
    for name in files_of(folder / 'out'):
        if pathlib.Path(name).name.startswith('.'):
            os.remove(folder / 'out' / name)
    expect_same(folder / 'want', folder / 'out')
    assert kills >= 2
    return f'{kills} killed'


def two_with_one_unit(t):
    folder = empty(t.work / 'twice')
    make_models(folder / 'in', 12)
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'want')
    workers = [subprocess.Popen([t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache'],
                                stdout=subprocess.DEVNULL) for _ in range(3)]
    assert [worker.wait() for worker in workers] == [0, 0, 0]
    return f'{expect_same(folder / "want", folder / "out")} files by 3 workers'


def clocks_that_differ(t):
    """Times decide nothing: sources and entries from next year, and from the last century."""
    folder = empty(t.work / 'clocks')
    make_models(folder / 'in', 6)
    cook = [t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache']
    run(*cook)
    before = {name: (folder / 'out' / name).read_bytes() for name in files_of(folder / 'out')}
    for year in (1980, 2035):
        when = (year - 1970) * 365.25 * 86400
        for place in ('in', 'out', 'cache'):
            for name in files_of(folder / place):
                os.utime(folder / place / name, (when, when))
        assert '6 from the cache' in run(*cook).stdout
    changed = folder / 'in/000/000003.glb'
    other = (folder / 'in/000/000004.glb').read_bytes()
    changed.write_bytes(other)
    os.utime(changed, (0, 0))  # as from before all
    done = run(*cook)
    assert (folder / 'out/000/000003.mrw').read_bytes() == before['000/000004.mrw'], done.stdout


def another_program(t):
    """Units know the program: another one refuses, and takes nothing from the cache."""
    folder = empty(t.work / 'program')
    make_models(folder / 'in', 4)
    run(t.marrow, 'cook', folder / 'in', '-o', folder / 'out', '--plan', folder / 'p.json')
    program = json.loads((folder / 'p.json').read_text())['program']
    other = folder / 'marrow'
    shutil.copy(t.marrow, other)
    with open(other, 'ab') as file:
        file.write(b'\0')
    cook = ['cook', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache', '--program', program]
    run(t.marrow, *cook, '--shard', '1/2', '--report', folder / '1.json')
    refused = run(other, *cook, '--shard', '2/2', '--report', folder / '2.json', code=1)
    assert 'another program' in refused.stderr and not (folder / '2.json').exists()
    done = run(other, *cook[:-2], '--shard', '2/2', '--report', folder / '2.json')
    assert '0 from the cache' in done.stdout
    merged = run(t.marrow, 'report', '--merge', folder / '1.json', folder / '2.json', '-o', folder / 'm.json', code=3)
    assert '2 programs have cooked these files' in merged.stderr, merged.stderr
    missing = run(t.marrow, 'report', '--merge', folder / '1.json', '-o', folder / 'm.html', code=3)
    assert '2 of 4 files are in no report' in missing.stderr, missing.stderr


TESTS = [together_they_are_one_run, the_plan_foretells, fits_are_units, killed, two_with_one_unit, clocks_that_differ,
         another_program]
