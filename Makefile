# Two commands do everything on a fresh Debian 12 machine:
#   make run     installs packages if missing, builds pmr, runs the small reactor, names its report
#   make test    installs, builds everything, then runs all tests but the slow ones
# make, make install (PREFIX=/usr/local) and make deb build pmr alone, too.
# For developers: make check (what continuous integration holds) and make check-all (what takes
# hours: docs/quality.md); make bench compares the speed with LIGGGHTS.
CASE   ?= cases/demonstrator-small.toml
OUT    ?= out/$(basename $(notdir $(CASE)))
PRESET ?= release
BUILD  ?= build/$(PRESET)
PREFIX ?= /usr/local
JOBS   ?= $(shell nproc)
PMR     = $(BUILD)/src/cli/pmr

.PHONY: pmr run install deb everything test test-slow verify packages configure
.PHONY: check check-all format bench bench-bed bench-tracing clean
.DEFAULT_GOAL := pmr

packages:
	@scripts/install-packages

configure: packages
	@mkdir -p build
	@cmake --preset $(PRESET) -B $(BUILD) >$(BUILD).configure.log 2>&1 || \
	  { cat $(BUILD).configure.log; exit 1; }
	@grep -A4 '^CMake Warning' $(BUILD).configure.log || true

pmr: configure
	@cmake --build $(BUILD) -j $(JOBS) --target pmr

run: pmr
	@$(PMR) run $(CASE) -o $(OUT)

install: pmr
	@cmake --install $(BUILD) --prefix $(PREFIX)

deb: pmr
	@scripts/install-packages packages-ci.txt
	@cd $(BUILD) && cpack -G DEB

everything: configure
	@cmake --build $(BUILD) -j $(JOBS)

test: everything
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE slow

test-slow: configure
	@scripts/install-packages packages-slow.txt
	@cmake --build $(BUILD) -j $(JOBS) --target pmr test_slow test_report_size
	@ctest --test-dir $(BUILD) --output-on-failure -L slow

verify: pmr
	@$(PMR) verify

check:
	@.ci/run

check-all:
	@scripts/check-all

# Against LIGGGHTS (docs/benchmarks.md); BENCH="--sizes 3862 --samples 1" for a part.
bench: pmr
	@python3 bench/mechanics.py $(BENCH)

bench-bed: pmr
	@python3 bench/settled_bed.py $(BENCH)

# Rays per second against plain Embree.
bench-tracing: pmr
	@cmake --build $(BUILD) --target bench_tracing
	@python3 bench/tracing.py $(BENCH)

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i

clean:
	@rm -rf build
