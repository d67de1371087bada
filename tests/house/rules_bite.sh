#!/usr/bin/env bash
# Every house rule finds what it forbids, and nothing in a clean tree:  rules_bite.sh HOUSE-RULES
set -euo pipefail
rules=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

plant() { # FILE, content on standard input: a tree that holds this file only
    rm -rf "$tree"/*
    mkdir -p "$tree/$(dirname "$1")"
    cat >"$tree/$1"
}

bites() { # RULE FILE, content on standard input
    local said
    plant "$2"
    if said=$("$rules" "$tree") || ! grep -q "^$1: $2\|^$1: ./$2" <<<"$said"; then
        echo "$1 does not bite in $2; it said: $said" >&2
        exit 1
    fi
}

spares() { # FILE, content on standard input
    local said
    plant "$1"
    said=$("$rules" "$tree") || { echo "no offence meant in $1, but: $said" >&2; exit 1; }
}

bites core-includes src/core/a.cpp <<<'#include <specbake/image/reader.h>'
bites core-includes src/core/a.cpp <<<'#include <OpenImageIO/imageio.h>'
bites image-includes src/image/a.cpp <<<'#include <specbake/bake/bake.h>'
bites bake-includes src/bake/a.cpp <<<'#include <specbake/tools/options.h>'
bites no-include-by-path tools/a.cpp <<<'#include "../src/core/tables.h"'
bites no-include-by-path tests/a.cpp <<<'#include "unit/../a.h"'
bites no-printing src/core/a.cpp <<<'std::cout << 1;'
bites no-printing src/image/a.cpp <<<'    fprintf(stderr, "x");'
bites no-exit src/bake/a.cpp <<<'std::exit(1);'
bites no-chance src/core/a.cpp <<<'std::random_device seed;'
bites columns src/core/a.cpp < <(printf '// %0100d\n' 0)
bites columns CMakeLists.txt < <(printf '# %0100d\n' 0)
bites short-headers src/core/a.h < <(echo '#pragma once'; yes '' | head -160)
bites short-sources tools/a.cpp < <(yes '' | head -351)
bites pragma-once src/core/a.h <<<'int a;'
bites no-silencing src/core/a.cpp <<<'int a;  // NOLINT'
bites any-processor src/core/CMakeLists.txt <<<'add_compile_options(-march=native)'

spares src/core/a.cpp < <(
    printf '#include <Imath/ImathVec.h>\n#include <vector>\n#include "tables.h"\n'
    printf 'int n = std::snprintf(p, 2, "1");  // unlike printf(\nwriter.abort();\n'
    printf '// %s\n' "$(printf 'λ%.0s' {1..97})"
    yes '' | head -344)
spares src/core/a.h < <(echo '#pragma once'; yes '' | head -159)
spares tools/specbake/main.cpp <<<'std::cerr << error.what(); return 1;'
