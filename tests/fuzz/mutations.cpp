/// mutations COUNT FILE...: a target of libFuzzer without libFuzzer: what those of the files hold
/// that are small, then COUNT mutations of it, the same in every run. For compilers that have no
/// libFuzzer, and for tests, which must not depend on chance.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// Of those targets that have one.
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                             std::size_t maxSize, unsigned seed);

namespace {

constexpr std::size_t kMostBytes = 16384;
constexpr std::size_t kMostOfSeed = 8192;
using Bytes = std::vector<std::uint8_t>;

std::uint32_t chance() {
    static std::mt19937 random(1);
    return std::uint32_t(random());
}

std::size_t below(std::size_t end) {
    return chance() % end;
}

/// Numbers that sizes and counts are misjudged by.
void writeNumber(std::uint8_t* at, std::size_t room) {
    constexpr std::array<std::uint32_t, 8> numbers = {
        0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x01000000, 0xFFFF, 0x10000};
    const std::uint32_t number = numbers[below(numbers.size())];
    std::memcpy(at, &number, std::min(room, sizeof number));
}

/// Sixteen zeros if there is no file.
std::vector<Bytes> seedsOf(const std::vector<std::string>& paths) {
    std::vector<Bytes> seeds;
    for (const std::string& path : paths) {
        if (std::filesystem::file_size(path) > kMostOfSeed) continue;
        std::ifstream file(path, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    if (seeds.empty()) seeds.emplace_back(16);
    return seeds;
}

void run(const Bytes& bytes) {
    // Of its own size, so that a sanitizer sees what goes beyond.
    const Bytes exact(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

}  // namespace

/// What a target's own mutator asks for: libFuzzer's interface.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize) {
    if (size == 0) return 0;
    const std::size_t at = below(size);
    switch (below(6)) {
        case 0:
            data[at] ^= std::uint8_t(1U << below(8));
            return size;
        case 1:
            data[at] = std::uint8_t(below(256));
            return size;
        case 2:
            writeNumber(data + at, size - at);
            return size;
        case 3:  // the end is missing
            return at;
        case 4: {  // a piece is missing
            const std::size_t length = 1 + below(std::min<std::size_t>(size - at, 64));
            std::memmove(data + at, data + at + length, size - at - length);
            return size - length;
        }
        default: {  // a piece is there twice
            const std::size_t length =
                std::min(1 + below(std::min<std::size_t>(size - at, 64)), maxSize - size);
            std::memmove(data + at + length, data + at, size - at);
            return size + length;
        }
    }
}

namespace {

Bytes mutated(const std::vector<Bytes>& seeds) {
    Bytes bytes = seeds[below(seeds.size())];
    std::size_t size = bytes.size();
    bytes.resize(kMostBytes);
    for (std::size_t i = 1 + below(4); i > 0; --i) {
        size = LLVMFuzzerCustomMutator != nullptr
                   ? LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), chance())
                   : LLVMFuzzerMutate(bytes.data(), size, bytes.size());
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const std::vector<Bytes> seeds = seedsOf({argv + 2, argv + argc});
    for (const Bytes& seed : seeds) run(seed);
    const int count = std::atoi(argv[1]);
    for (int i = 0; i < count; ++i) run(mutated(seeds));
    std::printf("%zu seeds, %d mutations\n", seeds.size(), count);
    return 0;
}
