#include "table/survey.h"

#include "table/cube_colors.h"

#include <specbake/core/ciede2000.h>

#include <algorithm>
#include <numeric>

namespace specbake::internal {
namespace {

constexpr std::size_t kColors = 20'000;
/// Where the boundary takes less of the cube than 1 in this many, fewer colours stand for it.
constexpr std::size_t kDrawsPerColor = 200;

class Survey {
  public:
    Survey(const SpectralTable& table, const Upsampler& upsampler)
        : table_(table), upsampler_(upsampler) {}

    /// Over the draws that `counts` takes and that a reflectance can have.
    template <class Filter>
    TableErrors over(const Filter& counts) const {
        CubeColors draws(2);
        std::vector<double> errors;
        std::size_t drawn = 0;
        for (; drawn < kColors * kDrawsPerColor && errors.size() < kColors; ++drawn) {
            const Upsampler::Color color = draws.next();
            if (!counts(color)) continue;
            const XYZ asked = upsampler_.xyz(color);
            if (upsampler_.solid().contains(asked)) errors.push_back(error(color, asked));
        }
        return statistics(std::move(errors), drawn);
    }

  private:
    double error(const Upsampler::Color& color, const XYZ& asked) const {
        std::array<float, kBandCount> bands;
        table_.evalBands(table_.locate(color[0], color[1], color[2]), bands.data());
        Spectrum spectrum;
        std::copy(bands.begin(), bands.end(), spectrum.begin());
        const Observer& observer = upsampler_.observer();
        return ciede2000(labFromXYZ(asked, observer.white()),
                         labFromXYZ(observer.color(spectrum), observer.white()));
    }

    static TableErrors statistics(std::vector<double> errors, std::size_t drawn) {
        if (errors.empty()) return {};
        std::sort(errors.begin(), errors.end());
        const std::size_t n = errors.size();
        TableErrors found;
        found.colors = n;
        found.share = double(n) / double(drawn);
        found.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(n);
        found.p99 = errors[(n * 99 + 99) / 100 - 1];  // nearest rank
        found.max = errors.back();
        return found;
    }

    const SpectralTable& table_;
    const Upsampler& upsampler_;
};

}  // namespace

TableSurvey surveyed(const SpectralTable& table, const Grid& grid, const NodeSpectra& nodes,
                     const Upsampler& upsampler) {
    const Survey survey(table, upsampler);
    TableSurvey found;
    found.everywhere = survey.over([](const Upsampler::Color&) { return true; });
    if (nodes.areAttainable()) return found;
    found.atBoundary =
        survey.over([&](const Upsampler::Color& color) { return nodes.isCut(grid.locate(color)); });
    return found;
}

}  // namespace specbake::internal
