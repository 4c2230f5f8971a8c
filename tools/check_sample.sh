#!/usr/bin/env bash
# Runs the Khronos glTF validator over the sample; exit 3 if npm or the network is missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
modules="$here/build/gltf-validator"
if [ ! -d "$modules/node_modules/gltf-validator" ]; then
  command -v npm >/dev/null || { echo "check_sample: npm is not installed" >&2; exit 3; }
  mkdir -p "$modules"
  npm install --silent --no-audit --no-fund --prefix "$modules" gltf-validator@2.0.0-dev.3.10 >/dev/null 2>&1 ||
    { echo "check_sample: npm cannot be reached" >&2; exit 3; }
fi
cd "$modules"
node -e '
const fs = require("fs"), validator = require("gltf-validator");
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then((report) => {
  const { numErrors, numWarnings, messages } = report.issues;
  console.error(`gltf-validator: ${numErrors} errors, ${numWarnings} warnings`);
  if (numErrors) console.error(JSON.stringify(messages.slice(0, 10), null, 1));
  process.exit(numErrors ? 1 : 0);
});' "$here/tools/sample/newt.glb"
