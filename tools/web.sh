#!/usr/bin/env bash
# Builds the page on which one drops a model, as a folder that any server of files can give, build/web, and beside it the
# package for npm, build/web-package. Exit 3 if a compiler or npm cannot be had. MARROW_SAMPLE: the sample, cooked before.
# usage: tools/web.sh MARROW [FOLDER]   (the program, which cooks the sample; with a folder the page alone goes there)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
marrow=$(realpath "$1")
out="${2:-$here/build/web}"
packages="$here/build/page"

command -v npm >/dev/null || "$here/tools/install.sh" "$here/tools/packages/page.txt" || true
for tool in npm node; do command -v "$tool" >/dev/null || { echo "web: there is no $tool" >&2; exit 3; }; done
mkdir -p "$out" "$packages"
if ! cmp -s "$here/tools/page/package.json" "$packages/package.json" || [ ! -d "$packages/node_modules/esbuild" ]; then
  cp "$here/tools/page/package.json" "$packages/"
  npm install --prefix "$packages" --no-audit --no-fund --no-package-lock >"$packages/log.txt" 2>&1 ||
    { echo "web: npm cannot fetch $(paste -sd ' ' <"$packages/log.txt" | head -c 300)" >&2; exit 3; }
fi
"$packages/node_modules/.bin/tsc" -p "$here/tools/page"

built=$("$here/tools/wasm.sh" viewer cook) || exit $?
while IFS= read -r file; do cp "$file" "$out/"; done <<<"$built"
node "$here/tools/page/build.mjs" "$packages" "$out"

# Beside the cooked sample what it is cooked from, for who cooks it again there.
sample=("$here"/tools/sample/{newt.glb,newt_moves.glb,newt.anim.toml})
if [ -n "${MARROW_SAMPLE:-}" ]; then
  cp "$MARROW_SAMPLE" "$out/newt.mrw"
else
  "$marrow" cook "${sample[0]}" --retarget "${sample[1]}" --graph "${sample[2]}" --mirror turn_right=turn_left --root '*=ground' --as fit --truth elastic \
    --cache "$here/build/cache" -o "$out/newt.mrw" >/dev/null 2>&1
fi
# As any engine would draw it.
"$marrow" cook "${sample[0]}" --retarget "${sample[1]}" --root '*=ground' --clip-error 2mm -o "$out/newt_plain.mrw" >/dev/null 2>&1
cp "${sample[@]}" "$out/"
echo "$out: open it by a server of files, as by: python3 -m http.server -d $out"
[ -n "${2:-}" ] || "$here/tools/web/package.sh"
