#!/usr/bin/env bash
# Builds the grader of the self-check page from the sources of the library: a WebAssembly module, taken apart and deflated.
# Needs the target wasm32-unknown-unknown, Python, and zopfli, which deflates better than what a page could afford to run;
# with binaryen's wasm-opt the module becomes a tenth smaller.
# With `--fresh`, the module alone, for tests: without what panics say, but neither made smaller nor committed.
set -euo pipefail
cd "$(dirname "$0")/../.."

# Small before fast: the module travels in every page. The names of source files stay out of it.
export CARGO_PROFILE_RELEASE_OPT_LEVEL="${OPT_LEVEL:-z}" CARGO_PROFILE_RELEASE_LTO=fat CARGO_PROFILE_RELEASE_PANIC=abort
# Names of functions stay until `snip.py` has found by them what only panics need, and relocations by which it knows what is
# needed for nothing else.
export CARGO_PROFILE_RELEASE_CODEGEN_UNITS=1 CARGO_PROFILE_RELEASE_STRIP=debuginfo
export RUSTFLAGS="-C symbol-mangling-version=v0 -C link-arg=--emit-relocs --cfg sha2_backend_soft=\"compact\" --remap-path-prefix=$PWD=. --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo"
target="${CARGO_TARGET_DIR:-target}"
cargo rustc --locked --release --lib --crate-type cdylib --no-default-features --target wasm32-unknown-unknown

built="$target/wasm32-unknown-unknown/release/vibank.wasm"
module="$target/wasm32-unknown-unknown/release/grader.wasm"
python3 src/wasm/snip.py "$built" "$module"
if [ "${1-}" = --fresh ]; then
    echo "$module"
    exit
fi
if command -v wasm-opt >/dev/null; then
    # What the first round leaves is a little less once more. No pointer is below 1 kB, where the stack ends, so that what
    # is added to one may become a part of the instruction that follows it.
    wasm-opt --low-memory-unused --flatten --rereloop -Os -Os --all-features "$module" -o "$module.small"
    module="$module.small"
fi
python3 src/wasm/order.py "$module" "$module.ordered"
python3 src/wasm/streams.py "$module.ordered" "$module.streams"
zopfli --deflate --i60 -c "$module.streams" >src/wasm/grader.deflate
# What it was built from: `cargo test` says when that has changed since.
src/wasm/digest.sh >src/wasm/grader.sources
wc -c src/wasm/grader.deflate
