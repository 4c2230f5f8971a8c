#!/usr/bin/env bash
# Makes a release of the commit that is checked out: sees that all agrees on its version, and writes archives with
# checksums to a new folder: the sources, the amalgamation, the bindings for Rust, C# and JavaScript. Tags nothing and
# pushes nothing: docs/versions.md.
# usage: tools/release.sh OUTDIR [--test]      (--test: all tests first, more than an hour)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# -ge 1 ] && [ "${2:---test}" = --test ] || { sed -n '5s/^# //p' "$0" >&2; exit 1; }
fail() { echo "release: $*" >&2; exit 1; }
[ ! -e "$1" ] || fail "$1 is there already: name a new folder"
out=$(realpath -m "$1")
cd "$here"

number() { awk -v name="$1" '$1 == "#define" && $2 == name { print $3 }' runtime/include/marrow/version.h; }
minor=$(number MARROW_VERSION_MAJOR).$(number MARROW_VERSION_MINOR)
version=$minor.$(number MARROW_VERSION_PATCH)

[ -z "$(git status --porcelain)" ] || fail "there are changes that are not committed"
if git rev-parse -q --verify "refs/tags/v$version" >/dev/null && ! git tag --points-at HEAD | grep -qx "v$version"; then
  fail "v$version is released already: set the next version in runtime/include/marrow/version.h"
fi
entry=$(awk -v heading="## $version" '/^## / { here = $0 == heading; next } here' CHANGELOG.md)
[ -n "$entry" ] || fail "CHANGELOG.md has no entry $version"
formats="Cooked files: format $(number MARROW_FILE_FORMAT). Packed files: format $(number MARROW_PACKED_FORMAT)."
grep -qF "$formats" <<<"$entry" || fail "CHANGELOG.md does not say of $version: $formats"
grep -qF "\"version-semver\": \"$version\"" tools/packaging/vcpkg/vcpkg.json ||
  fail "the vcpkg port has another version"
! grep -n 'find_package(marrow [0-9]' docs/install.md | grep -v "marrow $minor " ||
  fail "docs/install.md has another version"

if [ "${2:-}" = --test ]; then
  tools/test.sh all
fi

name=marrow-$version
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git archive --format=tar --prefix="$name/" HEAD | gzip -n -9 >"$out/$name.tar.gz"
tools/amalgamate.sh "$work/$name-amalgamated" >/dev/null
python3 tools/c_api --bindings "$work/$name-bindings"
for archive in amalgamated bindings; do
  cp LICENSE THIRD_PARTY.md CHANGELOG.md "$work/$name-$archive"
  tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" -cf - \
    "$name-$archive" | gzip -n -9 >"$out/$name-$archive.tar.gz"
done
(cd "$out" && sha256sum ./*.tar.gz >SHA256SUMS)
printf '%s\n' "$entry" | sed '/./,$!d' >"$out/CHANGES.md"
ls -l "$out"
