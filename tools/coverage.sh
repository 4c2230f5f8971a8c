#!/usr/bin/env bash
# How much of what reads others' bytes the tests run: lines and branches of runtime/asset, runtime/unpack and
# tools/cook/gltf, without branches that only exceptions take. Writes build/coverage/report.html.
# usage: tools/coverage.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/install.sh tools/packages/build.txt tools/packages/test.txt tools/packages/coverage.txt
cmake -S . -B build/coverage -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 --coverage" -DMARROW_GLES=OFF >/dev/null
cmake --build build/coverage --target marrow_hostile marrow_cook_tests >/dev/null
find build/coverage -name '*.gcda' -delete
ctest --test-dir build/coverage -L hostile -j2 >build/coverage/tests.log || { tail -20 build/coverage/tests.log >&2; exit 1; }
build/coverage/tests/marrow_cook_tests --gtest_filter='CookLimits.*:-*Sample*' >>build/coverage/tests.log
gcovr --root . --exclude-throw-branches --exclude-unreachable-branches --gcov-ignore-parse-errors \
  --html-details build/coverage/report.html --json-summary build/coverage/summary.json \
  --filter 'runtime/asset/' --filter 'runtime/unpack/' --filter 'tools/cook/gltf/' build/coverage
python3 - <<'PYTHON'
import collections, json
sums = collections.defaultdict(lambda: [0, 0, 0, 0])
for f in json.load(open("build/coverage/summary.json"))["files"]:
    room = next(r for r in ("runtime/asset", "runtime/unpack", "tools/cook/gltf") if f["filename"].startswith(r))
    for i, key in enumerate(("line_covered", "line_total", "branch_covered", "branch_total")):
        sums[room][i] += f[key]
for room, (lines, line_total, branches, branch_total) in sorted(sums.items()):
    print(f"{room:16} {100 * lines / line_total:5.1f} % of {line_total} lines, "
          f"{100 * branches / branch_total:5.1f} % of {branch_total} branches")
PYTHON
