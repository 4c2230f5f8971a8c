#!/usr/bin/env bash
# Builds the page on which one drops a model, and tries it in a headless Chromium: the first picture, keys and fingers,
# models against the program's bytes and pictures, files that are wrong, a lost context, memory, and who uses it otherwise;
# tests/page has the tests. Exit 1 if one fails, 3 if a compiler, npm or Chromium cannot be had. MARROW_TESTS=all: with
# what takes minutes. Builds in build/wasm, build/page and build/web.
# usage: tools/check/page.sh MARROW [TEST ...]      (the program; files of tests/page by their names)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
shift

"$here/tools/install.sh" "$here/tools/packages/page.txt" || true
command -v chromium >/dev/null || { echo "check/page: there is no chromium" >&2; exit 3; }
"$here/tools/web.sh" "$marrow" "$here/build/web"
MARROW_CHROMIUM=$(command -v chromium) node "$here/tests/page/run.mjs" "$marrow" "$here/build/web" "$here/build/page" "$@"
