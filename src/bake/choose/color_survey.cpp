#include "choose/color_survey.h"

#include "pipeline.h"

#include <specbake/core/color_hash.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <tuple>
#include <utility>

namespace specbake::internal {
namespace {

constexpr int kRows = 16;

bool isFinite(const TexelColor& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
}

/// The different ones of some texels' colours, in order.
std::vector<ColorCount> counted(std::vector<TexelColor> colors) {
    std::erase_if(colors, [](const TexelColor& color) { return !isFinite(color); });
    std::sort(colors.begin(), colors.end());
    std::vector<ColorCount> different;
    for (const TexelColor& color : colors) {
        if (different.empty() || different.back().color != color) different.push_back({color, 0});
        ++different.back().texels;
    }
    return different;
}

/// A tally on its way: lists of colours are appended, and now and then made one.
class Tallying {
  public:
    explicit Tallying(std::size_t most) : most_(most) {}

    void add(std::span<const ColorCount> colors) {
        for (const ColorCount& c : colors) entries_.push_back({hashOf(c.color), c});
        if (entries_.size() > 2 * std::max(merged_, most_ / 8)) merge();
    }

    ColorTally result() {
        merge();
        ColorTally tally{{}, all_};
        for (const Entry& entry : entries_) tally.colors.push_back(entry.color);
        return tally;
    }

  private:
    struct Entry {
        std::uint64_t hash;
        ColorCount color;
    };

    /// What is dropped has a larger hash than all that is kept, then and later: so that what is
    /// kept in the end has lost none of its texels.
    void merge() {
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return std::tie(a.hash, a.color.color) < std::tie(b.hash, b.color.color);
        });
        std::size_t count = 0;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            if (count > 0 && entries_[count - 1].color.color == entries_[i].color.color) {
                entries_[count - 1].color.texels += entries_[i].color.texels;
            } else {
                entries_[count++] = entries_[i];
            }
        }
        all_ = all_ && count <= most_;
        merged_ = std::min(count, most_);
        entries_.resize(merged_);
    }

    std::size_t most_;
    std::vector<Entry> entries_;
    std::size_t merged_ = 0;
    bool all_ = true;
};

}  // namespace

void surveyColors(const TexelSource& source,
                  const std::function<void(std::span<const ColorCount>)>& visit) {
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
        visit(counted(std::move(colors)));
    };
    runPipeline(bands, {read, process, [](int) {}}, source.threads, source.stop);
}

ColorTally tallyColors(const TexelSource& source, std::size_t most) {
    Tallying tallying(most);
    std::mutex mutex;
    surveyColors(source, [&](std::span<const ColorCount> colors) {
        const std::lock_guard lock(mutex);
        tallying.add(colors);
    });
    return tallying.result();
}

}  // namespace specbake::internal
