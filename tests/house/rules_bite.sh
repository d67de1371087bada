#!/usr/bin/env bash
# Every house rule finds what it forbids, and nothing in a clean tree:  rules_bite.sh HOUSE-RULES
set -euo pipefail
rules=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

unset "${!GIT_@}"  # of a hook that runs the tests: the trees below are no part of its history
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null

plant() { # FILE, content on standard input: a tree that holds this file only
    rm -rf "$tree"/* "$tree/.git"
    mkdir -p "$tree/$(dirname "$1")"
    cat >"$tree/$1"
}

crowd() { # FOLDER COUNT: a tree that holds so many files there
    plant "$1/0" </dev/null
    for ((i = 1; i < $2; ++i)); do : >"$tree/$1/$i"; done
}

offends() { # RULE PLACE [COMMIT]: the rule finds something there in the tree as it is
    local said
    if said=$("$rules" "$tree" "${@:3}") || ! grep -q "^$1: $2\|^$1: ./$2" <<<"$said"; then
        echo "$1 does not bite in $2; it said: $said" >&2
        exit 1
    fi
}

passes() { # PLACE [COMMIT]: no rule finds anything in the tree as it is
    local said
    said=$("$rules" "$tree" "${@:2}") || { echo "no offence meant in $1, but: $said" >&2; exit 1; }
}

bites() { # RULE FILE, content on standard input
    plant "$2"
    offends "$1" "$2"
}

spares() { # FILE, content on standard input
    plant "$1"
    passes "$1"
}

in_tree() { git -C "$tree" -c user.name=A -c user.email=a@example.org "$@"; }

history() { # MESSAGE...: a tree with a commit for each
    plant a </dev/null
    in_tree init -q
    for message in "$@"; do in_tree commit -q --allow-empty -m "$message"; done
}

head_commit() { in_tree rev-parse HEAD; }

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
spares src/core/include/specbake/sampler.h < <(echo '#pragma once'; yes '' | head -349)
bites short-sources src/core/include/specbake/sampler.h < <(echo '#pragma once'; yes '' | head -350)
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

crowd src/core/color 27
offends roomy-folders src/core/color
crowd tests/core 26
passes tests/core

if command -v git >/dev/null; then
    long=$(printf 'é%.0s' {1..72})
    history 'No body' 'One' 'Two'
    offends commit-body "$(head_commit)" HEAD~1
    history 'One' $'Signed\n\nSigned-off-by: A <a@example.org>'
    offends commit-body "$(head_commit)" HEAD~1
    history 'One' "${long}é"$'\n\nWhy.'
    offends commit-subject "$(head_commit)" HEAD~1
    history 'One' $'Two\nlines\n\nWhy.'
    offends commit-subject "$(head_commit)" HEAD~1
    history 'No body' "$long"$'\n\nWhy.\n\nTested: so.'
    passes 'the last commit' HEAD~1
    passes 'a history without the commit' # as a shallow one
fi
