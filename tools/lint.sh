#!/usr/bin/env bash
# Runs clang-tidy over the runtime and the tools, with the settings of .clang-tidy.
# usage: tools/lint.sh [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake --preset dev >/dev/null
[ $# -gt 0 ] || set -- $(git ls-files 'runtime/*.cpp' 'platform/*.cpp' 'tools/*.cpp' ':!platform/web')  # that is for Emscripten
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 clang-tidy -p build/dev --quiet
