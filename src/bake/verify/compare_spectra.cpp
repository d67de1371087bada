#include "pipeline.h"
#include "reading.h"

#include <specbake/bake/compare_spectra.h>
#include <specbake/core/error.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

/// What both files have alike, or a FileError says.
void checkAlike(const std::string& spectral, const SpectralReader& a, const std::string& reference,
                const SpectralReader& b) {
    const auto sizeOf = [](const SpectralReader& reader) {
        const Window& w = reader.header().data;
        return std::to_string(w.width) + " x " + std::to_string(w.height);
    };
    if (sizeOf(a) != sizeOf(b)) {
        throw FileError(spectral, "is " + sizeOf(a) + " texels, " + reference + " " + sizeOf(b));
    }
    const std::vector<std::string> ours = a.channels();
    const std::vector<std::string> theirs = b.channels();
    std::vector<std::string> odd;
    std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                  std::back_inserter(odd));
    if (odd.empty()) return;
    const bool here = std::binary_search(ours.begin(), ours.end(), odd[0]);
    throw FileError(spectral, (here ? "has a channel " : "has no channel ") + odd[0] +
                                  (here ? ", which is not in " : ", which is in ") + reference);
}

/// Rows of both files, and what was found in them.
struct Rows {
    std::vector<float> a, b;
    SpectralDifference found;
    std::size_t worstTexel = 0;  ///< of these rows
    double squares = 0;
};

/// Differences of one texel, counted as texel `index` of its rows.
void compareTexel(std::span<const float> a, std::span<const float> b,
                  std::span<const double> wavelengths, std::size_t index, Rows& rows) {
    ++rows.found.texels;
    const auto finite = [](float v) { return std::isfinite(v); };
    if (!std::all_of(a.begin(), a.end(), finite) || !std::all_of(b.begin(), b.end(), finite)) {
        ++rows.found.notFinite;
        return;
    }
    for (std::size_t band = 0; band < wavelengths.size(); ++band) {
        const double off = std::abs(double(a[band]) - double(b[band]));
        rows.squares += off * off;
        if (off <= rows.found.largest) continue;
        rows.found.largest = off;
        rows.worstTexel = index;
        rows.found.worstBand = wavelengths[band];
    }
}

class SpectraComparison {
  public:
    SpectraComparison(const std::string& spectral, const std::string& reference)
        : a_(spectral), b_(reference) {
        checkAlike(spectral, a_, reference, b_);
    }

    SpectralDifference run(int threads) {
        const int count = (height() + rowsTogether_ - 1) / rowsTogether_;
        rows_.resize(std::size_t(count));
        runPipeline(count,
                    {[&](int i) { read(i); }, [&](int i) { compare(i); }, [&](int i) { gather(i); },
                     2 * std::size_t(rowsTogether_) * width() * bandCount() * sizeof(float)},
                    threads, {});
        const double samples = double(total_.texels - total_.notFinite) * double(bandCount());
        if (samples > 0) total_.rms = std::sqrt(squares_ / samples);
        return total_;
    }

  private:
    std::size_t bandCount() const { return a_.wavelengths().size(); }
    std::size_t width() const { return std::size_t(a_.header().data.width); }
    int height() const { return a_.header().data.height; }

    void read(int i) {
        Rows& rows = rows_[std::size_t(i)];
        const int count = std::min(rowsTogether_, height() - i * rowsTogether_);
        rows.a.resize(std::size_t(count) * width() * bandCount());
        rows.b.resize(rows.a.size());
        a_.readRows(i * rowsTogether_, count, rows.a);
        b_.readRows(i * rowsTogether_, count, rows.b);
    }

    void compare(int i) {
        Rows& rows = rows_[std::size_t(i)];
        for (std::size_t t = 0; t * bandCount() < rows.a.size(); ++t) {
            const auto bandsOf = [&](const std::vector<float>& samples) {
                return std::span(samples).subspan(t * bandCount(), bandCount());
            };
            compareTexel(bandsOf(rows.a), bandsOf(rows.b), a_.wavelengths(), t, rows);
        }
        rows.a = {};
        rows.b = {};
    }

    /// In order, so that sums do not depend on the threads.
    void gather(int i) {
        const Rows& rows = rows_[std::size_t(i)];
        total_.texels += rows.found.texels;
        total_.notFinite += rows.found.notFinite;
        squares_ += rows.squares;
        if (rows.found.largest > total_.largest) {
            total_.largest = rows.found.largest;
            total_.worstX = rows.worstTexel % width();
            total_.worstY = rows.worstTexel / width() + std::size_t(i) * std::size_t(rowsTogether_);
            total_.worstBand = rows.found.worstBand;
        }
        rows_[std::size_t(i)] = {};
    }

    SpectralReader a_, b_;
    int rowsTogether_ = rowsTogether(a_);
    std::vector<Rows> rows_;
    SpectralDifference total_;
    double squares_ = 0;
};

}  // namespace

SpectralDifference compareSpectra(const std::string& spectral, const std::string& reference,
                                  int threads) {
    return SpectraComparison(spectral, reference).run(threads);
}

}  // namespace specbake
