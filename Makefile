# Two commands do everything on a fresh Debian 12 machine:
#   make run     installs packages if missing, builds, runs the small reactor, names its report
#   make test    the same, then all tests but the slow ones
# make bench compares the speed with LIGGGHTS.
CASE  ?= cases/demonstrator-small.toml
OUT   ?= out/$(basename $(notdir $(CASE)))
BUILD ?= build/release
JOBS  ?= $(shell nproc)
PMR    = $(BUILD)/src/cli/pmr

.PHONY: run test test-slow build packages verify bench bench-bed bench-tracing format clean
.DEFAULT_GOAL := build

packages:
	@scripts/install-packages

build: packages
	@mkdir -p build
	@cmake --preset release -B $(BUILD) >$(BUILD).configure.log 2>&1 || { cat $(BUILD).configure.log; exit 1; }
	@cmake --build $(BUILD) -j $(JOBS)

run: build
	@$(PMR) run $(CASE) -o $(OUT)

test: build
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE slow

test-slow: build
	@scripts/install-packages packages-slow.txt
	@ctest --test-dir $(BUILD) --output-on-failure -L slow

verify: build
	@$(PMR) verify

# Against LIGGGHTS (docs/benchmarks.md); BENCH="--sizes 3862 --samples 1" for a part.
bench: build
	@python3 bench/mechanics.py $(BENCH)

bench-bed: build
	@python3 bench/settled_bed.py $(BENCH)

# Rays per second against plain Embree.
bench-tracing: build
	@cmake --build $(BUILD) --target bench_tracing
	@python3 bench/tracing.py $(BENCH)

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	@rm -rf build
