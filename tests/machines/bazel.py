"""The rules for Bazel, in a workspace of their own."""
import os
import re
import shutil
import subprocess

from common import empty, expect_same, files_of, make_models, needed, nginx, run


class Workspace:
    def __init__(self, t, name):
        needed('bazel')
        self.t, self.folder = t, empty(t.work / name)
        # Kept for all tests: a server of Bazel takes seconds to come up.
        self.output = t.work / 'bazel-output'
        shutil.copytree(t.root / 'tools/farm/bazel', self.folder / 'rules')
        (self.folder / 'WORKSPACE').write_text(
            'local_repository(name = "rules_marrow", path = "rules")\n'
            'load("@rules_marrow//:defs.bzl", "marrow_program")\n'
            f'marrow_program(name = "marrow", path = "{t.marrow}")\n')
        (self.folder / '.bazelignore').write_text('rules\n')

    def bazel(self, *arguments, code=0):
        return run('bazel', f'--output_user_root={self.output}', '--max_idle_secs=60', *arguments, cwd=self.folder, code=code,
                   env={**os.environ, 'USER': 'nobody'})

    def build(self, *arguments, code=0):
        """How many actions cooked, and how many results came from a cache of Bazel's."""
        done = self.bazel('build', '//...', '--noshow_progress', '--color=no', '--spawn_strategy=sandboxed',
                          '--incompatible_strict_action_env', *arguments, code=code)
        said = re.findall(r'(\d+) (processwrapper-sandbox|linux-sandbox|(?:disk|remote) cache hit)', done.stderr)
        return {('cooked' if 'sandbox' in kind else 'cache'): int(count) for count, kind in said}, done

    def cooked(self, library):
        return self.folder / 'bazel-bin' / library


def fill(workspace, count=8):
    t, folder = workspace.t, workspace.folder
    make_models(folder / 'in', count)
    shutil.copy(t.root / 'tools/sample/newt.glb', folder / 'newt.glb')
    (folder / 'marrow.toml').write_text('clip-error = "0.5mm"\n')
    (folder / 'BUILD').write_text(
        'load("@rules_marrow//:defs.bzl", "marrow_asset", "marrow_library")\n'
        'marrow_library(name = "worms", srcs = glob(["in/**/*.glb"]), settings = "marrow.toml")\n'
        'marrow_asset(name = "newt", src = "newt.glb", data = ["newt.anim.toml"],\n'
        '             options = ["--graph", "$(location newt.anim.toml)", "--root", "*=ground"])\n')
    shutil.copy(t.root / 'tools/sample/newt.anim.toml', folder)


def the_bytes_of_the_program(t):
    workspace = Workspace(t, 'bazel')
    fill(workspace)
    counts, done = workspace.build('--output_groups=+report')
    assert counts.get('cooked') == 9, (counts, done.stderr)
    run(t.marrow, 'cook', workspace.folder / 'in', '-o', workspace.folder / 'want', '--settings', workspace.folder / 'marrow.toml')
    for name in files_of(workspace.folder / 'want'):
        assert (workspace.folder / 'want' / name).read_bytes() == (workspace.cooked('worms/in') / name).read_bytes(), name
    want = workspace.folder / 'newt_want.mrw'
    (workspace.folder / 'none.toml').write_text('')
    run(t.marrow, 'cook', workspace.folder / 'newt.glb', '-o', want, '--settings', workspace.folder / 'none.toml', '--graph',
        workspace.folder / 'newt.anim.toml', '--root', '*=ground')
    assert want.read_bytes() == workspace.cooked('newt.mrw').read_bytes()
    reports = sorted((workspace.folder / 'bazel-bin/worms/in').rglob('*.report.json'))
    run(t.marrow, 'report', '--merge', *reports, '-o', workspace.folder / 'all.html')

    assert workspace.build()[0] == {}, 'nothing has changed'
    (workspace.folder / 'in/000/000003.glb').write_bytes((workspace.folder / 'in/000/000004.glb').read_bytes())
    counts, _ = workspace.build()
    assert counts.get('cooked') == 1, counts
    # A settings file that no rule names does not count: actions see what is named.
    (workspace.folder / 'in/marrow.toml').write_text('clip-eror = "typo"\n')
    assert workspace.build()[0] == {}
    (workspace.folder / 'in/000/000005.glb').write_bytes(b'glTF')
    _, done = workspace.build(code=1)
    assert '000005.glb: ' in done.stderr, done.stderr
    return 'one changed file cooks alone'


def caches_of_bazel(t):
    workspace = Workspace(t, 'bazel-caches')
    fill(workspace, 4)
    disk = f'--disk_cache={empty(t.work / "bazel-disk")}'
    assert workspace.build(disk)[0].get('cooked') == 5
    workspace.bazel('clean')
    counts, _ = workspace.build(disk)
    assert counts == {'cache': 5}, counts
    with nginx(empty(t.work / 'bazel-nginx'), 'dav_methods PUT; create_full_put_path on;') as address:
        workspace.bazel('clean')
        assert workspace.build(f'--remote_cache={address}')[0].get('cooked') == 5
        other = Workspace(t, 'bazel-other')
        fill(other, 4)
        counts, _ = other.build(f'--remote_cache={address}')
        assert counts == {'cache': 5}, counts
        expect_same(workspace.cooked('worms/in'), other.cooked('worms/in'))
    for one in (workspace, other):
        subprocess.run(['bazel', f'--output_user_root={one.output}', 'shutdown'], cwd=one.folder, capture_output=True, check=False)
    return 'another workspace takes all five from nginx'


TESTS = [the_bytes_of_the_program, caches_of_bazel]
