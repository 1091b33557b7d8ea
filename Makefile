# Every command of the project; `make` alone lists them.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
BIN := .venv/bin
NIGHTLY := .venv-nightly/bin
STEP := @scripts/step.sh
export PYTHON

.PHONY: help
help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-11s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# ---------------------------------------------------------------- use it

.PHONY: run
run: ## set everything up, then serve the pages and open them in a browser
	@scripts/environment.sh product
	@exec $(BIN)/maestra serve --open

.PHONY: demo
demo: ## set everything up, then play with Maestra in the terminal
	@scripts/environment.sh product
	@$(BIN)/maestra demo

.PHONY: setup
setup: ## set .venv up with everything a developer needs
	@scripts/environment.sh developer

# ---------------------------------------------------------------- check it

# What needs no order is done two at a time. pytest has both cores for itself and comes last, so
# that its closing lines are the last ones printed.
.PHONY: test
test: setup ## set everything up, then pass every check
	@$(MAKE) --no-print-directory --jobs=2 --output-sync=target checks
	@$(MAKE) --no-print-directory tests

.PHONY: checks
checks: pyright mypy wheel docs javascript layers check-format lint

.PHONY: check-format
check-format: setup
	$(STEP) format $(BIN)/ruff format --check --quiet

.PHONY: lint
lint: setup ## ruff
	$(STEP) lint $(BIN)/ruff check --quiet

.PHONY: types
types: mypy pyright ## mypy and pyright, both strict

.PHONY: mypy
mypy: setup
	$(STEP) mypy $(BIN)/mypy

.PHONY: pyright
pyright: setup
	$(STEP) pyright $(BIN)/pyright

.PHONY: javascript
javascript: setup ## the types of the browser's module, by TypeScript's compiler
	$(STEP) javascript scripts/check_javascript.sh

.PHONY: layers
layers: setup ## the import rule of the house
	$(STEP) layers $(BIN)/lint-imports --no-logo --cache-dir .cache/import-linter

.PHONY: docs
docs: setup ## build the documentation into site/
	$(STEP) docs env NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict

.PHONY: wheel
wheel: setup ## build the wheel, install it into an empty environment, use it there
	$(STEP) wheel scripts/check_wheel.sh

.PHONY: tests
tests: setup ## the tests, with the coverage each package must have
	@printf '\n== tests\n'
	@$(BIN)/python -m pytest --numprocesses=2 --dist=worksteal --hypothesis-profile=ci \
		--cov --cov-report=term-missing:skip-covered --coverage-floors --durations=10 --durations-min=3

.PHONY: format
format: setup ## format the code and repair what ruff can
	$(BIN)/ruff check --fix
	$(BIN)/ruff format

.PHONY: schemas
schemas: setup ## write docs/schemas from the models that read the files
	$(BIN)/python scripts/write_schemas.py

.PHONY: examples
examples: setup ## write the files in examples/
	$(BIN)/python scripts/write_examples.py

# ---------------------------------------------------------------- measure and search

.PHONY: bench
bench: setup ## measure speed
	$(BIN)/python -m pytest benchmarks --benchmark-enable --benchmark-only -p no:randomly --timeout=0
	$(BIN)/maestra experiment growth --repeat 3
	$(BIN)/python benchmarks/rooms.py
	$(BIN)/python -m benchmarks.pages

FEWSHOT_EXERCISES ?= 500
FEWSHOT_DRAWS ?= 100
FEWSHOT_RESULTS ?= .cache/fewshot.jsonl
FEWSHOT_PAGE := docs/reference/fewshot.md

.PHONY: fewshot
fewshot: setup ## measure few-shot learning anew for the docs; takes hours, goes on where it stopped
	@mkdir -p $(dir $(FEWSHOT_RESULTS))
	$(BIN)/maestra experiment fewshot --exercises $(FEWSHOT_EXERCISES) --draws $(FEWSHOT_DRAWS) \
		--seed 1000 --results $(FEWSHOT_RESULTS) --csv docs/reference/experiments/fewshot.csv \
		--page $(FEWSHOT_PAGE)
	$(BIN)/maestra experiment compare --draws 20 --page $(FEWSHOT_PAGE)
	$(BIN)/maestra experiment growth --repeat 5 --folder docs/reference/experiments \
		--page $(FEWSHOT_PAGE)

.PHONY: million
million: setup ## read a million demonstrations: how fast, in how much memory
	$(BIN)/python benchmarks/million.py

.PHONY: properties
properties: setup ## the tests with 5,000 examples for each law instead of 40
	$(BIN)/python -m pytest --numprocesses=2 --hypothesis-profile=nightly --timeout=0

REQUESTS ?= 300

.PHONY: requests
requests: setup ## invent 300 requests for each operation of the interface for programs
	MAESTRA_REQUESTS=$(REQUESTS) $(BIN)/python -m pytest tests/web/test_openapi.py --timeout=0

.PHONY: screenshots
screenshots: setup ## take pictures of every page for the docs and the help
	$(BIN)/python -m scripts.take_screenshots

.PHONY: nightly-setup
nightly-setup:
	@VENV=.venv-nightly scripts/environment.sh nightly

FUZZ_SECONDS ?= 120
FUZZ_TARGETS := demonstrations plays exercises words

.PHONY: fuzz
fuzz: nightly-setup ## invented bytes into every reader, FUZZ_SECONDS=120 each
	for target in $(FUZZ_TARGETS); do \
		$(NIGHTLY)/python fuzz/readers.py $$target .cache/fuzz/$$target -dict=fuzz/json.dict \
			-max_total_time=$(FUZZ_SECONDS) -max_len=8192 -verbosity=0 -print_final_stats=1 \
			-artifact_prefix=.cache/fuzz/; \
	done

.PHONY: mutation
mutation: nightly-setup ## which small changes of the code does no test notice?
	$(NIGHTLY)/mutmut run
	$(NIGHTLY)/mutmut results

.PHONY: crashes
crashes: setup ## kill, cut power and spoil disks below the record, far oftener than `make test`
	MAESTRA_KILLS=120 MAESTRA_POWER_CUTS=2000 $(BIN)/python -m pytest -s -p no:randomly --timeout=0 \
		tests/storage/test_killing.py tests/storage/test_faulty_disk.py

.PHONY: browser
browser: setup ## all tests in a browser: each page and journey on three sizes, cuts, every language
	MAESTRA_BROWSER=whole $(BIN)/python -m pytest --numprocesses=2 --dist=loadfile tests/browser

.PHONY: reconnect
reconnect: setup ## cut patients' pages off for up to a minute, and see that nothing is lost
	MAESTRA_BROWSER=whole MAESTRA_CUTS_S="0.5 2 8 60" $(BIN)/python -m pytest -p no:randomly --timeout=0 tests/browser/rooms

.PHONY: oracle
oracle: nightly-setup ## compare with learners that are not ours
	$(NIGHTLY)/python -m pytest oracles

.PHONY: clean
clean: ## remove everything that the other targets make
	rm -rf .venv .venv-* .cache .hypothesis site build dist mutants
	find src tests -name __pycache__ -prune -exec rm -rf {} +
