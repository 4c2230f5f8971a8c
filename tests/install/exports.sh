#!/usr/bin/env bash
# Compares what shared libraries export with what the headers beside them declare: each function, as often as it has
# overloads, and nothing else. Needs neither the libraries' sources nor the macro that marks a function.
# usage: exports.sh PREFIX       (where Marrow is installed, built with BUILD_SHARED_LIBS=ON)
set -euo pipefail
prefix=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A constructor is there twice, as a complete object and as a base.
exported() {
  for library in "$@"; do nm -D --defined-only -C "$library" | cut -d' ' -f3- | sort -u; done |
    sed -E 's/\(.*//; s/.*:://' | sort
}

python3 "$(dirname "$0")/../../tools/c_api" --exports "$prefix/include/marrow" | sort >"$work/declared"
exported "$prefix"/lib*/libmarrow_*.so >"$work/exported"
[ "$(wc -l <"$work/declared")" -gt 150 ] || { echo "exports: the headers declare next to nothing" >&2; exit 1; }
if ! diff "$work/declared" "$work/exported" >"$work/difference"; then
  sed -n 's/^< /exports: not exported: /p; s/^> /exports: exported, but in no header: /p' "$work/difference" >&2
  exit 1
fi
echo "$(wc -l <"$work/exported") functions are exported, all of them from the headers"
