# make notes   lecture notes of the paper's course: PDF, HTML and LaTeX in build/
# make test    the whole test suite
# make test-fast  within a minute: of every folder of tests some files, and of a test with parameters the first
# make bare    what uses TeX, browsers, Node and provers, without any of these: it is skipped with a reason, the rest works
# make thorough  the tests that take hours: mutants of the source, random systems, mutated files, oracles at many sets
# make check   derive every problem that ships and decide every claim, all of it anew
# make mutants  every claim against its mutants and rewrites; fails below 100 %
# make distractors  every wrong answer of every problem, for 200 students: none may look right
# make certify  each step of every problem that ships, re-proved by Rocq, and coqchk on it all; the report in build/certify.txt
# make lint    style, by ruff; types, by mypy
# make bench   how fast, as ratios
# make library the table of the library: steps, proofs, seconds; also in build/library.txt
# make docs    write the reference pages of docs/ anew and build the site, with the gallery (and the studio, if built), in build/docs
# make studio  the page in which the engine runs: build/studio, and its wheel; “rbpsym studio” serves it
# make clean   remove what was written, but for .venv
#
# Needs python3 (3.11 or newer, with venv) and make; the rest is put into .venv.

PYTHON ?= python3
VENV   ?= .venv
OUT    ?= build
COURSE ?= paper
JOBS   ?= 2
TESTS  ?= -n auto
SEED   := $(or $(SEED),$(shell date +%s))
BARE   := $(addprefix tests/,kernel document/test_access.py document/test_explorer.py document/test_formats.py \
          document/test_writers.py teaching/test_exports.py teaching/test_worksheet.py)

FAST   := $(patsubst %,tests/%.py,\
          field/test_normal field/test_vector architecture/test_excepts architecture/test_house ask/test_answers \
          claims/test_decide claims/test_loader claims/test_phrases cli/test_doctor proof/test_steps \
          proof/test_theory document/test_breaking document/test_figures document/test_phrases decide/test_decide \
          decide/test_dimensions decide/test_signs facade/test_facade face/test_stating golden/test_semantic \
          kernel/test_certify letters/test_letters library/test_printed_forms mechanics/test_balance \
          mechanics/test_numbers mutants/test_mutants expr/test_formats expr/test_infix expr/test_laws \
          oracles/test_eigenvalues solve/test_contract statement/test_broken statement/test_build statement/test_loader \
          studio/test_api \
          teaching/test_grading_formulas teaching/test_sheet_errors teaching/test_tasks oracles/test_simulation_steps \
          remarks/test_remarks)

BIN      := $(VENV)/bin
PIP      := $(BIN)/python -m pip --quiet --disable-pip-version-check
NOTES    := $(OUT)/$(COURSE)
SOURCES  := $(shell find rbpsym templates derivations -type f ! -name '*.pyc' 2>/dev/null)

.PHONY: help notes test test-fast bare thorough check mutants distractors certify lint bench library docs studio clean
.DELETE_ON_ERROR:
unexport PYTHONDONTWRITEBYTECODE  # tests run hundreds of short processes: what they load is compiled once

help:
	@sed -n 's/^# \(make .*\)/\1/p' Makefile

notes: $(NOTES).pdf
	@ls -1 $(NOTES).*

$(NOTES).pdf: $(VENV)/run.stamp $(SOURCES)
	$(BIN)/rbpsym notes $(COURSE) --format pdf,html,tex -o $(OUT) > /dev/null

test: $(VENV)/dev.stamp
	$(BIN)/python -m pytest $(TESTS)

test-fast: $(VENV)/dev.stamp
	$(BIN)/python -m pytest -n 2 --one-of-each -k "not coqc" $(FAST)

bare: $(VENV)/dev.stamp
	PATH="$(abspath $(BIN))" RBPSYM_REQUIRE_TOOLS= $(BIN)/python -m pytest $(TESTS) --one-of-each -rs $(BARE)

thorough: $(VENV)/dev.stamp
	rm -f $(OUT)/systems.jsonl
	$(BIN)/python -m pytest $(TESTS) --whole -m 'thorough or heavy'
	@echo "examples drawn with SEED=$(SEED)"
	$(BIN)/python -m pytest $(TESTS) --hypothesis-profile=random --hypothesis-seed=$(SEED) $$(grep -rl "^ *@given" tests)
	$(BIN)/python -m tests.claims.errata 2000 $(SEED)
	$(BIN)/python -m tests.oracles.random_run 0 2000 $(OUT)/systems.jsonl
	RBPSYM_COVERING=$(OUT)/covering.json $(BIN)/python -m pytest -p no:xdist -p tests.thorough.covering tests > /dev/null
	$(BIN)/python -m tests.thorough.mutants $(OUT)/covering.json

check: $(VENV)/run.stamp
	@find derivations -name '*.toml' ! -path '*/courses/*' ! -path '*/claims/problems/*' ! -path '*/worksheets/*' | sort | \
	    xargs -n 30 -P $(JOBS) $(BIN)/rbpsym check --no-cache --simulation --failures

mutants: $(VENV)/run.stamp
	@$(BIN)/python -m tests.mutants.run

distractors: $(VENV)/run.stamp
	@$(BIN)/python benchmarks/slow/distractors.py

certify: $(VENV)/run.stamp
	@mkdir -p $(OUT)
	$(BIN)/rbpsym certify theory --coqchk -o $(OUT)/rocq
	@find derivations -name '*.toml' ! -path '*/courses/*' ! -path '*/claims/*' ! -path '*/worksheets/*' | sort | \
	    xargs -n 5 -P $(JOBS) $(BIN)/rbpsym certify --coqchk > $(OUT)/certify.txt; \
	    found=$$?; grep 'certified by\|written as' $(OUT)/certify.txt; \
	    awk '/certified by/ {m += $$2; n += $$4; l += $$9; s += $$12} \
	        END {print m " of " n " steps, " l " lemmas in " s " s of coqc"}' $(OUT)/certify.txt; exit $$found

lint: $(VENV)/dev.stamp
	$(BIN)/ruff check .
	$(BIN)/python -m mypy

bench: $(VENV)/dev.stamp
	@for file in benchmarks/*.py; do echo "$$file"; $(BIN)/python "$$file" || exit 1; done

library: $(VENV)/run.stamp
	@mkdir -p $(OUT)
	@$(BIN)/python benchmarks/library.py > $(OUT)/library.txt; found=$$?; cat $(OUT)/library.txt; exit $$found

docs: $(VENV)/docs.stamp
	$(BIN)/python docs/build.py
	$(BIN)/python docs/gallery.py $(OUT)/gallery $(OUT)/studio
	$(BIN)/python -m sphinx -q -W --keep-going -D html_extra_path=$(abspath $(OUT)/gallery) docs $(OUT)/docs
	@echo $(OUT)/docs/index.html

studio: $(OUT)/studio/index.html
	@echo $(OUT)/studio/index.html

$(OUT)/studio/index.html: studio/node_modules/.stamp $(VENV)/run.stamp $(SOURCES) $(wildcard studio/* studio/src/*)
	node studio/build.mjs $(OUT)/studio $(BIN)/python
	$(BIN)/python studio/wheel.py $(OUT)/studio $(OUT)

studio/node_modules/.stamp: studio/package.json
	@command -v npm > /dev/null || { echo "make studio needs Node and npm" >&2; exit 1; }
	npm install --prefix studio --no-audit --no-fund --silent > /dev/null
	@touch $@

clean:
	rm -rf $(OUT) dist .pytest_cache .ruff_cache .hypothesis
	find rbpsym tests docs benchmarks -name __pycache__ -prune -exec rm -rf {} +

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(0 if sys.version_info >= (3, 11) else \
	    "rbpsym needs Python 3.11 or newer, this is " + sys.version.split()[0] + "; try make PYTHON=python3.12 ...")'
	$(PYTHON) -m venv $(VENV)

$(VENV)/run.stamp: pyproject.toml | $(BIN)/python
	$(PIP) install --editable .
	@touch $@

$(VENV)/dev.stamp: pyproject.toml | $(BIN)/python
	$(PIP) install --editable '.[dev]'
	@touch $@ $(VENV)/run.stamp

$(VENV)/docs.stamp: pyproject.toml | $(BIN)/python
	$(PIP) install --editable '.[docs]'
	@touch $@
