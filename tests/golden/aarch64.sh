#!/usr/bin/env bash
# A program for aarch64, which qemu runs, beside the bytes on record:
#   aarch64.sh BUILD PACKAGE...
#
# BUILD/root is a Debian of that architecture with the PACKAGEs of the build; they are unpacked, and
# nothing of them is set up. Wants to be root, as debootstrap does. Exit status as of bytes.sh.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath -m "$1")
root=$build/root
shift

unpack() { # PACKAGE...
    local package
    debootstrap --foreign --arch=arm64 --variant=minbase --include="$(IFS=, && echo "$*")" \
        bookworm "$root"
    for package in "$root"/var/cache/apt/archives/*.deb; do
        dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C "$root"
    done
    touch "$root/unpacked"
}

[ -e "$root/unpacked" ] || unpack "$@"
cmake -S . -B "$build" -G Ninja --toolchain cmake/aarch64-toolchain.cmake --log-level=WARNING \
    -D CMAKE_SYSROOT="$root" -D CMAKE_BUILD_TYPE=Release -D SPECBAKE_BUILD_TESTS=OFF \
    -D SPECBAKE_BUILD_BENCH=OFF -D SPECBAKE_BUILD_PYTHON=OFF
cmake --build "$build" --target specbake
# The kernel starts no reader of this architecture; liblapack is where Debian's alternatives would find
# it.
libraries=/usr/lib/aarch64-linux-gnu
cat >"$build/run" <<END
#!/bin/sh
command=\$1
shift
exec qemu-aarch64 -L "$root" -E LD_LIBRARY_PATH=$libraries/blas:$libraries/lapack \\
    "$build/specbake" "\$command" --isolate never "\$@"
END
chmod +x "$build/run"
tests/golden/bytes.sh "$build/run" tests/golden/bytes.sha256
