#include "deflate/row_deflate.h"

#include "deflate/huffman.h"
#include "support/each_target.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes pack(const Bytes& bytes, std::size_t rowLength, std::size_t rowsBack) {
    Bytes packed(rowDeflateBound(bytes.size()));
    packed.resize(rowDeflate(bytes, rowLength, rowsBack, packed));
    return packed;
}

/// The size of zlib's stream of literals alone.
std::size_t sizeWithoutMatches(Bytes bytes) {
    z_stream stream{};
    REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, 15, 9, Z_HUFFMAN_ONLY) == Z_OK);
    Bytes packed(bytes.size() + 1000);
    stream.next_in = bytes.data();
    stream.avail_in = uInt(bytes.size());
    stream.next_out = packed.data();
    stream.avail_out = uInt(packed.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    const std::size_t size = stream.total_out;
    deflateEnd(&stream);
    return size;
}

/// Packed by us, unpacked by zlib; nothing where it did not become shorter.
Bytes roundTrip(const Bytes& bytes, std::size_t rowLength, std::size_t rowsBack) {
    Bytes packed(rowDeflateBound(bytes.size()) + 8, 0xEE);
    const std::size_t room = rowDeflateBound(bytes.size());
    const std::size_t size = rowDeflate(bytes, rowLength, rowsBack, std::span(packed).first(room));
    CHECK(std::all_of(packed.begin() + std::ptrdiff_t(room), packed.end(),
                      [](std::uint8_t b) { return b == 0xEE; }));
    CHECK(size <= bytes.size());
    if (size == 0) return {};
    Bytes unpacked(bytes.size() + 1);
    uLongf length = unpacked.size();
    REQUIRE(uncompress(unpacked.data(), &length, packed.data(), size) == Z_OK);
    unpacked.resize(length);
    return unpacked;
}

/// Rows that repeat rows up to four back, with as many changed bytes as `noise` says, of an
/// alphabet of `letters`; and stretches of one byte.
Bytes rows(std::mt19937& random, std::size_t size, std::size_t rowLength, unsigned letters,
           double noise) {
    std::bernoulli_distribution changed(noise);
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t back = (1 + i / rowLength % 4) * rowLength;
        const bool fresh = i < back || changed(random);
        bytes[i] = fresh ? std::uint8_t(random() % letters) : bytes[i - back];
        if (i > 0 && i / 97 % 5 == 0) bytes[i] = bytes[i - 1];
    }
    return bytes;
}

}  // namespace

TEST_CASE("zlib reads back what was packed, whatever the rows") {
    std::mt19937 random(1);
    int packed = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const std::size_t rowLength = 1 + random() % (trial % 10 == 0 ? 40'000 : 700);
        const std::size_t size = random() % (trial % 10 == 0 ? 300'000 : 9000);
        const double noise = std::array{0.0, 0.02, 0.3, 1.0}[random() % 4];
        const Bytes bytes = rows(random, size, rowLength, 1 + random() % 256, noise);
        CAPTURE(trial);
        const Bytes back = roundTrip(bytes, rowLength, 1 + random() % 3);
        if (back.empty()) continue;
        ++packed;
        REQUIRE(back == bytes);
    }
    CHECK(packed > 200);
}

TEST_CASE("every size about a block's end, and every length of a run, is read back") {
    std::mt19937 random(6);
    for (const std::size_t size : {65'535U, 65'536U, 65'537U, 65'540U, 131'072U, 131'073U}) {
        const Bytes bytes = rows(random, size, 256, 200, 0.1);
        REQUIRE(roundTrip(bytes, 256, 3) == bytes);
    }
    for (std::size_t run = 1; run <= 600; ++run) {
        Bytes bytes(700, 7);
        std::iota(bytes.begin(), bytes.begin() + 50, std::uint8_t(0));
        std::fill_n(bytes.begin() + 50, run, std::uint8_t(99));
        REQUIRE(roundTrip(bytes, 300, 2) == bytes);
    }
}

TEST_CASE("every distance that deflate has is read back") {
    std::mt19937 random(2);
    for (std::size_t distance = 1; distance <= kDeflateWindow; distance += 1 + distance / 40) {
        const Bytes bytes = rows(random, 3 * distance + 2000, distance, 256, 0.001);
        const Bytes back = roundTrip(bytes, distance, 1);
        if (!back.empty()) REQUIRE(back == bytes);
    }
    const Bytes farthest = rows(random, 4 * kDeflateWindow, kDeflateWindow, 256, 0);
    REQUIRE(roundTrip(farthest, kDeflateWindow, 3) == farthest);
}

TEST_CASE("a stream has the same bytes on every instruction set") {
    std::mt19937 random(7);
    std::vector<Bytes> inputs;
    for (const double noise : {0.0, 0.05, 0.5}) {
        inputs.push_back(rows(random, 200'000, 300, 3, noise));
        inputs.push_back(rows(random, 150'001, 2048, 256, noise));
    }
    std::vector<std::vector<Bytes>> streams;
    onEachTarget([&] {
        auto& of = streams.emplace_back();
        for (const Bytes& bytes : inputs) of.push_back(pack(bytes, 300, 3));
    });
    for (const auto& of : streams) CHECK(of == streams.front());
}

TEST_CASE("where literals cost almost nothing, matches spare bits all the same") {
    // Differences of smooth samples: independent, so that matches are chance and literals serve
    // best.
    for (const double same : {0.6, 0.8, 0.9}) {
        std::mt19937 random(8);
        std::geometric_distribution<int> difference(same);
        Bytes bytes(40 * kDeflateBlock);
        for (auto& b : bytes)
            b = std::uint8_t(128 + (random() % 2 == 0 ? 1 : -1) * difference(random));
        const auto most = double(sizeWithoutMatches(bytes));
        CAPTURE(double(pack(bytes, 2048, 3).size()) / most);
        // The first block, which does not know yet what literals cost, may be half as long again.
        CHECK(double(pack(bytes, 2048, 3).size()) <= most * (1 + 0.5 / 40));
    }
}

TEST_CASE("what cannot be made shorter is told, and is not written beyond its bound") {
    std::mt19937 random(3);
    for (const std::size_t size : {0U, 1U, 2U, 9U, 1000U, 65'536U, 500'000U}) {
        Bytes fresh(size);
        std::generate(fresh.begin(), fresh.end(), [&] { return std::uint8_t(random()); });
        CHECK(roundTrip(fresh, 100, 3).empty());
    }
}

TEST_CASE("skewed counts get the code of least length; the longest word is kept to its limit") {
    // Fibonacci's numbers make the deepest of trees.
    std::vector<std::uint32_t> counts = {1, 1};
    while (counts.size() < 30) counts.push_back(counts.end()[-1] + counts.end()[-2]);
    for (const std::uint32_t longest : {7U, 14U, 30U}) {
        const auto code = huffmanCode(counts, longest);
        double kraft = 0;
        for (const CodeWord& word : code) {
            CHECK(word.length >= 1);
            CHECK(word.length <= longest);
            kraft += std::ldexp(1.0, -int(word.length));
        }
        CHECK(kraft == 1);
    }
    CHECK(huffmanCode(counts, 30)[0].length == 29);
}

TEST_CASE("no word begins another") {
    std::mt19937 random(4);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<std::uint32_t> counts(2 + random() % 100);
        for (auto& count : counts) count = random() % 3 == 0 ? 0 : 1U << random() % 20;
        const auto code = huffmanCode(counts, 9);
        for (std::size_t a = 0; a < code.size(); ++a) {
            for (std::size_t b = 0; b < code.size(); ++b) {
                if (a == b || code[a].length == 0 || code[b].length < code[a].length) continue;
                const std::uint32_t mask = (1U << code[a].length) - 1;
                CHECK((code[b].bits & mask) != code[a].bits);
            }
        }
    }
}

TEST_CASE("a Huffman code is as short as its entropy, to a bit a symbol") {
    const std::vector<std::uint32_t> counts = {5, 0, 900, 1, 40, 40, 77, 3, 0, 2000};
    const auto code = huffmanCode(counts, 15);
    const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
    double bits = 0;
    double entropy = 0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        if (counts[s] == 0) {
            CHECK(code[s].length == 0);
            continue;
        }
        bits += double(counts[s]) * code[s].length;
        entropy += double(counts[s]) * std::log2(total / counts[s]);
    }
    CHECK(bits >= entropy);  // Shannon
    CHECK(bits <= entropy + total);
}
