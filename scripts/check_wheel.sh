#!/usr/bin/env bash
# Build the wheel, install it into an empty environment, and do the main job there, far from the
# source: learn from demonstrations, say the rules, judge plays.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools=$PWD/.venv/bin
source_version=$("$tools/python" -c 'import maestra; print(maestra.__version__)')

examples=$PWD/examples
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
# These two are run, not imported: by `python -m`, and by Alembic while it upgrades.
run = (".__main__", ".migrations.env")
for name in names:
    if not name.endswith(run):
        importlib.import_module(name)
print(f"version {maestra.__version__}, {len(names)} modules load")
PYTHON

maestra=$room/env/bin/maestra

expect() { # expect TEXT WORDS...: what was printed holds the text
    local text=$1
    shift
    [[ $* == *"$text"* ]] || { printf 'expected %q in: %s\n' "$text" "$*" >&2; exit 1; }
}

expect "maestra $source_version" "$("$maestra" --version)"
"$maestra" learn "$examples/ascending.jsonl" --learner grounded -o exercise.json
expect "larger" "$("$maestra" explain exercise.json --lang en)"
# Exit 1, for the first play is right and the second is not.
status=0
"$maestra" judge exercise.json --json <(head -n 2 "$examples/plays/ascending.jsonl") >verdicts.jsonl || status=$?
[[ $status -eq 1 ]] || { echo "judge ended with $status instead of 1" >&2; exit 1; }
"$room/env/bin/python" - <<'PYTHON'
import json
from pathlib import Path

right, wrong = map(json.loads, Path("verdicts.jsonl").read_text(encoding="utf-8").splitlines())
assert right["complete"], right
assert [move["verdict"] for move in right["moves"]] == ["allowed"] * 5, right
refused = [move for move in wrong["moves"] if move["verdict"] == "refused"]
assert len(refused) == 1, wrong
print("refused:", refused[0]["reason"])
PYTHON
