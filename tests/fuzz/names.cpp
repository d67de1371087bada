#include "target.h"

#include <specbake/core/quadrature.h>
#include <specbake/image/spectral_layout.h>
#include <specbake/image/texture_reader.h>

#include <cmath>

namespace specbake::fuzz {

/// Texts that stand in files: channels' names, lists, wavelengths.
void run(std::span<const std::uint8_t> bytes) {
    const std::string text(textOf(bytes));
    if (const auto nm = bandWavelength(text)) {
        expect(std::isfinite(*nm));
        // What has a name of ours has it again.
        if (*nm >= 100 && *nm < 1000) {
            const auto again = bandWavelength(bandChannelName(*nm));
            expect(again && std::abs(*again - *nm) <= 1e-6);
        }
    }
    static_cast<void>(isFreeAttributeName(text));
    static_cast<void>(channelList(text));
    static_cast<void>(parseWavelengths(text));
}

}  // namespace specbake::fuzz
