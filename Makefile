# The commands of the project. `make help` lists them.
SHELL := /bin/sh
.DEFAULT_GOAL := help
VENV := .venv/bin

# The Python that creates the environment: the first suitable one, or yours (make env PYTHON=python3.12).
ifdef PYTHON
CHOSEN := --chosen-python
else
FITS := import sys, ensurepip, venv; sys.exit(not (3, 11) <= sys.version_info < (3, 15))
SEARCH = for p in python3 python3.12 python3.13 python3.11 python3.14; do \
	"$$p" -I -c '$(FITS)' >/dev/null 2>&1 && echo $$p && exit; done; echo python3
PYTHON = $(eval PYTHON := $(shell $(SEARCH)))$(PYTHON)
endif
BOOTSTRAP = "$(PYTHON)" -I workbook/lab/bootstrap.py $(CHOSEN)
HAVE_PYTHON = command -v "$(PYTHON)" >/dev/null || { \
	echo "make: $(PYTHON) was not found. Python 3.11 to 3.14 is needed; see 'A suitable Python' in environment.md." >&2; exit 1; }

.PHONY: help env lab progress test test-all bench model mutants notebooks notebooks-check lint lock dist clean

help:  ## list the commands
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | while IFS="$$(printf '\t')" read -r name what; do \
		printf '  make %-16s %s\n' "$$name" "$$what"; done

env:  ## create the environment in .venv, or bring it up to date (EXTRAS=torch adds PyTorch, =tensorflow Keras, =farm dask, =similar copydetect)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras "$(EXTRAS)"

lab: env  ## open the lessons in JupyterLab, creating the environment first (ARGS='--port=8899' goes to JupyterLab)
	@$(VENV)/workbook lab $(ARGS)

progress: env  ## show what you have read, predicted and solved so far
	@$(VENV)/workbook progress

test:  ## prove the core of everything (ARGS='--only pytest' for a part)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev,farm,similar
	@$(VENV)/python tests/run.py $(ARGS)

test-all:  ## prove everything: what CI runs
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev,farm
	@$(VENV)/python tests/run.py --all $(ARGS)

lint:  ## check style and types only
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python tests/run.py --only lint

notebooks:  ## build the notebooks whose text has changed, and run those
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring build $(ARGS)

notebooks-check:  ## fail when a committed notebook differs from its text
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring check $(ARGS)

bench:  ## measure how fast and how steady judging is, as a table
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python tests/bench.py $(ARGS)

model:  ## train the detector of lesson 16 again, and fail if it is worse than told (needs EXTRAS=torch; ARGS=--write keeps it)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras torch
	@$(VENV)/python -m workbook.models.train $(ARGS)

mutants:  ## say which small faults the judges let through (ARGS='--only 05' for one exercise)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring mutants $(ARGS)

lock:  ## resolve the dependencies anew and write requirements.lock (needs uv)
	@$(HAVE_PYTHON)
	@"$(PYTHON)" -I workbook/lab/lock.py $(ARGS)

dist:  ## build the wheel for students in dist/ (the same files give the same bytes)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring dist $(ARGS)

clean:  ## remove the environment and all caches (your work/ stays)
	rm -rf .venv .mypy_cache .pytest_cache .ruff_cache .hypothesis build dist artifacts
	find . -name __pycache__ -type d -not -path './work/*' -prune -exec rm -rf {} +
