# Other processors: the goldens must hold on each of them. Sourced by .ci/run and .ci/controls.
#
# rustup's toolchain has std for the host only, so Debian's cargo builds std from source; QEMU's user
# mode and Node run the tests. s390x is the big-endian one, i686 and wasm32 have 32 bits.

foreign_targets=(
    i686-unknown-linux-gnu
    aarch64-unknown-linux-gnu
    s390x-unknown-linux-gnu
    wasm32-wasip1
)

# Bytes that WebAssembly begins with. Node 20 can crash when a memory grows while its collector runs.
wasm_memory=$((2 << 30))

# The modules of tests/main.rs that run there; `golden` also those of that name in other modules.
foreign_tests=(golden math snapshot replay)

# Optimised is what takes the time of the tests, the library and its hash: std and the other packages
# are built in half the time without, and their generic code is compiled with the library anyway.
foreign_cargo() {
    local wasi=/usr/lib/wasm32-wasi
    env -u RUSTFLAGS -u RUSTUP_TOOLCHAIN \
        RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1 \
        CARGO_TARGET_DIR="$cache/foreign" VERLOCK_EMULATED=1 \
        CARGO_PROFILE_DEV_DEBUG=0 CARGO_PROFILE_DEV_OPT_LEVEL=${foreign_opt:-2} \
        CARGO_TARGET_I686_UNKNOWN_LINUX_GNU_LINKER=i686-linux-gnu-gcc \
        CARGO_TARGET_I686_UNKNOWN_LINUX_GNU_RUNNER="qemu-i386-static -L /usr/i686-linux-gnu" \
        CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc \
        CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64-static -L /usr/aarch64-linux-gnu" \
        CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc \
        CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_RUNNER="qemu-s390x-static -L /usr/s390x-linux-gnu" \
        CARGO_TARGET_WASM32_WASIP1_LINKER=wasm-ld-22 \
        CARGO_TARGET_WASM32_WASIP1_RUNNER="node --no-warnings $PWD/.ci/wasi.mjs" \
        CARGO_TARGET_WASM32_WASIP1_RUSTFLAGS="-Clink-self-contained=no -Lnative=$wasi \
            -Clink-arg=$wasi/crt1-command.o -Clink-arg=-lc -Clink-arg=--unresolved-symbols=ignore-all \
            -Clink-arg=--initial-memory=$wasm_memory" \
        /usr/bin/cargo --config 'profile.dev.package."*".opt-level=0' \
        --config 'profile.dev.package.xxhash-rust.opt-level=2' "$@"
}

# How `cargo test` is called for a target. WebAssembly has neither unwinding nor threads here.
foreign_options() {
    case $1 in
    wasm32-*) echo -Zbuild-std=std,panic_abort --target "$1" ;;
    *) echo -Zbuild-std=std,panic_unwind --features parallel --target "$1" ;;
    esac
}

# Builds the tests of the given targets, all by default, with one call for those alike: it keeps
# every core busy.
foreign_build() {
    local target native=() wasm=()
    (($#)) || set -- "${foreign_targets[@]}"
    for target; do
        case $target in
        wasm32-*) wasm+=($(foreign_options "$target")) ;;
        *) native+=($(foreign_options "$target")) ;;
        esac
    done
    ((!${#native[@]})) || foreign_cargo test --locked -p verlock --test main --no-run "${native[@]}"
    ((!${#wasm[@]})) || foreign_cargo test --locked -p verlock --test main --no-run "${wasm[@]}"
}

# Runs the tests of one target. A module that is missing there fails: it would prove nothing.
foreign_test() {
    local target=$1 module options
    options=$(foreign_options "$target")
    for module in "${foreign_tests[@]}"; do
        grep -q "^mod ${module%%::*};" tests/main.rs
    done
    local tests=("${foreign_tests[@]/%/::}")
    local run=(foreign_cargo test --locked -p verlock --test main $options --)
    case $target in
    wasm32-*) # No threads there: two processes share the tests.
        local half=(golden::restore:: golden::shift::)
        "${run[@]}" "${half[@]}" &
        local first=$!
        "${run[@]}" "${tests[@]}" "${half[@]/#/--skip=}"
        wait "$first"
        ;;
    *) # The scenes are stepped by threads there anyway.
        "${run[@]}" "${tests[@]}" --skip=golden::threads::
        ;;
    esac
}

# The core without std, for a processor without an operating system and without 64-bit atomics.
bare_build() {
    foreign_cargo build --locked -p verlock --no-default-features \
        -Zbuild-std=core,alloc --target thumbv7em-none-eabihf
}
