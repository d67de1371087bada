#include "identity/sha1.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace specbake::internal {
namespace {

using State = std::array<std::uint32_t, 5>;

/// FIPS 180-4, 4.1.1 and 4.2.1: the function and the constant of a round.
std::uint32_t mixed(int round, const State& s) {
    const auto& [a, b, c, d, e] = s;
    if (round < 20) return ((b & c) ^ (~b & d)) + 0x5a827999U;
    if (round < 40) return (b ^ c ^ d) + 0x6ed9eba1U;
    if (round < 60) return ((b & c) ^ (b & d) ^ (c & d)) + 0x8f1bbcdcU;
    return (b ^ c ^ d) + 0xca62c1d6U;
}

void addBlock(State& state, std::string_view block) {
    std::array<std::uint32_t, 80> w{};
    for (std::size_t i = 0; i < block.size(); ++i) {
        w[i / 4] = (w[i / 4] << 8) | std::uint32_t(static_cast<unsigned char>(block[i]));
    }
    for (std::size_t t = 16; t < w.size(); ++t) {
        w[t] = std::rotl(w[t - 3] ^ w[t - 8] ^ w[t - 14] ^ w[t - 16], 1);
    }
    State s = state;
    for (int t = 0; t < 80; ++t) {
        const std::uint32_t next = std::rotl(s[0], 5) + mixed(t, s) + s[4] + w[std::size_t(t)];
        s = {next, s[0], std::rotl(s[1], 30), s[2], s[3]};
    }
    for (std::size_t i = 0; i < state.size(); ++i) state[i] += s[i];
}

}  // namespace

std::string sha1(std::string_view bytes) {
    std::string padded(bytes);
    padded += '\x80';
    while (padded.size() % 64 != 56) padded += '\0';
    const std::uint64_t bits = std::uint64_t(bytes.size()) * 8;
    for (int shift = 56; shift >= 0; shift -= 8) padded += char((bits >> shift) & 0xff);
    State state = {0x67452301U, 0xefcdab89U, 0x98badcfeU, 0x10325476U, 0xc3d2e1f0U};
    const std::string_view all = padded;
    for (std::size_t at = 0; at < all.size(); at += 64) addBlock(state, all.substr(at, 64));
    return fmt::format("{:08X}{:08X}{:08X}{:08X}{:08X}", state[0], state[1], state[2], state[3],
                       state[4]);
}

}  // namespace specbake::internal
