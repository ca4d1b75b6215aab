# `make test` is all that a change must pass. It installs what it needs: Python and npm packages, Chromium, and Node
# where the machine's own is missing or too old.

SHELL := /bin/bash
VENV := .venv
PYTHON ?= python3
# What is tested is built once, with features that are off by default, and serves the tests in Python and the browser.
TESTED := --workspace --exclude katydid-kernel-bench \
	--features katydid-geometry/serde,katydid-geometry/glam,katydid-geometry/nalgebra
BUILT := $(abspath $(or $(CARGO_TARGET_DIR),target))/debug
RELEASED := $(abspath $(or $(CARGO_TARGET_DIR),target))/release

# Where tools are installed that take long to compile; `make clean` leaves them.
TOOLS := $(abspath .tools)
DENY := $(or $(shell command -v cargo-deny),$(TOOLS)/bin/cargo-deny)

.PHONY: packages packages-test front test-front pictures test-workflows wasm wasm-package test-wasm site test-site dist attack attack-short attack-sample attack-server deny deny-advisories studio programs module wheel third-party test-studio test-browser test-figures test lint docs test-rust test-python test-step test-mono test-compute test-effects test-ladybug test-assistant test-branches bench bench-compute bench-csharp bench-kernel bench-threads bench-work oracle fuzz booleans boolean-laws cut-solids clean soak test-studies measure-studies measure-site

test: test-studio test-rust test-python test-browser

test-rust:
	cargo test $(TESTED)

programs:
	cargo build $(TESTED) --lib --bins --examples

# The extension module where `import katydid` in `python/` finds it.
module: programs
	cp $(BUILT)/lib_katydid$(if $(filter Darwin,$(shell uname)),.dylib,.so) python/katydid/_katydid.abi3.so

# The licences of the wheel and of what is linked into it, with their texts.
third-party:
	$(PYTHON) python/third_party.py

# The wheel of the Python package, in target/wheels; `pip install ./python` makes and installs the same.
wheel: $(VENV)/installed third-party
	$(VENV)/bin/pip install -q "maturin>=1.9,<2"
	cd python && ../$(VENV)/bin/maturin build --release --out ../target/wheels

# What rhino3dm, the official reader, makes of the files that Katydid writes; the Python package and what scripts call.
# Scripts of real definitions are run where the shared data is there.
test-python: $(VENV)/installed module
	KATYDID_TEST_DEFINITIONS=$(wildcard $(abspath ../shared/data/gh)) KATYDID_REQUIRE_MODULE=1 KATYDID=$(BUILT)/katydid KATYDID_EXAMPLES=$(BUILT)/examples $(VENV)/bin/python -m pytest -q -n auto \
		--ignore=python-tests/step --ignore=python-tests/compute --ignore=python-tests/assistant python-tests --ignore=python/tests/ladybug --ignore=python/tests/studies python/tests \
		$(addprefix crates/rhino3dm/tests/,rhino3dm_peer.py tables_peer.py solids_peer.py)

# What Open CASCADE makes of the STEP files that Katydid writes. Not part of `make test`: it is more than a gigabyte.
test-step: $(VENV)-step/installed
	cargo build --release -p katydid
	cargo build --release -p katydid-definition --example write_steps
	cargo build --release -p katydid-step --examples
	KATYDID=$(RELEASED)/katydid KATYDID_EXAMPLES=$(RELEASED)/examples \
		$(VENV)-step/bin/python -m pytest -q python-tests/step

$(VENV)-step/installed: python-tests/step/requirements.txt
	$(PYTHON) -m venv $(VENV)-step
	$(VENV)-step/bin/pip install -q -r python-tests/step/requirements.txt
	touch $@

# What Mono makes of the C# programs that the interpreter is tested with. Not part of `make test`: it needs the Debian
# packages mono-mcs and mono-runtime.
test-mono:
	$(PYTHON) crates/csharp/tests/mono.py --check

# What the clients of Rhino.Compute from PyPI and npm make of `katydid serve`. Not part of `make test`: it fetches them.
test-compute: $(VENV)-compute/installed
	cargo build --release -p katydid
	cargo build --release -p katydid-compute --example endpoint
	KATYDID=$(RELEASED)/katydid KATYDID_EXAMPLES=$(RELEASED)/examples \
		$(VENV)-compute/bin/python -m pytest -q python-tests/compute

$(VENV)-compute/installed: python-tests/compute/requirements.txt
	$(PYTHON) -m venv $(VENV)-compute
	$(VENV)-compute/bin/pip install -q -r python-tests/compute/requirements.txt
	touch $@

# Studies on Ray and Dask, under pymoo, cma and Optuna, under kills and full disks. Not part of `make test`: it fetches those
# packages, and solves tens of thousands of points.
test-studies: $(VENV)-studies/installed studies-release
	KATYDID=$(RELEASED)/katydid $(VENV)-studies/bin/python -m pytest -q -s python/tests/studies

# What studies take: seconds for one and two workers, memory and time over a million points. Two processors must be free.
measure-studies: $(VENV)-studies/installed studies-release
	$(VENV)-studies/bin/python python/tests/studies/measure.py $(RELEASED)/katydid

.PHONY: studies-release
studies-release:
	cargo build --release -p katydid -p katydid-python
	cp $(RELEASED)/lib_katydid$(if $(filter Darwin,$(shell uname)),.dylib,.so) python/katydid/_katydid.abi3.so

$(VENV)-studies/installed: python/tests/studies/requirements.txt
	$(PYTHON) -m venv $(VENV)-studies
	$(VENV)-studies/bin/pip install -q -r python/tests/studies/requirements.txt
	touch $@

# Effects on the volume and area of solids: half a minute, so no part of `make test`; run it after a change of effects.
test-effects:
	cargo test -p katydid-study --test effects -- --ignored

# What the Model Context Protocol's client from PyPI makes of `katydid mcp`. Not part of `make test`: it fetches it.
test-assistant: $(VENV)-assistant/installed
	cargo build --release -p katydid
	KATYDID=$(RELEASED)/katydid KATYDID_TEST_DEFINITIONS=$(wildcard $(abspath ../shared/data/gh)) \
		$(VENV)-assistant/bin/python -m pytest -q python-tests/assistant

$(VENV)-assistant/installed: python-tests/assistant/requirements.txt
	$(PYTHON) -m venv $(VENV)-assistant
	$(VENV)-assistant/bin/pip install -q -r python-tests/assistant/requirements.txt
	touch $@

# Ladybug's packages from PyPI in a script component. Not part of `make test`: it fetches them.
test-ladybug: $(VENV)-ladybug/installed
	cargo build -p katydid
	KATYDID=$(BUILT)/katydid $(VENV)-ladybug/bin/python -m pytest -q python/tests/ladybug

$(VENV)-ladybug/installed: python/tests/ladybug/requirements.txt
	$(PYTHON) -m venv $(VENV)-ladybug
	$(VENV)-ladybug/bin/pip install -q -r python/tests/ladybug/requirements.txt
	touch $@

# Sixty-four clients on `katydid serve`, each answer compared with `katydid run`.
bench-compute:
	cargo build --release -p katydid
	cargo build --release -p katydid-server --example compute_load
	$(PYTHON) benches/compute_load.py target/release/katydid target/release/examples/compute_load

# The same for half an hour among clients that leave, cancel, and send nonsense, too much or too slowly: no answer may be
# wrong, and neither memory nor file descriptors be lost. Not part of `make test`. `make soak SOAK_SECONDS=600` for less.
SOAK_SECONDS ?= 1800
soak:
	cargo build --release -p katydid
	cargo build --release -p katydid-server --example compute_load
	$(PYTHON) benches/compute_soak.py $(RELEASED)/katydid $(RELEASED)/examples/compute_load --seconds $(SOAK_SECONDS)

# The page's own parts, without a browser; then the page, which the binary takes in.
test-studio: studio/node_modules/installed
	studio/with-node npm test
	studio/with-node npm run build

# The page in Chromium, served by the binary: two halves side by side, each with a server of its own, since one browser keeps a
# processor and a half busy at most. Then the viewport alone.
test-browser: test-studio programs
	export KATYDID=$(BUILT)/katydid CHROMIUM=$$(studio/chromium); \
	half() { PORT=$$2 studio/with-node npm run e2e -- --output=test-results/$$1 --shard=$$1/2; }; \
	half 2 6708 & second=$$!; half 1 6598; first=$$?; wait $$second && exit $$first
	CHROMIUM=$$(studio/chromium) studio/with-node npm run e2e:viewport

# Every figure of the book in Chromium: it starts, gives its numbers, and each control moves it. `make test-browser` takes a
# few pages; all of them take half an hour.
test-figures: test-studio programs
	KATYDID=$(BUILT)/katydid CHROMIUM=$$(studio/chromium) studio/with-node npm run e2e:figures

studio/node_modules/installed: studio/package-lock.json
	studio/with-node npm ci --no-audit --no-fund
	touch $@

# The engine for web pages and Node, in wasm/pkg. It takes the installed library for wasm32-unknown-unknown, or Debian's
# compiler and source (`wasm/build`); cold, ten minutes of a processor.
wasm: studio/node_modules/installed
	wasm/build

# The npm package as a file, wasm/katydid-engine-….tgz.
wasm-package: wasm
	studio/with-node npm pack $(CURDIR)/wasm --pack-destination $(CURDIR)/wasm

# The package in Node; then all definitions of the book, the examples and the shared data, in it and in the program: the
# same values to the last bit. Not part of `make test`: it builds the engine, and the program optimised.
test-wasm: wasm
	cargo build --release -p katydid
	studio/with-node node --test $(CURDIR)/wasm/tests/api.test.mjs
	studio/with-node node $(CURDIR)/wasm/tests/same.mjs $(RELEASED)/katydid $(CURDIR)/book $(CURDIR)/examples \
		$(wildcard $(abspath ../shared/data/gh))

# The studio and the book without a server, a folder of files for any host: site/.
site: wasm
	studio/with-node npm run build
	cargo build --release -p katydid
	studio/with-node npm run build:site
	$(RELEASED)/katydid book book -o site/learn
	studio/with-node node $(CURDIR)/wasm/site.mjs $(CURDIR)/site

# The front page of it, with the book and without the engine, in target/front: to look at while it is written.
front: test-studio programs
	rm -rf target/front
	$(BUILT)/katydid book book -o target/front/learn
	studio/with-node node $(CURDIR)/wasm/front/write.mjs $(CURDIR)/target/front

# That page in Chromium: half a minute, besides what it is built of.
test-front: front
	CHROMIUM=$$(studio/chromium) studio/with-node npm run e2e:front

# The picture of the studio in README.md, taken anew.
pictures: test-studio programs
	KATYDID=$(BUILT)/katydid CHROMIUM=$$(studio/chromium) studio/with-node npm run pictures

# That folder in Chromium. Not part of `make test`: it builds the engine.
test-site: site
	CHROMIUM=$$(studio/chromium) studio/with-node npm run e2e:site

# What figures and sliders take in a page, and beside the program on one thread. Nothing is asserted.
measure-site: site
	CHROMIUM=$$(studio/chromium) studio/with-node npm run measure:site
	studio/with-node node $(CURDIR)/wasm/tests/speed.mjs $(RELEASED)/katydid

# The same command without `make` serves the same program: one with other features would be built beside it.
# Builds what is missing and opens the studio on the book's sum of vectors.
studio: studio/node_modules/installed
	studio/with-node npm run build
	cargo run --release -- studio book/V2/definition.kd

$(VENV)/installed: python-tests/requirements.txt
	$(PYTHON) -m venv $(VENV)
	$(VENV)/bin/pip install -q -r python-tests/requirements.txt
	touch $@

lint:
	cargo fmt --all --check
	cargo clippy --workspace --all-targets -- -D warnings

# Licences and sources of all dependencies, by deny.toml. Not part of `make test`: cargo-deny takes minutes to compile.
deny: $(DENY)
	$(DENY) --locked check licenses bans sources

# The same for known faults: the database of them comes from the network.
deny-advisories: $(DENY)
	$(DENY) --locked check advisories

$(DENY):
	cargo install cargo-deny --locked --root $(TOOLS)

# The public workflows and issue forms beside their schemas. Not part of `make test`: it fetches them with their checker.
test-workflows:
	$(PYTHON) -m venv $(VENV)-workflows
	$(VENV)-workflows/bin/pip install -q "check-jsonschema>=0.30,<1"
	$(VENV)-workflows/bin/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	$(VENV)-workflows/bin/check-jsonschema --builtin-schema vendor.github-issue-forms \
		$(filter-out %/config.yml,$(wildcard .github/ISSUE_TEMPLATE/*.yml))
	$(VENV)-workflows/bin/check-jsonschema --builtin-schema vendor.github-issue-config .github/ISSUE_TEMPLATE/config.yml

docs:
	RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps

# The program as it is published, optimised in one piece: target/dist/katydid.
dist:
	cargo build --profile dist -p katydid

# Everything that a version needs, in target/packages (docs/releasing.md). `STEPS="deb sums"` makes some of it, and
# `KATYDID_PROFILE=release` takes a program that is optimised in pieces: half an hour of a processor less.
packages:
	$(PYTHON) release packages $(STEPS)

# Each of them in an environment that has nothing else, with the README's example run in it.
packages-test:
	$(PYTHON) release test $(STEPS)

# Katydid and NumPy over a million items, side by side.
bench: $(VENV)/installed
	$(VENV)/bin/pip install -q numpy==2.3.4
	$(VENV)/bin/python benches/compare.py

# The kernel beside curvo and truck, and Open CASCADE through Python, on the inputs in ../shared: two tables of ratios.
bench-kernel: $(VENV)-work/installed
	cargo build --release -p katydid-kernel-bench --bin ratios
	$(RELEASED)/ratios > $(RELEASED)/ratios.md
	cat $(RELEASED)/ratios.md
	$(VENV)-work/bin/python benches/occt_kernel.py ../shared/data/kernel-bench $(RELEASED)/ratios.md

# What a second thread is worth to rows of few, costly items. Two processors must be free.
bench-threads:
	cargo build --release -p katydid
	$(PYTHON) benches/work/threads.py $(RELEASED)/katydid

# The C# interpreter beside Mono and CPython: a table of seconds and ratios. Needs the Debian packages mono-mcs and
# mono-runtime.
bench-csharp:
	cargo build --release -p katydid-csharp --example run
	cargo build --release -p katydid
	$(PYTHON) benches/csharp/run.py $(RELEASED)/examples/run $(RELEASED)/katydid

# Whole definitions beside NumPy, shapely, Open CASCADE and others: a table of seconds, exponents, ratios and memory. It
# takes ten minutes, and installs more than a gigabyte.
bench-work: $(VENV)-work/installed
	cargo build --release -p katydid
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(VENV)-work/bin/python benches/work $(RELEASED)/katydid

$(VENV)-work/installed: benches/work/requirements.txt
	$(PYTHON) -m venv $(VENV)-work
	$(VENV)-work/bin/pip install -q -r benches/work/requirements.txt
	touch $@

# Solids cut by solids, beside the answers of other kernels and closed forms.
booleans:
	cargo run --release -p katydid-geometry --example booleans -- ../shared/data/oracle/boolean_dev.json

# Pairs of real solids (`benches/boolean_real.py … --pairs $(PAIRS)`): refusals by class, laws of volumes, points inside.
cut-solids:
	cargo run --release -p katydid-3dm --example cut_solids -- $(PAIRS)/*.3dm

# Laws of booleans on 20,000 random pairs and as many triples: some hours.
boolean-laws:
	KATYDID_BOOLEAN_LAWS=20000 cargo test --release -p katydid-geometry --test boolean_laws

# The kernel beside the answers of other kernels.
oracle:
	cargo run --release -p katydid-geometry --example oracle -- ../shared/data/oracle/on_dev.json ../shared/data/oracle/occ_dev.json

# Every component with extreme inputs, damaged files of every format, hostile definitions and requests, full disks and
# kills; memory and processor time are measured from outside. All of it takes hours; before a release ten minutes do.
attack:
	cargo build --release -p katydid
	$(PYTHON) attack $(RELEASED)/katydid

attack-short:
	cargo build --release -p katydid
	$(PYTHON) attack $(RELEASED)/katydid --minutes 10

# Two minutes with the programs that are tested, which are not optimised: memory and crashes count, time hardly.
attack-sample: programs
	$(PYTHON) attack $(BUILT)/katydid --minutes 2 --slow

# A server under attack among clients that mean well, for an hour.
attack-server:
	cargo build --release -p katydid
	$(PYTHON) attack/server.py $(RELEASED)/katydid --minutes 60

# Ten thousand random pairs of surfaces: no common curve may be missed. Minutes of work.
test-branches:
	cargo test --release -p katydid-geometry --lib -- --ignored --nocapture no_branch_of_many

# Ten minutes for each reader: `cargo install cargo-fuzz` first.
fuzz:
	cd fuzz && for t in csharp_parse csharp_run vb_run gh_binary gh_xml document rhino3dm step obj stl ply gltf shp pdb expression geometry kd request compute_request preview; do \
		RUSTC_BOOTSTRAP=1 cargo fuzz run $$t -- -max_total_time=600 -rss_limit_mb=2048 -timeout=20 || exit 1; done

clean:
	cargo clean
	rm -rf $(VENV) $(VENV)-step $(VENV)-compute $(VENV)-work $(VENV)-workflows $(VENV)-packages $(VENV)-studies
