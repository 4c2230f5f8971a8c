"""The .meta files of the Unity package: each asset's GUID, and how Unity imports it.

usage: metas.py write FOLDER    writes those that are missing below the package's folder
       metas.py check FOLDER    exit code 1 if one is missing, has no asset, or has another's GUID; or if
                                package.json or an .asmdef is wrong

A GUID that is written is a hash of the asset's path in the package, so it is the same in every build of the package.
"""
import hashlib
import json
import pathlib
import re
import sys

PACKAGE = 'com.marrow.animation'
# Folder below Plugins: platforms of Unity's, each with a processor, and the Editor's system.
PLUGINS = {
    'Linux/x86_64': ([('Standalone', 'Linux64', 'x86_64')], 'Linux'),
    'Windows/x86_64': ([('Standalone', 'Win64', 'x86_64')], 'Windows'),
    'macOS': ([('Standalone', 'OSXUniversal', 'AnyCPU')], 'OSX'),
    'Android/arm64-v8a': ([('Android', 'Android', 'ARM64')], None),
    'Android/armeabi-v7a': ([('Android', 'Android', 'ARMv7')], None),
    'Android/x86_64': ([('Android', 'Android', 'X86_64')], None),
    'iOS': ([('iPhone', 'iOS', None)], None),
}


def imported(folder):
    """Every file and folder that Unity imports: none whose name begins with a dot or ends with a tilde."""
    for path in sorted(folder.iterdir()):
        if path.name.startswith('.') or path.name.endswith(('~', '.meta')) or path.name in ('native', '__pycache__'):
            continue
        yield path
        if path.is_dir():
            yield from imported(path)


def platform_data(kind, name, enabled, settings):
    lines = ['  - first:', f'      {kind}: {name}', '    second:', f'      enabled: {int(bool(enabled))}']
    if not settings:
        return lines + ['      settings: {}']
    return lines + ['      settings:'] + [f'        {key}: {value}' for key, value in settings]


def plugin(path):
    folder = path.parent.as_posix().removeprefix('Plugins/')
    if folder not in PLUGINS:
        raise SystemExit(f'{path}: no such folder of plugins: there is {", ".join(PLUGINS)}')
    platforms, editor = PLUGINS[folder]
    preloaded = int('marrow_unity' in path.name)  # Unity calls UnityPluginLoad as it starts
    lines = ['PluginImporter:', '  externalObjects: {}', '  serializedVersion: 2', '  iconMap: {}',
             '  executionOrder: {}', '  defineConstraints: []', f'  isPreloaded: {preloaded}', '  isOverridable: 0',
             '  isExplicitlyReferenced: 0', '  validateReferences: 1', '  platformData:']
    lines += platform_data('Any', '', False, [])
    lines += platform_data('Editor', 'Editor', editor, [('CPU', platforms[0][2] or 'AnyCPU'),
                                                        ('DefaultValueInitialized', 'true'), ('OS', editor or 'AnyOS')])
    for kind, name, processor in platforms:
        lines += platform_data(kind, name, True, [('CPU', processor)] if processor else [])
    return lines


def importer(path, is_folder):
    if is_folder:
        return ['folderAsset: yes', 'DefaultImporter:', '  externalObjects: {}']
    if path.parts[0] == 'Plugins':
        return plugin(path)
    if path.suffix == '.cs':
        return ['MonoImporter:', '  externalObjects: {}', '  serializedVersion: 2', '  defaultReferences: []',
                '  executionOrder: 0', '  icon: {instanceID: 0}']
    name = {'.asmdef': 'AssemblyDefinitionImporter', '.md': 'TextScriptImporter'}.get(path.suffix, 'DefaultImporter')
    return [('PackageManifestImporter' if path.name == 'package.json' else name) + ':', '  externalObjects: {}']


def write(folder):
    for path in list(imported(folder)):
        meta = path.with_name(path.name + '.meta')
        if meta.exists():
            continue
        inside = path.relative_to(folder)
        guid = hashlib.md5(f'{PACKAGE}/{inside.as_posix()}'.encode()).hexdigest()
        lines = ['fileFormatVersion: 2', f'guid: {guid}', *importer(inside, path.is_dir()), '  userData: ',
                 '  assetBundleName: ', '  assetBundleVariant: ']
        meta.write_text('\n'.join(lines) + '\n')


def check_metas(folder):
    guids, wrong = {}, []
    there = {path.with_name(path.name + '.meta'): path for path in imported(folder)}
    for meta in sorted(folder.rglob('*.meta')):
        if meta not in there:
            wrong.append(f'{meta}: of nothing that Unity imports: remove it')
    for meta, path in there.items():
        if not meta.exists():
            wrong.append(f'{path}: has no .meta: run python3 tools/unity/metas.py write platform/unity')
            continue
        guid = re.search(r'^guid: ([0-9a-f]{32})$', meta.read_text(), re.M)
        if not guid:
            wrong.append(f'{meta}: has no GUID of 32 hexadecimal digits')
        elif guid[1] in guids:
            wrong.append(f'{meta}: has the GUID of {guids[guid[1]]}')
        else:
            guids[guid[1]] = meta
    return wrong, len(guids)


def check_manifests(folder):
    wrong = []
    manifest = json.loads((folder / 'package.json').read_text())
    version = '.'.join(re.findall(r'_(?:MAJOR|MINOR|PATCH) (\d+)',
                                  (pathlib.Path(__file__).parents[2] / 'runtime/include/marrow/version.h').read_text()))
    if manifest['name'] != PACKAGE:
        wrong.append(f'package.json: is called {manifest["name"]}, not {PACKAGE}')
    if manifest['version'] != version:
        wrong.append(f'package.json: the version {manifest["version"]} is not that of version.h')
    for sample in manifest['samples']:
        if not list((folder / sample['path']).glob('*.cs')):
            wrong.append(f'package.json: the sample {sample["path"]} is not there')
    assemblies = {path: json.loads(path.read_text()) for path in sorted(folder.rglob('*.asmdef'))}
    names = [made['name'] for made in assemblies.values()]
    for path, made in assemblies.items():
        if made['name'] != path.stem:
            wrong.append(f'{path}: is called {made["name"]}')
        for reference in made['references']:
            if reference not in names:
                wrong.append(f'{path}: refers to {reference}, which is not there')
        sources = '\n'.join(source.read_text() for source in path.parent.rglob('*.cs'))
        if made['noEngineReferences'] and re.search(r'\busing Unity', sources):
            wrong.append(f'{path}: has noEngineReferences, and a source of it uses UnityEngine')
        if not made['allowUnsafeCode'] and re.search(r'\bunsafe\b', sources):
            wrong.append(f'{path}: needs allowUnsafeCode')
        if 'using UnityEditor' in sources and made['includePlatforms'] != ['Editor']:
            wrong.append(f'{path}: uses UnityEditor, so includePlatforms must be Editor')
    return wrong, len(assemblies)


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ('write', 'check'):
        raise SystemExit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    if sys.argv[1] == 'write':
        write(folder)
        return 0
    wrong, metas = check_metas(folder)
    wrong_too, assemblies = check_manifests(folder)
    for line in wrong + wrong_too:
        print(line, file=sys.stderr)
    if not wrong + wrong_too:
        print(f'{metas} GUIDs, {assemblies} assemblies: right')
    return int(bool(wrong + wrong_too))


sys.exit(main())
