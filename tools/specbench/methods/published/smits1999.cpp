#include "methods/published/smits1999.h"

#include "methods/clones.h"
#include "methods/csv.h"

#include <specbake/core/error.h>

#include <algorithm>

namespace specbake::bench {
namespace {

constexpr std::size_t kBins = 10;
constexpr double kFirstEdge = 380, kBinWidth = 34;  // nm

/// The bins' mean over the band of 5 nm about its wavelength; the first and the last bin go on.
double bandMean(const std::array<double, kBins>& bins, int band) {
    const double low = wavelength(band) - 0.5 * kWavelengthStep;
    const double high = low + kWavelengthStep;
    double sum = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double left = i == 0 ? low : kFirstEdge + kBinWidth * double(i);
        const double right = i + 1 == kBins ? high : kFirstEdge + kBinWidth * double(i + 1);
        sum += bins[i] * std::max(0.0, std::min(high, right) - std::max(low, left));
    }
    return sum / kWavelengthStep;
}

/// A colour as amounts of white, one secondary and one primary.
template <class Number>
struct Amounts {
    Number white, secondary, primary;
    Smits1999::Name secondaryName, primaryName;
};

template <class Number>
Amounts<Number> amounts(const Imath::Vec3<Number>& c) {
    using S = Smits1999;
    if (c.x <= c.y && c.x <= c.z) {
        return c.y <= c.z ? Amounts<Number>{c.x, c.y - c.x, c.z - c.y, S::cyan, S::blue}
                          : Amounts<Number>{c.x, c.z - c.x, c.y - c.z, S::cyan, S::green};
    }
    if (c.y <= c.x && c.y <= c.z) {
        return c.x <= c.z ? Amounts<Number>{c.y, c.x - c.y, c.z - c.x, S::magenta, S::blue}
                          : Amounts<Number>{c.y, c.z - c.y, c.x - c.z, S::magenta, S::red};
    }
    return c.x <= c.y ? Amounts<Number>{c.z, c.x - c.z, c.y - c.x, S::yellow, S::green}
                      : Amounts<Number>{c.z, c.y - c.z, c.x - c.y, S::yellow, S::red};
}

using FloatBasis = std::array<std::array<float, kBandCount>, 7>;

SPECBENCH_CLONES
void blend(const FloatBasis& basis, const Imath::V3f* rgb, std::size_t count, float* out) {
    const float* white = basis[Smits1999::white].data();
    for (std::size_t i = 0; i < count; ++i, out += kBandCount) {
        const Amounts<float> a = amounts(rgb[i]);
        const float* second = basis[a.secondaryName].data();
        const float* first = basis[a.primaryName].data();
        for (int m = 0; m < kBandCount; ++m) {
            out[m] = a.white * white[m] + a.secondary * second[m] + a.primary * first[m];
        }
    }
}

}  // namespace

Smits1999::Smits1999(const Frame& frame, std::string table)
    : Method({"Smits 1999", frame.observer.illuminant() == "E" ? "his white" : ""}, frame),
      table_(std::move(table)) {}

void Smits1999::setUp() {
    const auto rows = readCsv(table_);
    if (rows.size() != basis_.size()) throw FileError(table_, "seven rows expected");
    for (std::size_t k = 0; k < rows.size(); ++k) {
        std::array<double, kBins> bins;
        for (std::size_t i = 0; i < kBins; ++i) bins[i] = numberIn(rows[k], i + 1, table_);
        for (int m = 0; m < kBandCount; ++m) {
            basis_[k][std::size_t(m)] = bandMean(bins, m);
            floatBasis_[k][std::size_t(m)] = static_cast<float>(basis_[k][std::size_t(m)]);
        }
    }
}

Reconstruction Smits1999::reconstruct(const XYZ& color) const {
    const Amounts<double> a = amounts<double>(frame().rgb(color));
    Reconstruction r;
    for (std::size_t m = 0; m < r.spectrum.size(); ++m) {
        r.spectrum[m] = a.white * basis_[white][m] + a.secondary * basis_[a.secondaryName][m] +
                        a.primary * basis_[a.primaryName][m];
    }
    return r;
}

void Smits1999::reconstructTexels(std::span<const Imath::V3f> rgb, std::span<float> spectra) const {
    blend(floatBasis_, rgb.data(), rgb.size(), spectra.data());
}

}  // namespace specbake::bench
