#include "measures.h"

#include "methods/published/mallett2019.h"
#include "statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace specbake;
using namespace specbake::bench;

namespace {

const std::string kData = std::string(SPECBAKE_SOURCE_DIR) + "/data/";

/// Gives every colour the same answer.
class Stubborn : public Method {
  public:
    explicit Stubborn(Reconstruction answer)
        : Method({"stubborn", ""}, sRGBFrame()), answer_(answer) {}
    Reconstruction reconstruct(const XYZ&) const override { return answer_; }

  private:
    Reconstruction answer_;
};

double named(const std::vector<Measure>& measures, const std::string& quantity) {
    for (const Measure& m : measures) {
        if (m.quantity == quantity) return m.value;
    }
    FAIL("no measure ", quantity);
    return 0;
}

}  // namespace

TEST_CASE("quantiles are by the nearest rank") {
    const std::vector<double> five{50, 20, 40, 15, 35};
    CHECK(quantile(five, 0.05) == 15);
    CHECK(quantile(five, 0.30) == 20);
    CHECK(quantile(five, 0.40) == 20);
    CHECK(quantile(five, 0.50) == 35);
    CHECK(quantile(five, 1.00) == 50);
    CHECK(median(five) == 35);
    CHECK(mean(five) == 32);
    CHECK(rootMeanSquare(std::vector<double>{3, 4}) == doctest::Approx(std::sqrt(12.5)));
    CHECK(std::isnan(quantile({}, 0.5)));
}

TEST_CASE("a method failed where it misses the colour, leaves [0, 1], says so or gives no number") {
    const Stubborn method({constantSpectrum(0.5), true});
    const XYZ half(method.frame().observer.white() * 0.5);
    CHECK_FALSE(judge(method, half, {constantSpectrum(0.5), true}).failed);
    CHECK(judge(method, half, {constantSpectrum(0.5), true}).residual < 1e-15);
    CHECK(judge(method, half, {constantSpectrum(0.6), true}).failed);
    CHECK(judge(method, half, {constantSpectrum(0.6), true}).residual ==
          doctest::Approx(0.1 * method.frame().observer.white().z));  // Z of D65 is the largest
    CHECK(judge(method, half, {constantSpectrum(0.5), false}).failed);
    CHECK(judge(method, half, {constantSpectrum(std::nan("")), true}).failed);
    Spectrum spike = constantSpectrum(0.5);
    spike[80] = 1.5;  // 780 nm: hardly seen, but no reflectance
    CHECK(judge(method, half, {spike, true}).deltaE < 0.01);
    CHECK(judge(method, half, {spike, true}).failed);
}

TEST_CASE("round trip: shares are of colours") {
    const Stubborn method({constantSpectrum(0.5), true});
    const XYZ white = method.frame().observer.white();
    const ColorSet set{.name = "four",
                       .colors = {XYZ(white * 0.5), XYZ(white * 0.5), XYZ(white * 0.5), white}};
    const auto measures = measureRoundTrip(method, set);
    CHECK(named(measures, "failed") == 0.25);
    CHECK(named(measures, "out of bounds") == 0);
    CHECK(named(measures, "residual max") == doctest::Approx(0.5 * white.z));
    CHECK(named(measures, "roughness") == 0);
}

TEST_CASE("bounds: colours and samples are counted apart") {
    Spectrum spikes = constantSpectrum(0.5);
    spikes[0] = -0.25;
    spikes[80] = 1.5;
    const Stubborn method({spikes, true});
    const XYZ color = method.frame().observer.color(spikes);
    const auto measures = measureRoundTrip(method, {.name = "two", .colors = {color, color}});
    CHECK(named(measures, "out of bounds") == 1);
    CHECK(named(measures, "samples out of bounds") == doctest::Approx(2.0 / 81).epsilon(1e-14));
    CHECK(named(measures, "out of bounds by") == 0.5);
}

TEST_CASE("continuity of a set is taken at the set's own distance") {
    struct Step : Method {
        Step() : Method({"step at Y = 1e-4", ""}, sRGBFrame()) {}
        Reconstruction reconstruct(const XYZ& color) const override {
            return {constantSpectrum(color.y > 1e-4 ? 1 : 0.5), true};
        }
    };
    ColorSet black{.name = "black", .colors = {XYZ(0, 0, 0)}, .neighbour = 1e-6};
    CHECK(named(measureContinuity(Step(), black), "continuity max") == 0);
    black.neighbour = 1e-2;  // black's neighbour within the cube is (d, d, d), whose Y is d
    CHECK(named(measureContinuity(Step(), black), "continuity max") ==
          doctest::Approx(0.5 / 1e-2).epsilon(1e-12));
}

TEST_CASE("throughput: one figure a method, positive, and the slower method is found slower") {
    struct Slow : Stubborn {
        Slow() : Stubborn({constantSpectrum(0.5), true}) {}
        Reconstruction reconstruct(const XYZ& color) const override {
            Reconstruction r = Stubborn::reconstruct(color);
            for (int i = 0; i < 100; ++i) r.spectrum[0] = std::cos(r.spectrum[0]);
            return r;
        }
    };
    const Stubborn quick({constantSpectrum(0.5), true});
    const Slow slow;
    const auto rates = throughput({&quick, &slow}, 3, std::chrono::duration<double>(0.01));
    REQUIRE(rates.size() == 2);
    CHECK(rates[1] > 0);
    CHECK(rates[0] > rates[1]);
}

TEST_CASE("continuity of three primaries that sum to 1 is at most 1; of a constant it is 0") {
    Mallett2019 method(sRGBFrame(), kData + "mallett2019.csv");
    method.setUp();
    const auto colors = rgbSets(method.frame(), 300).front().colors;
    const double distance = 1e-4;
    for (const double ratio : continuity(method, colors, distance)) {
        // |Σ ±b_i| <= Σ b_i = 1 within 1e-4 (their table); it is 1 where all three signs agree
        CHECK(ratio <= 1 + 1e-4);
        CHECK(ratio > 0.5);
    }
    const Stubborn constant({constantSpectrum(0.5), true});
    for (const double ratio : continuity(constant, colors, distance)) CHECK(ratio == 0);
}

TEST_CASE("nature: errors of a grey against known reflectances") {
    const Stubborn method({constantSpectrum(0.5), true});
    const std::vector<NamedSpectrum> measured{{"same", constantSpectrum(0.5)},
                                              {"lighter", constantSpectrum(0.7)}};
    const auto measures = measureNature(method, measured, {lightOf(Observer("A"))});
    CHECK(named(measures, "reflectance error mean RMS") == doctest::Approx(0.1));
    CHECK(named(measures, "reflectance error max RMS") == doctest::Approx(0.2));
    CHECK(named(measures, "under A max") == doctest::Approx(2 * named(measures, "under A mean")));
}

TEST_CASE("a light of a table: its white has Y = 1, equal energy is E") {
    const Light led = readLight("LED-B3", kData + "illuminant_led_b3.csv");
    CHECK(led.white.y == doctest::Approx(1).epsilon(1e-14));
    // CIE 15:2018 prints x = 0.3756, y = 0.3723 for LED-B3 from finer tables.
    CHECK(std::abs(chromaticity(led.white).x - 0.3756) < 1e-3);
    CHECK(std::abs(chromaticity(led.white).y - 0.3723) < 1e-3);
    const Light e = lightOf(Observer("E"));
    CHECK(e.color(constantSpectrum(1)) == Observer("E").white());
}
