#include "target.h"

#include <specbake/image/texel_decoder.h>
#include <specbake/image/texture_reader.h>

#include <array>
#include <vector>

namespace specbake::fuzz {
namespace {

/// What our own readers know: the library behind them has fuzzers of its own.
bool isPlain(std::string_view text) {
    return text.starts_with("\x89PNG\r\n\x1a\n") || text.starts_with("\xff\xd8\xff") ||
           text.starts_with("\x76\x2f\x31\x01");
}

}  // namespace

void run(std::span<const std::uint8_t> bytes) {
    if (!isPlain(textOf(bytes))) return;
    const InputFile file(bytes);
    TextureReader texture(file.path());
    const TextureInfo& info = texture.info();
    std::vector<std::string> notes;
    const TexelDecoder decoder(info, chosenMeaning(info, {}, notes));
    const auto width = std::size_t(info.data.width);
    std::vector<std::byte> row(info.bytesPerRow());
    std::vector<std::array<float, 3>> colors(width);
    std::vector<float> alpha(width);
    for (int y = 0; y < info.data.height; ++y) {
        texture.readRows(y, 1, row);
        decoder.decode(row, width, colors.data(), alpha.data());
    }
}

}  // namespace specbake::fuzz
