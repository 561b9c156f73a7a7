#!/usr/bin/env bash
# Builds the grader of the self-check page from the sources of the library: a WebAssembly module, deflated.
# Needs the target wasm32-unknown-unknown and zopfli, which deflates better than what a page could afford to run; with
# binaryen's wasm-opt the module becomes a tenth smaller.
set -euo pipefail
cd "$(dirname "$0")/../.."

# Small before fast: the module travels in every page. The names of source files stay out of it.
export CARGO_PROFILE_RELEASE_OPT_LEVEL="${OPT_LEVEL:-z}" CARGO_PROFILE_RELEASE_LTO=fat CARGO_PROFILE_RELEASE_PANIC=abort
export CARGO_PROFILE_RELEASE_CODEGEN_UNITS=1 CARGO_PROFILE_RELEASE_STRIP=true
export RUSTFLAGS="--remap-path-prefix=$PWD=. --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo"
target="${CARGO_TARGET_DIR:-target}"
cargo rustc --locked --release --lib --crate-type cdylib --no-default-features --target wasm32-unknown-unknown

module="$target/wasm32-unknown-unknown/release/vibank.wasm"
if command -v wasm-opt >/dev/null; then
    wasm-opt --flatten --rereloop -Os --all-features "$module" -o "$module.small"
    module="$module.small"
fi
zopfli --deflate --i60 -c "$module" >src/wasm/grader.deflate
# What it was built from: `cargo test` says when the sources have changed since.
find src -name '*.rs' -not -path 'src/cli/*' -not -path 'src/output/*' -not -path src/main.rs -print0 |
    LC_ALL=C sort -z | xargs -0 cat | sha256sum | cut -c 1-64 >src/wasm/grader.sources
wc -c src/wasm/grader.deflate
