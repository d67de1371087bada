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

/// Who integrates a table's spectra: what is asked for has the colour that the reader's white gives
/// to the space.
class Reader {
  public:
    Reader(const Observer& observer, const Upsampler& u)
        : observer_(observer), xyz_(xyzFromRGB(u.space(), observer, u.options().adapt)) {}

    /// The table's quadrature or the other one.
    static Reader own(const Upsampler& u) { return {u.observer(), u}; }
    static Reader otherwise(const Upsampler& u) {
        const Observer& own = u.observer();
        const bool isFine = own.quadrature() == Quadrature::fine;
        return {Observer(own.illuminant(), isFine ? Quadrature::bands : Quadrature::fine,
                         isFine ? Wavelengths() : own.knots(), own.functions()),
                u};
    }

    /// CIEDE2000 of a spectrum whose values stand at `knots`.
    double error(const Upsampler::Color& asked, const Spectrum& given,
                 const Wavelengths& knots) const {
        const RGB rgb{double(asked[0]), double(asked[1]), double(asked[2])};
        const XYZ& white = observer_.white();
        const XYZ color = observer_.color(read(given, knots));
        return ciede2000(labFromXYZ(XYZ(rgb * xyz_), white), labFromXYZ(color, white));
    }

  private:
    /// At this reader's own bands.
    Spectrum read(const Spectrum& spectrum, const Wavelengths& knots) const {
        if (observer_.knots() == knots) return spectrum;
        Spectrum result{};
        for (int m = 0; m < observer_.knots().count; ++m) {
            result[std::size_t(m)] = valueAt(spectrum, knots, observer_.knots().at(m));
        }
        return result;
    }

    Observer observer_;
    Imath::M33d xyz_;
};

class Survey {
  public:
    Survey(const SpectralTable& table, const Upsampler& upsampler)
        : table_(table), upsampler_(upsampler) {}

    /// Over the draws that `counts` takes and that a reflectance can have.
    template <class Filter>
    void over(const Filter& counts, TableErrors& own, TableErrors& otherwise) const {
        CubeColors draws(2);
        std::vector<double> ownErrors, otherErrors;
        const Wavelengths knots = upsampler_.observer().knots();
        std::size_t drawn = 0;
        for (; drawn < kColors * kDrawsPerColor && ownErrors.size() < kColors; ++drawn) {
            const Upsampler::Color color = draws.next();
            if (!counts(color) || !upsampler_.solid().contains(upsampler_.xyz(color))) continue;
            const Spectrum given = spectrumOf(color);
            ownErrors.push_back(own_.error(color, given, knots));
            otherErrors.push_back(otherwise_.error(color, given, knots));
        }
        own = statistics(std::move(ownErrors), drawn);
        otherwise = statistics(std::move(otherErrors), drawn);
    }

  private:
    Spectrum spectrumOf(const Upsampler::Color& color) const {
        std::array<float, kBandCount> bands{};
        table_.evalBands(table_.locate(color[0], color[1], color[2]), bands.data());
        Spectrum spectrum;
        std::copy(bands.begin(), bands.end(), spectrum.begin());
        return spectrum;
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
    Reader own_ = Reader::own(upsampler_);
    Reader otherwise_ = Reader::otherwise(upsampler_);
};

}  // namespace

TableSurvey surveyed(const SpectralTable& table, const Grid& grid, const NodeSpectra& nodes,
                     const Upsampler& upsampler) {
    const Survey survey(table, upsampler);
    TableSurvey found;
    survey.over([](const Upsampler::Color&) { return true; }, found.own.everywhere,
                found.otherwise.everywhere);
    if (nodes.areAttainable()) return found;
    survey.over([&](const Upsampler::Color& color) { return nodes.isCut(grid.locate(color)); },
                found.own.atBoundary, found.otherwise.atBoundary);
    return found;
}

}  // namespace specbake::internal
