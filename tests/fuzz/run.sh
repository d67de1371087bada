#!/usr/bin/env bash
# Runs the fuzzers of a build one after the other:  run.sh BUILD SECONDS [TARGET...]
# SECONDS are those of all targets together. What they learn is kept in BUILD/corpus, a finding in
# BUILD/findings; the exit status is 1 if there is any. Prints a line per target.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
images=$here/../../testimages
build=$1
total=$2
shift 2
targets=("$@")
if [ ${#targets[@]} = 0 ]; then
    targets=("$build"/fuzz_*)  # those that were built
    targets=("${targets[@]##*/fuzz_}")
fi
corpus=$build/corpus
findings=$build/findings
mkdir -p "$findings"

# Small files to begin with; those of tests/fuzz/seeds are of the target that their folder names.
seed() { # TARGET
    mkdir -p "$corpus/$1"
    [ ! -d "$here/seeds/$1" ] || cp -n "$here/seeds/$1"/* "$corpus/$1"
    case $1 in
        plain | texture) find "$images" \( -name '*.png' -o -name '*.jpg' -o -name '*.exr' \) \
            -size -8k -exec cp -n {} "$corpus/$1" \; ;;
        profile) find -L /usr/share/color/icc -name '*.icc' -size -16k -exec cp -n {} "$corpus/$1" \; ;;
        spectral) find "$images" -name '*.exr' -size -8k -exec cp -n {} "$corpus/$1" \; ;;
    esac
}

# The last number behind a word of libFuzzer's output.
figure() { # WORD FILE
    grep -oE "$1:? *[0-9]+" "$2" | tail -1 | grep -oE '[0-9]+$' || echo 0
}

fuzz() { # TARGET
    local log=$build/$1.log status=0 before
    before=$(find "$findings" -type f | wc -l)
    seed "$1"
    "$build/fuzz_$1" "$corpus/$1" -dict="$here/words.dict" -artifact_prefix="$findings/$1-" \
        -max_total_time=$((total / ${#targets[@]})) -rss_limit_mb=1024 -malloc_limit_mb=600 \
        -timeout=20 -max_len=16384 -print_final_stats=1 -verbosity=1 >"$log" 2>&1 || status=1
    printf '%-10s %10s inputs %6s edges %4s findings\n' "$1" \
        "$(figure stat::number_of_executed_units "$log")" "$(figure cov "$log")" \
        $(($(find "$findings" -type f | wc -l) - before))
    [ $status = 0 ] || tail -n 25 "$log"
    return $status
}

failed=0
for target in "${targets[@]}"; do fuzz "$target" || failed=1; done
exit $failed
