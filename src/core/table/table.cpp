#include "table/extension.h"
#include "table/node_spectra.h"
#include "table/survey.h"

#include <specbake/core/error.h>
#include <specbake/core/table.h>
#include <specbake/sampler.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

namespace specbake {

using namespace internal;

namespace {

/// How a reflectance becomes a sample of 16 bits. In both ranges 0 and 1 are samples themselves.
struct Range {
    double step = 1.0 / 65535;
    int zero = 0;  ///< the sample of reflectance 0

    double low() const { return -zero * step; }
    double high() const { return (65535 - zero) * step; }
    std::uint16_t sample(double value) const {
        const double sample = std::nearbyint(value / step) + zero;
        return std::uint16_t(std::clamp(sample, 0.0, 65535.0));
    }
};

/// 0 to 1, or if a node is beyond, kLowestValue to kHighestValue.
Range rangeOf(const NodeSpectra& nodes) {
    for (const Spectrum& spectrum : nodes.spectrum) {
        if (boundsViolation(spectrum) > 0) {
            const int steps = int(65535 / (kHighestValue - kLowestValue));
            return {1.0 / steps, int(-kLowestValue * steps)};
        }
    }
    return {};
}

/// "mean p99 max" in a width that the figures do not change: the text's place is fixed before them.
std::string figures(const TableErrors& errors) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%10.6f %10.6f %10.6f", errors.mean, errors.p99,
                  errors.max);
    return text.data();
}

std::string textOf(const Upsampler& upsampler, const TableSurvey& survey) {
    const Quadrature quadrature = upsampler.observer().quadrature();
    const bool isFine = quadrature == Quadrature::fine;
    const ReaderErrors& ofBands = isFine ? survey.otherwise : survey.own;
    const ReaderErrors& ofFine = isFine ? survey.own : survey.otherwise;
    return "format=spectab\nspace=" + upsampler.space().name +
           "\nilluminant=" + upsampler.observer().illuminant() +
           "\nobserver=" + std::string(upsampler.observer().name()) +
           "\nmethod=" + upsampler.options().method +
           "\nquadrature=" + std::string(quadratureText(quadrature)) +
           "\nde2000_bands=" + figures(ofBands.everywhere) +
           "\nde2000_bands_boundary=" + figures(ofBands.atBoundary) +
           "\nde2000_fine=" + figures(ofFine.everywhere) +
           "\nde2000_fine_boundary=" + figures(ofFine.atBoundary) +
           "\nidentity=" + upsampler.identity() + "\n";
}

class TableBytes {
  public:
    TableBytes(const Upsampler& upsampler, int nodesPerAxis, std::string text)
        : text_(std::move(text)) {
        std::copy_n(SpectralTableHeader::kMagic, sizeof header_.magic, header_.magic);
        header_.version = SpectralTableHeader::kVersion;
        header_.headerBytes = sizeof header_;
        header_.axisLaw = 1;
        header_.nodes = std::uint32_t(nodesPerAxis);
        const Wavelengths knots = upsampler.observer().knots();
        header_.bands = std::uint32_t(knots.count);
        header_.stride = header_.bands + 1;
        header_.firstWavelength = float(knots.first);
        header_.wavelengthStep = float(knots.step);
        header_.textOffset = sizeof header_;
        header_.textBytes = text_.size();
        header_.nodesOffset = (sizeof header_ + text_.size() + 63) / 64 * 64;
        const Imath::M33d matrix =
            xyzFromRGB(upsampler.space(), upsampler.observer(), upsampler.options().adapt);
        for (int i = 0; i < 9; ++i) header_.xyzFromRGB[i] = matrix[i / 3][i % 3];
        for (int i = 0; i < 3; ++i) header_.white[i] = upsampler.observer().white()[i];
    }

    void setNodes(const NodeSpectra& nodes) {
        const Range range = rangeOf(nodes);
        header_.low = float(range.low());
        header_.high = float(range.high());
        samples_.clear();
        samples_.reserve(nodes.spectrum.size() * header_.stride);
        for (const Spectrum& spectrum : nodes.spectrum) {
            for (std::size_t m = 0; m < header_.bands; ++m) {
                samples_.push_back(range.sample(spectrum[m]));
            }
            samples_.push_back(samples_.back());
        }
        header_.fileBytes = header_.nodesOffset + samples_.size() * sizeof(std::uint16_t);
    }

    /// `text`: as long as before, with the figures.
    void setErrors(const TableErrors& everywhere, const TableErrors& atBoundary, std::string text) {
        text_ = std::move(text);
        header_.meanError = float(everywhere.mean);
        header_.p99Error = float(everywhere.p99);
        header_.maxError = float(std::max(everywhere.max, atBoundary.max));
        header_.reachable = float(everywhere.share);
    }

    /// With the checksum filled in.
    std::vector<std::byte> bytes() {
        std::vector<std::byte> all(header_.fileBytes);
        std::memcpy(all.data() + header_.textOffset, text_.data(), text_.size());
        std::memcpy(all.data() + header_.nodesOffset, samples_.data(),
                    samples_.size() * sizeof(std::uint16_t));
        std::memcpy(all.data(), &header_, sizeof header_);
        constexpr std::size_t from = SpectralTableHeader::kChecked;
        const auto* first = reinterpret_cast<const unsigned char*>(all.data());
        header_.crc32 = SpectralTable::crc32(first + from, all.size() - from);
        std::memcpy(all.data(), &header_, sizeof header_);
        return all;
    }

  private:
    SpectralTableHeader header_{};
    std::string text_;
    std::vector<std::uint16_t> samples_;
};

}  // namespace

SpectralTableFile spectralTable(const Upsampler& upsampler) {
    if (!upsampler.options().grid) throw ArgumentError("a table needs a grid");
    if (upsampler.space().isXYZ()) {
        throw ArgumentError("a table is over the cube of an RGB space, and XYZ has none");
    }
    const Grid grid(*upsampler.options().grid);
    NodeSpectra nodes = nodeSpectra(grid, upsampler);
    extendBeyondSolid(grid, upsampler, nodes);
    TableBytes table(upsampler, grid.axis().nodes(), textOf(upsampler, {}));
    table.setNodes(nodes);
    SpectralTableFile file;
    file.bytes = table.bytes();
    SpectralTable view;
    if (view.view(file.bytes.data(), file.bytes.size()) != SpectralTable::Status::ok) {
        throw ArgumentError("a table that its own reader refuses");
    }
    const TableSurvey survey = surveyed(view, grid, nodes, upsampler);
    file.everywhere = survey.own.everywhere;
    file.atBoundary = survey.own.atBoundary;
    file.everywhereOtherwise = survey.otherwise.everywhere;
    file.atBoundaryOtherwise = survey.otherwise.atBoundary;
    file.quadrature = upsampler.observer().quadrature();
    table.setErrors(file.everywhere, file.atBoundary, textOf(upsampler, survey));
    file.bytes = table.bytes();
    return file;
}

}  // namespace specbake
