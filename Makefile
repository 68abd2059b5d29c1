# `make help` lists what there is.
CARGO ?= cargo
.DEFAULT_GOAL := help
SIZE ?= minutes
SEED ?= 1
.PHONY: help table tables test test-core test-python test-page test-forms test-latex attack fuzz test-tools tools fmt clippy doc package publish-dry-run msrv book bench bench-python bench-peers report mutants rooms test-codes clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## /{printf "make %-15s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

table: tools ## build the command and print C_1..C_8 and a_1..a_8 to 20 digits
	@echo "Building; GMP and MPFR come from source, the first time takes a few minutes."
	@$(CARGO) build --release --locked --package restitution-cli
	@$(CARGO) run --release --locked --quiet --package restitution-cli -- table

TABLES = crates/restitution/src/evaluator/tables
PAGE = crates/page/src
tables: tools ## regenerate every generated table of the evaluator
	$(CARGO) build --release --locked --quiet --package restitution-cli
	target/release/restitution export --lang evaluator-constants -o $(TABLES)/constants.rs
	target/release/restitution export --lang evaluator-tables -o $(TABLES)/zero_compression.rs
	target/release/restitution export --lang evaluator-tables --end zero-force -o $(TABLES)/zero_force.rs
	target/release/restitution export --lang evaluator-tiers -o $(TABLES)/tiers.rs
	target/release/restitution export --lang js --tolerance 1e-12 --beyond law --name zero_compression -o $(PAGE)/zero_compression.js
	target/release/restitution export --lang js --tolerance 1e-12 --range 0,200 --end zero-force --name zero_force -o $(PAGE)/zero_force.js

STEP = @sh scripts/step
test: tools test-tools ## check formats, lints, documentation; run every test
	$(STEP) formats $(CARGO) fmt --all --check
	$(STEP) lints $(MAKE) --no-print-directory clippy
	$(STEP) documentation $(MAKE) --no-print-directory doc
	$(STEP) tests env CI=true $(CARGO) test --workspace --locked --quiet --no-fail-fast
	$(STEP) core $(MAKE) --no-print-directory test-core
	$(STEP) python $(MAKE) --no-print-directory test-python
	$(STEP) page $(MAKE) --no-print-directory test-page
	$(STEP) forms $(MAKE) --no-print-directory test-forms

CORE = thumbv7em-none-eabihf
test-core: tools ## test the evaluator without std, and build it for a processor that has none if rustup knows one
	$(CARGO) test --package restitution --no-default-features --locked --quiet
	@if rustup target list --installed 2>/dev/null | grep -q '^$(CORE)'; \
	then $(CARGO) build --package restitution --no-default-features --locked --quiet --target $(CORE); \
	else echo "not built for $(CORE): 'rustup target add $(CORE)' adds it"; fi

PYTHON = target/python
test-python: tools $(PYTHON)/ready ## install the Python package into target/python and test it
	$(PYTHON)/bin/pip install --quiet --disable-pip-version-check ./crates/python
	cd crates/python && ../../$(PYTHON)/bin/python -m pytest --quiet --pyargs tests restitution ../../docs

test-page: tools $(PYTHON)/ready ## test the page of `restitution page` in a real browser
	@sh scripts/need chromium
	$(CARGO) build --release --locked --quiet --package restitution-cli
	$(PYTHON)/bin/python -m pytest --quiet crates/page/tests

test-forms: tools $(PYTHON)/ready ## run what `restitution closed-form` prints for mpmath, sympy and, if it is installed, LaTeX
	$(CARGO) build --release --locked --quiet --package restitution-cli
	$(PYTHON)/bin/python -m pytest --quiet tests/forms

test-latex: ## install LaTeX if it is missing, then as test-forms
	@sh scripts/need pdflatex
	@$(MAKE) --no-print-directory test-forms

$(PYTHON)/ready: crates/python/tests/requirements.txt crates/page/tests/requirements.txt
	@python3 -c 'import ensurepip' 2>/dev/null || sh scripts/need python-venv
	python3 -m venv $(PYTHON)
	$(PYTHON)/bin/pip install --quiet --disable-pip-version-check $(addprefix --requirement ,$^)
	@touch $@

attack: tools test-tools ## attack every promise; PARTS="f64 commands", SIZE=slice|minutes|full, SEED=1, CASES=n
	$(CARGO) build --release --locked --quiet --package restitution-cli --package restitution-attack
	target/release/restitution-attack $(PARTS) --size $(SIZE) --seed $(SEED) $(if $(CASES),--cases $(CASES))
	$(CARGO) build --profile test --locked --quiet --package restitution-cli --package restitution-attack
	target/debug/restitution-attack $(PARTS) --size slice --seed $(SEED)

PARSERS ?= number quantity law list data
SECONDS ?= 60
fuzz: tools ## coverage-guided texts for the readers, from libFuzzer; PARSERS="law data", SECONDS=60 for each
	@command -v cargo-fuzz >/dev/null || $(CARGO) install cargo-fuzz --locked
	@for parser in $(PARSERS); do $(CARGO) fuzz run --sanitizer none $$parser -- -max_total_time=$(SECONDS) -max_len=4096 -timeout=30 || exit; done

fmt:
	$(CARGO) fmt --all --check

clippy: tools
	$(CARGO) clippy --workspace --all-targets --locked --quiet -- -D warnings

DOC = $${CARGO_TARGET_DIR:-target}/doc
doc: tools ## read every crate's documentation as one book, target/doc/restitution/index.html
	@mkdir -p $(DOC)/restitution # rustdoc links to crates whose folder is there
	@for room in crates/*; do mkdir -p $(DOC)/restitution_$$(basename $$room); done && rmdir $(DOC)/restitution_restitution
	RUSTDOCFLAGS="-Dwarnings -Drustdoc::missing_crate_level_docs -Drustdoc::unescaped_backticks" $(CARGO) doc --workspace --no-deps --locked --quiet --jobs 1

package: tools ## pack every crate for others, then build and test what was packed on its own
	@CARGO="$(CARGO)" sh scripts/package

publish-dry-run: package ## ask the registry whether it would take the packages, in their order
	$(CARGO) publish --workspace --dry-run --no-verify --locked

MSRV = $(shell sed -n 's/^rust-version = "\(.*\)"/\1.0/p' Cargo.toml)
msrv: tools ## check that the oldest Rust promised compiles everything; rustup fetches it if it is missing
	@rustup toolchain list | grep -q '^$(MSRV)' || rustup toolchain install $(MSRV) --profile minimal
	cargo +$(MSRV) check --workspace --all-features --locked --quiet --target-dir target/msrv

MDBOOK = target/tools/bin/mdbook
book: $(MDBOOK) ## make one book of the documents, target/book/index.html
	$(MDBOOK) build

$(MDBOOK):
	$(CARGO) install mdbook --version 0.5.4 --locked --quiet --no-default-features --features search --root target/tools

bench: tools ## measure speed, ours beside what it is compared with
	RUSTFLAGS=-Ctarget-cpu=native $(CARGO) bench --locked --quiet --package restitution --target-dir target/native --bench evaluator
	$(CARGO) bench --workspace --locked --quiet
	@$(MAKE) --no-print-directory bench-python

bench-python: tools $(PYTHON)/ready ## measure the Python package beside formula (35) in NumPy, and in numba if target/python has it
	$(PYTHON)/bin/pip install --quiet --disable-pip-version-check ./crates/python
	$(PYTHON)/bin/python bench/python/epsilon.py

report: tools ## measure the report, target/report/index.html, with the times of two builds: for every processor, and for this one
	$(CARGO) build --release --locked --quiet --package restitution-cli
	RUSTFLAGS=-Ctarget-cpu=native $(CARGO) build --release --locked --quiet --package restitution-cli --target-dir target/native
	target/native/release/restitution report --output target/report-native
	target/release/restitution report --output target/report --beside target/report-native

bench-peers: tools bench/.venv/ready ## measure the series engine against FLINT and PARI/GP in one run
	$(CARGO) build --release --locked --quiet --package restitution-cli
	$(CARGO) build --release --locked --quiet --package restitution-series --examples
	bench/.venv/bin/python bench/peers/compare.py

test-codes: tools bench/.venv-codes/ready ## run LAMMPS, LIGGGHTS, YADE, ESyS-Particle, Kratos and REBOUND on the lines we print
	@for code in liggghts yade esysparticle; do sh scripts/need $$code || echo "$$code is left out" >&2; done
	$(CARGO) build --release --locked --quiet --package restitution-cli
	bench/.venv-codes/bin/python bench/codes/run.py

bench/.venv-codes/ready: bench/codes/requirements.txt
	@python3 -c 'import ensurepip' 2>/dev/null || sh scripts/need python-venv
	python3 -m venv bench/.venv-codes
	bench/.venv-codes/bin/pip install --quiet --requirement bench/codes/requirements.txt
	@touch $@

bench/.venv/ready: bench/peers/requirements.txt
	@python3 -c 'import ensurepip' 2>/dev/null || sh scripts/need python-venv
	python3 -m venv bench/.venv
	bench/.venv/bin/pip install --quiet --requirement bench/peers/requirements.txt
	@touch $@

tools: # what a build needs: m4 is installed if it is missing, the rest is asked for
	@sh scripts/need cargo cc make m4

test-tools: tools # what the tests of exported sources need beyond a build; installed if missing
	@sh scripts/need cargo-fmt cargo-clippy c++ gfortran numpy octave-cli node

PACKAGE ?= restitution-real
mutants: tools ## break the code that rounds on purpose, a line at a time: which breaks do its own tests miss? (an hour; PACKAGE=restitution-pade)
	@command -v cargo-mutants >/dev/null || $(CARGO) install cargo-mutants --locked
	$(CARGO) mutants --package $(PACKAGE) --timeout 120

rooms: ## draw the crates and their arrows into docs/architecture.md
	python3 scripts/rooms.py

clean: ## remove what was built
	$(CARGO) clean
	rm -rf bench/.venv
