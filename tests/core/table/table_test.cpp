#include "table/cube_colors.h"
#include "table/extension.h"
#include "table/node_spectra.h"

#include <specbake/core/error.h>
#include <specbake/core/table.h>
#include <specbake/sampler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <string>

using namespace specbake;
using namespace specbake::internal;

namespace {

Upsampler modelOf(const char* space, int nodes) {
    UpsamplerOptions options;
    options.grid = nodes;
    return Upsampler(*findColorSpace(space), options);
}

/// Blends for colours of the solid whose cell its boundary cuts, which the minimiser has not seen.
struct Blends {
    Blends(const Grid& grid, const Upsampler& upsampler, const NodeSpectra& nodes) {
        CubeColors draws(11);
        for (int i = 0; i < 20'000; ++i) {
            const Upsampler::Color color = draws.next();
            const GridSimplex simplex = grid.locate(color);
            const XYZ asked = upsampler.xyz(color);
            if (!nodes.isCut(simplex) || !upsampler.solid().contains(asked)) continue;
            const Spectrum blend = blended(simplex, nodes);
            const Imath::V3d off = upsampler.observer().color(blend) - asked;
            colorError = std::max(colorError, off.length());
            for (const double value : blend) {
                const double over = value - std::clamp(value, 0.0, 1.0);
                excess += over * over;
            }
        }
    }

    static Spectrum blended(const GridSimplex& simplex, const NodeSpectra& nodes) {
        Spectrum blend{};
        for (std::size_t k = 0; k < 4; ++k) {
            const Spectrum& node = nodes.spectrum[simplex.node[k]];
            for (std::size_t m = 0; m < blend.size(); ++m) {
                blend[m] += double(simplex.weight[k]) * node[m];
            }
        }
        return blend;
    }

    double excess = 0;      ///< the sum of the squares of what leaves [0, 1]
    double colorError = 0;  ///< the largest, in XYZ, before anything is clamped
};

}  // namespace

TEST_CASE("nodes beyond the solid keep their colour and their range, and blends stay in [0, 1]") {
    for (const char* space : {"acescg", "lin_rec2020"}) {
        CAPTURE(space);
        const Upsampler upsampler = modelOf(space, 7);
        const Grid grid(7);
        NodeSpectra nodes = nodeSpectra(grid, upsampler);
        REQUIRE_FALSE(nodes.areAttainable());
        NodeSpectra corrected = nodes;
        const ColorCorrection correction(upsampler.observer());
        for (std::uint32_t node = 0; node < grid.nodeCount(); ++node) {
            if (nodes.attainable[node] == 1) continue;
            correction.apply(corrected.spectrum[node], upsampler.xyz(grid.position(node)));
        }
        extendBeyondSolid(grid, upsampler, nodes);
        const Blends blends(grid, upsampler, nodes);
        CHECK(blends.excess < Blends(grid, upsampler, corrected).excess / 8);
        CHECK(blends.colorError < 1e-6);  // nodes of the solid were floats; so are the weights
        for (const Spectrum& spectrum : nodes.spectrum) {
            CHECK(boundsViolation(spectrum) <= 0.26);  // the last word is the colour's
        }
    }
}

TEST_CASE("a wide space's table is as good at the boundary as it says") {
    const Upsampler upsampler = modelOf("lin_rec2020", 9);
    const SpectralTableFile file = spectralTable(upsampler);
    SpectralTable table;
    REQUIRE(table.view(file.bytes.data(), file.bytes.size()) == SpectralTable::Status::ok);
    CHECK(table.intact());
    CHECK(file.atBoundary.colors == 20'000);
    CHECK(file.atBoundary.max < 2);  // 4.7 before the nodes beyond the solid were chosen
    CHECK(table.header().maxError == float(std::max(file.atBoundary.max, file.everywhere.max)));
    CHECK(table.header().reachable == doctest::Approx(0.857).epsilon(0.01));
    const std::string text(table.text(), table.header().textBytes);
    CHECK(text.find("space=lin_rec2020\n") != std::string::npos);
    CHECK(text.find("identity=" + upsampler.identity() + "\n") != std::string::npos);
    CHECK(spectralTable(upsampler).bytes == file.bytes);
}

TEST_CASE("what has no grid, or no cube of its own, has no table") {
    UpsamplerOptions direct;
    direct.grid = std::nullopt;
    CHECK_THROWS_AS(spectralTable(Upsampler(*findColorSpace("srgb"), direct)), ArgumentError);
    CHECK_THROWS_AS(spectralTable(Upsampler(*findColorSpace("xyz"))), ArgumentError);
}
