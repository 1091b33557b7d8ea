#!/usr/bin/env bash
# Build the wheel, install it into an empty environment, and use it there, far from the source.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools=$PWD/.venv/bin
source_version=$("$tools/python" -c 'import maestra; print(maestra.__version__)')

room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

"$tools/python" -m build --no-isolation --wheel --outdir "$room/dist" . >"$room/build.log" 2>&1 ||
    { cat "$room/build.log"; exit 1; }
wheel=$(echo "$room"/dist/maestra-*.whl)
echo "$(basename "$wheel"), $(du -k "$wheel" | cut -f 1) kB"

"$tools/python" -m venv "$room/env"
"$room/env/bin/python" -m pip --disable-pip-version-check -qq install "$wheel"
cd "$room"

# Every module must load with what the wheel itself asks for, without a developer's tools.
"$room/env/bin/python" - "$source_version" <<'PYTHON'
import importlib
import pkgutil
import sys
from pathlib import Path

import maestra

assert maestra.__version__ == sys.argv[1], maestra.__version__
assert Path(maestra.__file__).is_relative_to(sys.prefix), maestra.__file__
assert Path(maestra.__file__).with_name("py.typed").is_file()
names = [module.name for module in pkgutil.walk_packages(maestra.__path__, "maestra.")]
for name in names:
    if not name.endswith(".__main__"):
        importlib.import_module(name)
print(f"version {maestra.__version__}, {len(names)} modules load")
PYTHON
