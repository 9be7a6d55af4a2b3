# The project's commands. `make help` lists them.
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
	echo "make: $(PYTHON) was not found. Python 3.11 to 3.14 is needed; see 'Supported Python versions' in environment.md." >&2; exit 1; }

.PHONY: help env lab hub progress test test-all bench model mutants notebooks notebooks-check lint lock dist site clean

help:  ## list the commands
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | while IFS="$$(printf '\t')" read -r name what; do \
		printf '  make %-16s %s\n' "$$name" "$$what"; done

env:  ## create the environment in .venv, or bring it up to date (EXTRAS=torch adds PyTorch, =tensorflow Keras, =farm dask, =similar copydetect, =hub JupyterHub)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras "$(EXTRAS)"

lab: env  ## open the lessons in JupyterLab, creating the environment first (ARGS='--port=8899' goes to JupyterLab)
	@$(VENV)/workbook lab $(ARGS)

hub:  ## serve a whole class at one address, with test users (as root; see docs/class_server.md)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras hub
	@CLASS_FOLDER="$${CLASS_FOLDER:-$(CURDIR)/artifacts/class}" $(VENV)/jupyterhub \
		-f deploy/jupyterhub/jupyterhub_config.py --JupyterHub.cleanup_servers=True --log-level=WARN $(ARGS)

progress: env  ## show your progress: lessons read, predictions made, exercises solved
	@$(VENV)/workbook progress

test:  ## test the core (ARGS='--only pytest' for a part)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev,farm,similar
	@$(VENV)/python tests/run.py $(ARGS)

test-all:  ## test everything that CI runs
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev,farm,similar,site,hub
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

bench:  ## measure the speed and the stability of judging, as a table
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python tests/bench.py $(ARGS)

model:  ## retrain lesson 16's detector, and fail if it is worse than promised (needs EXTRAS=torch; ARGS=--write keeps it)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras torch
	@$(VENV)/python -m workbook.models.train $(ARGS)

mutants:  ## list the small faults that the judge misses (ARGS='--only 05' for one exercise)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring mutants $(ARGS)

lock:  ## resolve the dependencies again and write requirements.lock (needs uv)
	@$(HAVE_PYTHON)
	@"$(PYTHON)" -I workbook/lab/lock.py $(ARGS)

dist:  ## build the wheel for students in dist/ (the same files give the same bytes)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras dev
	@$(VENV)/python -m workbook.authoring dist $(ARGS)

site:  ## build every page of the course for a browser, in build/site (needs no network, runs no programs)
	@$(HAVE_PYTHON)
	@$(BOOTSTRAP) --extras site
	@$(VENV)/python -m workbook.authoring site $(ARGS)

clean:  ## remove the environment and all caches (your work/ stays)
	rm -rf .venv .mypy_cache .pytest_cache .ruff_cache .hypothesis build dist artifacts
	find . -name __pycache__ -type d -not -path './work/*' -prune -exec rm -rf {} +
