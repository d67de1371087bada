#include "file/write_stream.h"

#include "support/below.h"
#include "support/contents.h"
#include "support/temporary_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <random>
#include <string>

using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;

std::string randomBytes(Random& random) {
    constexpr std::size_t most[] = {20, 5000, 70000, 300000};
    std::string bytes(below(random, most[below<std::size_t>(random, 4)]), '\0');
    for (char& c : bytes) c = char(random());
    return bytes;
}

/// The same in memory.
void put(std::string& file, const std::string& bytes, std::size_t offset) {
    if (file.size() < offset + bytes.size()) file.resize(offset + bytes.size(), '\0');
    file.replace(offset, bytes.size(), bytes);
}

/// Space that a file has on its disk.
std::uint64_t spaceOf(const std::string& path) {
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    return std::uint64_t(status.st_blocks) * 512;
}

}  // namespace

TEST_CASE("a file holds what was written, in whatever pieces, one behind the other or not") {
    for (unsigned seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const TemporaryFile file("");
        std::string expected;
        WriteStream stream(file.path());
        if (below<std::size_t>(random, 2) == 0)
            REQUIRE(stream.reserve(below<std::size_t>(random, 4000000)));
        for (std::size_t piece = below<std::size_t>(random, 60); piece > 0; --piece) {
            const std::string bytes = randomBytes(random);
            const bool goesOn = below<std::size_t>(random, 8) != 0;
            const std::size_t offset =
                goesOn ? expected.size() : below(random, expected.size() + 100000);
            REQUIRE(stream.write(bytes.data(), bytes.size(), offset));
            if (!bytes.empty()) put(expected, bytes, offset);
        }
        REQUIRE(stream.close());
        CHECK(stream.error().empty());
        CHECK(contentsOf(file.path()) == expected);
    }
}

TEST_CASE("no space is left behind a file that was taken for it") {
    const TemporaryFile file("");
    const std::string piece(100000, 'x');
    constexpr std::size_t pieces = 37;
    WriteStream stream(file.path());
    REQUIRE(stream.reserve(std::uint64_t(1) << 28));
    for (std::size_t i = 0; i < pieces; ++i) {
        REQUIRE(stream.write(piece.data(), piece.size(), i * piece.size()));
    }
    REQUIRE(stream.close());
    // What a disk gives out is blocks, of 64 KiB at most, and a few of them tell where the others
    // are.
    CHECK(spaceOf(file.path()) <= pieces * piece.size() + 4 * 65536);
}

TEST_CASE("space that no disk has is refused before anything is written") {
    const TemporaryFile file("");
    WriteStream stream(file.path());
    const bool taken = stream.reserve(std::uint64_t(1) << 60);
    CHECK(taken == stream.error().empty());
    CHECK(spaceOf(file.path()) == 0);
    CHECK(stream.close() == taken);
}

TEST_CASE("what could not be written is said at the end, however little it was") {
    WriteStream stream("/dev/full");
    static_cast<void>(stream.write("a", 1, 0));
    CHECK(!stream.close());
    CHECK(!stream.error().empty());
}
