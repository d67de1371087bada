#include "methods/csv.h"
#include "methods/max_entropy.h"
#include "methods/nearest_grey.h"
#include "methods/published/glassner1989.h"
#include "methods/published/mallett2019.h"
#include "methods/published/smits1999.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace specbake;
using namespace specbake::bench;

namespace {

const std::string kData = std::string(SPECBAKE_SOURCE_DIR) + "/data/";

/// Seeded colours of the frame's RGB cube.
std::vector<XYZ> cubeColors(const Frame& frame, int count) {
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<XYZ> colors;
    for (int i = 0; i < count; ++i) {
        const double r = uniform(random), g = uniform(random), b = uniform(random);
        colors.push_back(frame.xyz(RGB(r, g, b)));
    }
    return colors;
}

double miss(const Method& method, const XYZ& color, const Spectrum& s) {
    const Imath::V3d d = method.frame().observer.color(s) - color;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

double worstMiss(const Method& method, int count) {
    double worst = 0;
    for (const XYZ& c : cubeColors(method.frame(), count)) {
        worst = std::max(worst, miss(method, c, method.reconstruct(c).spectrum));
    }
    return worst;
}

/// The texel path's float against the double path: 24-bit inputs, table and sums of a few terms of
/// at most `scale`.
void checkTexelPath(const Method& method, double scale) {
    std::vector<Imath::V3f> texels;
    for (const XYZ& c : cubeColors(method.frame(), 100)) {
        const RGB rgb = method.frame().rgb(c);
        texels.emplace_back(float(rgb.x), float(rgb.y), float(rgb.z));
    }
    std::vector<float> spectra(texels.size() * kBandCount);
    method.reconstructTexels(texels, spectra);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const Spectrum s =
            method.reconstruct(method.frame().xyz(RGB(texels[i].x, texels[i].y, texels[i].z)))
                .spectrum;
        for (std::size_t m = 0; m < s.size(); ++m) {
            CHECK(std::abs(double(spectra[i * kBandCount + m]) - s[m]) < 8 * 0x1p-24 * scale);
        }
    }
}

}  // namespace

TEST_CASE("Glassner: the round trip is exact for any three functions") {
    for (const auto functions :
         {Glassner1989::Functions::fourier, Glassner1989::Functions::boxes}) {
        Glassner1989 method(sRGBFrame(), functions);
        method.setUp();
        CAPTURE(method.name().full());
        for (const XYZ& c : cubeColors(method.frame(), 5000)) {
            // 81 terms and two 3x3 products whose condition is below 100
            CHECK(miss(method, c, method.reconstruct(c).spectrum) < 81 * 100 * 0x1p-52);
        }
        checkTexelPath(method, 4);
    }
}

TEST_CASE("Glassner: Fourier terms leave [0, 1] inside sRGB, boxes only in a wider cube") {
    using F = Glassner1989::Functions;
    const auto outside = [](const std::string& space, F functions) {
        Glassner1989 method(frameOf(*findColorSpace(space)), functions);
        method.setUp();
        const auto colors = cubeColors(method.frame(), 5000);
        const auto leaves = [&](const XYZ& c) {
            return boundsViolation(method.reconstruct(c).spectrum) > 0;
        };
        return std::ranges::count_if(colors, leaves);
    };
    const auto fourier = outside("lin_rec709", F::fourier);
    CHECK(fourier > 5000 / 3);  // about half
    CHECK(fourier < 5000 * 2 / 3);
    CHECK(outside("lin_rec709", F::boxes) == 0);
    CHECK(outside("lin_rec2020", F::boxes) > 500);
}

TEST_CASE("Glassner: functions whose colours lie in a plane are refused") {
    const Basis flat{constantSpectrum(1), constantSpectrum(0.5), constantSpectrum(0.2)};
    CHECK_THROWS_AS(basisSpannedBy(flat, sRGBFrame()), ArgumentError);
}

TEST_CASE("Smits: the seven basis spectra are what the seven colours get") {
    Smits1999 method(sRGBFrame(), kData + "smits1999.csv");
    method.setUp();
    const std::pair<Smits1999::Name, RGB> corners[] = {
        {Smits1999::white, RGB(1, 1, 1)},   {Smits1999::cyan, RGB(0, 1, 1)},
        {Smits1999::magenta, RGB(1, 0, 1)}, {Smits1999::yellow, RGB(1, 1, 0)},
        {Smits1999::red, RGB(1, 0, 0)},     {Smits1999::green, RGB(0, 1, 0)},
        {Smits1999::blue, RGB(0, 0, 1)}};
    for (const auto& [name, rgb] : corners) {
        const Spectrum s = method.reconstruct(method.frame().xyz(rgb)).spectrum;
        // rgb -> XYZ -> rgb costs a few roundings; the amounts multiply values of at most 1.02
        CHECK(maxDifference(s, method.basis(name)) < 1e-14);
    }
    // Bin edges lie at 380 + 34 k: 382.5..387.5 is in the first, 412.5..417.5 straddles 414.
    CHECK(method.basis(Smits1999::red)[1] == doctest::Approx(0.1012).epsilon(1e-14));
    CHECK(method.basis(Smits1999::red)[7] ==
          doctest::Approx((1.5 * 0.1012 + 3.5 * 0.0515) / 5).epsilon(1e-14));
    CHECK(method.basis(Smits1999::red)[80] == doctest::Approx(1.0149).epsilon(1e-14));
    checkTexelPath(method, 3);
}

TEST_CASE("Smits: nearer to the colour under his own white than under D65") {
    Smits1999 his(smitsFrame(), kData + "smits1999.csv");
    Smits1999 ours(sRGBFrame(), kData + "smits1999.csv");
    his.setUp();
    ours.setUp();
    CHECK(his.name().full() == "Smits 1999, his white");
    CHECK(ours.name().full() == "Smits 1999");
    const double own = worstMiss(his, 2000), used = worstMiss(ours, 2000);
    // His spectra are printed to four decimals and his phosphors to two.
    CHECK(own < 5e-3);
    CHECK(own < used);
}

TEST_CASE("Mallett & Yuksel: the primaries sum to the white, are bounded and have their colours") {
    Mallett2019 method(sRGBFrame(), kData + "mallett2019.csv");
    method.setUp();
    for (std::size_t m = 0; m < kBandCount; ++m) {
        // The printed sums miss 1 by up to 1e-12 where the bands count; their optimiser's
        // tolerance.
        CHECK(std::abs(method.basis()[0][m] + method.basis()[1][m] + method.basis()[2][m] - 1) <
              1e-4);
    }
    for (int i = 0; i < 3; ++i) {
        const Spectrum& primary = method.basis()[std::size_t(i)];
        CHECK(boundsViolation(primary) < 1e-9);
        // Their optimiser's tolerance again: this frame (D65 on this table, its own white) is the
        // one that the spectra were made in.
        CHECK(miss(method, method.frame().xyz(RGB(i == 0, i == 1, i == 2)), primary) < 2e-8);
    }
    CHECK(worstMiss(method, 2000) < 3 * 2e-8);  // a mixture of three
    checkTexelPath(method, 1);
}

TEST_CASE("max entropy: exact and strictly bounded, and stationary") {
    MaxEntropy method(sRGBFrame());
    method.setUp();
    for (const XYZ& c : cubeColors(method.frame(), 2000)) {
        const Reconstruction r = method.reconstruct(c);
        CHECK(r.converged);
        CHECK(miss(method, c, r.spectrum) < 1e-12);
        CHECK(boundsViolation(r.spectrum) == 0);
    }
    // By symmetry of the entropy about ½: the spectrum of white − t is 1 − the spectrum of t.
    const XYZ c = method.frame().xyz(RGB(0.8, 0.3, 0.1));
    const Spectrum s = method.reconstruct(c).spectrum;
    const Spectrum t = method.reconstruct(XYZ(method.frame().observer.white() - c)).spectrum;
    for (std::size_t m = 0; m < s.size(); ++m) CHECK(std::abs(s[m] + t[m] - 1) < 1e-9);
    // ½ of white is the constant ½, where the entropy has its maximum.
    const Spectrum half = method.reconstruct(XYZ(method.frame().observer.white() * 0.5)).spectrum;
    CHECK(maxDifference(half, constantSpectrum(0.5)) < 1e-12);
}

TEST_CASE("max entropy: a colour outside the solid is not called converged") {
    MaxEntropy method(sRGBFrame());
    method.setUp();
    CHECK_FALSE(method.reconstruct(method.frame().xyz(RGB(1.5, 0, 0))).converged);
}

TEST_CASE("nearest to grey: exact before clipping, and no exact spectrum is nearer to a grey") {
    NearestGrey method(sRGBFrame(), NearestGrey::Bounds::none);
    Glassner1989 other(sRGBFrame(), Glassner1989::Functions::fourier);
    method.setUp();
    other.setUp();
    const auto spread = [](const Spectrum& s) {  // min over g of Σ (s_m − g)²
        double mean = 0, sum = 0;
        for (const double v : s) mean += v / kBandCount;
        for (const double v : s) sum += (v - mean) * (v - mean);
        return sum;
    };
    for (const XYZ& c : cubeColors(method.frame(), 500)) {
        const Spectrum s = method.reconstruct(c).spectrum;
        CHECK(miss(method, c, s) < 81 * 100 * 0x1p-52);  // as above
        const Spectrum rival = other.reconstruct(c).spectrum;
        for (const double weight : {-1.0, 1e-3, 0.1, 1.0}) {  // any affine mixture is exact too
            CHECK(spread(s) <= spread(mix(s, rival, weight)) * (1 + 1e-12));
        }
    }
    checkTexelPath(method, 4);
}

TEST_CASE("nearest to grey: clipping bounds it and costs the colour") {
    NearestGrey method(sRGBFrame(), NearestGrey::Bounds::clipped);
    method.setUp();
    double worst = 0;
    for (const XYZ& c : cubeColors(method.frame(), 1000)) {
        const Spectrum s = method.reconstruct(c).spectrum;
        CHECK(boundsViolation(s) == 0);
        worst = std::max(worst, miss(method, c, s));
    }
    CHECK(worst > 1e-3);
    checkTexelPath(method, 4);
}

TEST_CASE("tables that are absent or malformed are refused by name") {
    Mallett2019 absent(sRGBFrame(), kData + "no_such_table.csv");
    CHECK_THROWS_AS(absent.setUp(), FileError);
    Smits1999 wrong(sRGBFrame(), kData + "mallett2019.csv");
    CHECK_THROWS_AS(wrong.setUp(), FileError);
    CHECK_THROWS_AS(readReflectances(kData + "mallett2019.csv"), FileError);
    CHECK(readReflectances(kData + "colorchecker_24.csv").size() == 24);
}
