#!/usr/bin/env bash
# Runs the Khronos glTF validator over GLB files, and over the images beside them that they name; exit 1 if one has errors, 3 if npm or the network is missing.
# usage: tools/validate_gltf.sh FILE.glb ...
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
modules="$here/build/gltf-validator"
if [ ! -d "$modules/node_modules/gltf-validator" ]; then
  command -v npm >/dev/null || { echo "validate_gltf: npm is not installed" >&2; exit 3; }
  mkdir -p "$modules"
  npm install --silent --no-audit --no-fund --prefix "$modules" gltf-validator@2.0.0-dev.3.10 >/dev/null 2>&1 ||
    { echo "validate_gltf: npm cannot be reached" >&2; exit 3; }
fi
NODE_PATH="$modules/node_modules" node -e '
const fs = require("fs"), path = require("path"), validator = require("gltf-validator");
(async () => {
  let errors = 0, warnings = 0;
  for (const file of process.argv.slice(1)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
      maxIssues: 1000,
      externalResourceFunction: async (uri) =>
        new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))),
    });
    const { numErrors, numWarnings, messages } = report.issues;
    errors += numErrors;
    warnings += numWarnings;
    for (const m of messages.filter((m) => m.severity < 2).slice(0, 10))
      console.error(`${file}: ${m.pointer}: ${m.severity ? "warning" : "error"}: ${m.code}: ${m.message}`);
  }
  console.error(`gltf-validator: ${process.argv.length - 1} files, ${errors} errors, ${warnings} warnings`);
  process.exit(errors || process.argv.length < 2 ? 1 : 0);
})();' "$@"
