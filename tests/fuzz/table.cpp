#include "target.h"

#include <specbake/image/table_file.h>
#include <specbake/sampler.h>

#include <array>
#include <limits>
#include <vector>

namespace specbake::fuzz {
namespace {

/// Reads what a renderer reads; the samples of a table that is no table may be anything.
void lookUp(const SpectralTable& table) {
    constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 7> components = {0, 1, 0.3F, -1, 2, notANumber, infinite};
    constexpr std::array<float, 9> nm = {360,   380,        780,      830,      555,
                                         1e30F, notANumber, infinite, -infinite};
    std::array<float, SpectralTable::kMostBands> bands{};
    for (std::size_t i = 0; i < components.size(); ++i) {
        const SpectralTable::Place place =
            table.locate(components[i], components[(i + 1) % 7], components[(i + 3) % 7]);
        table.eval(place, table.wavelengths<9>(nm), bands.data());
        table.evalBands(place, bands.data());
    }
}

}  // namespace

void run(std::span<const std::uint8_t> bytes) {
    SpectralTable table;
    if (table.view(bytes.data(), bytes.size()) == SpectralTable::Status::ok) {
        static_cast<void>(table.intact());
        lookUp(table);
    }
    const auto all = std::as_bytes(bytes);
    const TableFile file("table", std::vector<std::byte>(all.begin(), all.end()));
    static_cast<void>(file.facts());
    static_cast<void>(file.bands());
}

}  // namespace specbake::fuzz
