#include "target.h"

#include <specbake/image/spectral_reader.h>

#include <vector>

namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes) {
    if (!textOf(bytes).starts_with("\x76\x2f\x31\x01")) return;
    const InputFile file(bytes);
    SpectralReader reader(file.path());
    const Window& window = reader.header().data;
    std::vector<float> samples(std::size_t(window.width) * reader.wavelengths().size());
    std::vector<float> alpha(std::size_t(window.width));
    for (int row = 0; row < window.height; ++row) reader.readRows(row, 1, samples, alpha);
}

}  // namespace specbake::fuzz
