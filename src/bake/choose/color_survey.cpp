#include "choose/color_survey.h"

#include "pipeline.h"

#include <specbake/core/color_hash.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <set>

namespace specbake::internal {
namespace {

constexpr int kRows = 16;

bool isFinite(const TexelColor& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
}

void keepDifferent(std::vector<TexelColor>& colors) {
    std::erase_if(colors, [](const TexelColor& color) { return !isFinite(color); });
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
}

}  // namespace

void surveyColors(const TexelSource& source,
                  const std::function<void(std::span<const TexelColor>)>& visit) {
    const TextureInfo& info = source.info();
    const int bands = (info.data.height + kRows - 1) / kRows;
    std::vector<std::vector<std::byte>> stored{std::size_t(bands)};
    const auto read = [&](int band) {
        const int rows = std::min(kRows, info.data.height - band * kRows);
        stored[std::size_t(band)].resize(std::size_t(rows) * info.bytesPerRow());
        source.texture.readRows(band * kRows, rows, stored[std::size_t(band)]);
    };
    const auto process = [&](int band) {
        std::vector<std::byte>& samples = stored[std::size_t(band)];
        const std::size_t texels =
            samples.size() / info.bytesPerRow() * std::size_t(info.data.width);
        std::vector<TexelColor> colors(texels);
        std::vector<float> alpha(texels);
        source.decoder.decode(samples, texels, colors.data(), alpha.data());
        samples = {};
        keepDifferent(colors);
        visit(colors);
    };
    runPipeline(bands, {read, process, [](int) {}}, source.threads, source.stop);
}

std::vector<TexelColor> sampleColors(const TexelSource& source, std::size_t most) {
    // The colours of smallest hash: whatever the order in which they come.
    std::set<std::pair<std::uint64_t, TexelColor>> smallest;
    std::mutex mutex;
    const auto visit = [&](std::span<const TexelColor> colors) {
        const std::lock_guard lock(mutex);
        for (const TexelColor& color : colors) {
            const std::uint64_t hash = hashOf(color);
            if (smallest.size() == most && hash > smallest.rbegin()->first) continue;
            smallest.emplace(hash, color);
            if (smallest.size() > most) smallest.erase(std::prev(smallest.end()));
        }
    };
    surveyColors(source, visit);
    std::vector<TexelColor> sample;
    for (const auto& [hash, color] : smallest) sample.push_back(color);
    std::sort(sample.begin(), sample.end());
    return sample;
}

}  // namespace specbake::internal
