# make bench    measure every estimator and write results/report.html
# make test     run all tests, with the GPU backend on a software driver if need be, and count them
# make mutants  plant bugs one by one and write tests/mutants/RESULTS.md: which tests notice (half an hour)
# make assets   fetch public models and environment maps into assets/
#
# Each target first installs what it needs and is not there yet (scripts/setup.sh).

CARGO ?= cargo
OUT ?= results

.PHONY: bench test mutants assets setup

bench: setup
	$(CARGO) run --release --package interreflect -- bench --out $(OUT)

test: setup
	@CARGO="$(CARGO)" ./scripts/test.sh

mutants: setup
	@CARGO="$(CARGO)" ./scripts/mutants.sh

assets:
	@./scripts/assets.sh

setup:
	@./scripts/setup.sh
