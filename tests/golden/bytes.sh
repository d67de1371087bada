#!/usr/bin/env bash
# The bytes that a bake writes, beside those on record:
#   bytes.sh SPECBAKE RECORD [--record]
#
# A line of RECORD is a hash and a case: a texture, and options. Cases of ../shared are passed over
# where the folder is not there. The attribute specbake:identity, a sentence that is worded anew with
# every option that comes, is left out of the hash, and so is oiio:SHA-1, which is made of it. Exit code 1 if any file has other bytes, or cannot be made;
# --record writes the hashes anew. The bytes are those of a processor with fused multiply-adds.
set -uo pipefail
specbake=$(realpath "$1")
record=$(realpath "$2")
mode=${3:-}
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

plain=testimages/demo.png
alpha=testimages/rgba_half.exr
wide=(testimages/acescg_half.exr testimages/rec2020_float.exr testimages/xyz_float.exr)
shared=../shared/textures
options=("--per-texel" "--method smooth" "--method descent" "--method descent --per-texel"
    "--mipmap" "-d float"
    "--outside scale" "--grid 5" "--illuminant A" "--bits 7" "--max-de 0.1" "--max-deviation 0.005"
    "--tile 32 16" "--compression none" "--compression zips" "--compression piz"
    "--compression zip:9" "--mipmap -d float --compression piz")

# A texture and its options, a line each.
cases() {
    local texture choice
    for texture in testimages/*.{png,jpg,exr,tif,tga,bmp,hdr}; do echo "$texture"; done
    for choice in "${options[@]}"; do
        for texture in "$plain" "$alpha" "${wide[@]}"; do echo "$texture $choice"; done
    done
    for texture in wood_2k.jpg fabric_1k.jpg grass_1k.png kodim03.png RgbRampsDiagonal.exr \
        WideColorGamut.exr Carrots_ap0.exr wall_front_ACEScg.exr; do
        echo "$shared/$texture"
        echo "$shared/$texture -d float --mipmap"
    done
    echo "$shared/kodim03.png --per-texel"
    echo "$shared/kodim03.png --method descent"
}

# hash CASE: "HASH CASE", or "none CASE" if there is no such file.
hash() {
    local file words
    read -ra words <<<"$1"
    file=$(mktemp -p "$work" XXXXXX.exr)
    if "$specbake" bake -q "${words[@]}" -o "$file" 2>/dev/null; then
        echo "$(python3 tests/golden/without_identity.py "$file" | sha256sum | cut -c 1-64) $1"
    else
        echo "none $1"
    fi
    rm -f "$file"
}
export -f hash
export specbake work

cases | while read -r line; do
    [ -e "${line%% *}" ] && echo "$line"
done | xargs -d '\n' -P "$(nproc)" -I {} bash -c 'hash "$1"' hash {} | sort -k 2 >"$work/now"

if [ "$mode" = --record ]; then
    cp "$work/now" "$record"
    echo "$(wc -l <"$record") hashes recorded"
    exit 0
fi
changed=$(grep -vxFf "$record" "$work/now" | sed 's/^[^ ]* /other bytes: /')
if [ -n "$changed" ]; then
    echo "$changed"
    exit 1
fi
echo "$(wc -l <"$work/now") files, the same bytes as on record"
