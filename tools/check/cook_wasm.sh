#!/usr/bin/env bash
# Builds the cooker for WebAssembly, cooks with it in node, and compares with what the program writes and refuses; then
# the page's worker. See docs/cooking/library.md. Exit 1 if anything differs or cook.wasm has grown beyond its limit, 3 if
# a compiler, npm or the sources of Draco and meshoptimizer cannot be had. Builds in build/wasm.
# usage: tools/check/cook_wasm.sh MARROW [all]   (the program; all: each model of MARROW_ASSETS and each bad input of
#                                                 MARROW_CORPUS, not some of them)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
form=${2:-short}
work="$here/build/cook-wasm"
most=1500000  # bytes of cook.wasm as brotli sends it

for tool in node npm brotli; do command -v "$tool" >/dev/null || "$here/tools/install.sh" "$here/tools/packages/cook-wasm.txt" || true; done
for tool in node npm brotli; do command -v "$tool" >/dev/null || { echo "check/cook_wasm: there is no $tool" >&2; exit 3; }; done
mkdir -p "$work"
wasm=$("$here/tools/wasm.sh" cook) || exit $?
sent=$(brotli -q 11 -c "$wasm" | wc -c)
echo "cook.wasm: $(wc -c <"$wasm") B, $sent B by brotli"
[ "$sent" -le $most ] || { echo "check/cook_wasm: cook.wasm is more than $most B by brotli" >&2; exit 1; }

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { tail -n 60 "$work/log.txt" >&2; exit 1; }
}
folders=("$here/tools/sample")
for folder in "${MARROW_ASSETS:-$here/../shared/assets}" "${MARROW_CORPUS:-$here/../shared/corpus}"; do
  if [ -d "$folder" ]; then folders+=("$folder"); else echo "check/cook_wasm: no folder $folder" >&2; fi
done
node "$here/tools/check/cook_wasm.mjs" "$marrow" "$wasm" "$form" "${folders[@]}"

# Where memory ends, that is said. The stack alone has 128 pages of 64 KiB.
said=$(node --wasm-max-mem-pages=150 "$here/tools/cook/wasm.mjs" "$wasm" "$here/tools/sample/newt.glb" "$work/no.mrw" 2>&1) && said=nothing
[[ "$said" == *"newt.glb: out of memory at "* ]] || { echo "check/cook_wasm: without memory it says: $said" >&2; exit 1; }

# The worker that a page has, with the types of what it says.
page="$work/page"
mkdir -p "$page/check"
if [ ! -x "$page/node_modules/.bin/tsc" ] || ! cmp -s "$here/tools/page/package.json" "$page/package.json"; then
  cp "$here/tools/page/package.json" "$page"
  npm install --silent --no-audit --no-fund --no-package-lock --prefix "$page" >/dev/null 2>&1 ||
    { echo "check/cook_wasm: npm cannot be reached" >&2; exit 3; }
fi
quietly "$page/node_modules/.bin/esbuild" "$here"/tools/page/src/{cooker,cook_worker}.ts --bundle --format=esm --target=es2022 \
  --outdir="$page/site" --log-level=warning
cp "$wasm" "$page/site"
echo '{"type": "module"}' >"$page/site/package.json"
newt="$here/tools/sample/newt.glb"
"$marrow" cook "$newt" -o "$work/newt.mrw" >/dev/null 2>&1
node "$here/tools/page/check_cooker.mjs" "$page/site" "$newt" "$work/newt.mrw"
node "$here/tools/page/check_report.mjs" "$page/site/newt.json" "$page/check/report.ts"
cat >"$page/check/tsconfig.json" <<END
{"extends": "$here/tools/page/tsconfig.json", "include": ["report.ts", "$here/tools/page/src/cook_worker.ts"]}
END
quietly "$page/node_modules/.bin/tsc" -p "$page/check"
