#include "support/csv.h"
#include "support/solid_samples.h"

#include <specbake/core/error.h>
#include <specbake/core/upsampler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::testing;

namespace {

const std::vector<Wavelengths> kBands = {
    {}, {400, 10, 31}, {380, 20, 21}, {360, 5, 95}, {380, 1, 401}, {450, 7.5, 21}, {420, 55, 5}};

/// The integral every 1 nm as a renderer makes it, from the CSV files alone.
class FineIntegral {
  public:
    explicit FineIntegral(const std::string& light) {
        const auto rows = readCsv("data/cie1931_2deg_1nm.csv");
        REQUIRE(rows.size() == 471);
        const std::map<int, double> table = powerOf(light);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const int nm = 360 + int(i);
            const double power = light == "A" ? planck(nm) : between(table, nm);
            lit_.emplace_back(std::stod(rows[i][1]), std::stod(rows[i][2]), std::stod(rows[i][3]));
            lit_.back() *= power;
            luminance_ += lit_.back().y;
        }
    }

    /// Of values at these bands, linear between, the ends repeated.
    template <class Values>
    XYZ color(const Values& values, const Wavelengths& bands) const {
        Imath::V3d sum(0.0);
        for (int nm = 360; nm <= 830; ++nm) {
            int above = 0;
            while (above < bands.count && bands.at(above) <= nm) ++above;
            const auto value = [&](int band) { return double(values[std::size_t(band)]); };
            double s = above == 0 ? value(0) : value(above - 1);
            if (above > 0 && above < bands.count) {
                s += (value(above) - value(above - 1)) * (nm - bands.at(above - 1)) / bands.step;
            }
            sum += s * lit_[std::size_t(nm - 360)];
        }
        return XYZ(sum / luminance_);
    }

  private:
    static std::map<int, double> powerOf(const std::string& light) {
        std::map<int, double> power;
        const auto column = [&](const std::string& file, const std::vector<std::string>& names) {
            const auto at = std::find(names.begin(), names.end(), light);
            if (at == names.end()) return;
            for (const auto& row : readCsv(file)) {
                const auto cell = std::size_t(at - names.begin()) + 1;
                if (!row[cell].empty()) power[std::stoi(row[0])] = std::stod(row[cell]);
            }
        };
        column("data/illuminants_5nm.csv",
               {"E", "A", "C", "D50", "D55", "D60", "D65", "D75", "F2", "F11"});
        column("data/illuminants_ends.csv", {"C", "D50", "D55", "D60", "D65", "D75"});
        return power;
    }
    static double between(const std::map<int, double>& table, int nm) {
        const auto above = table.lower_bound(nm);
        if (above == table.end()) return std::prev(above)->second;
        if (above->first == nm || above == table.begin()) return above->second;
        const auto below = std::prev(above);
        return below->second + (above->second - below->second) * (nm - below->first) /
                                   double(above->first - below->first);
    }
    static double planck(double nm) {
        const auto radiance = [](double at) {
            return std::pow(at, -5) / (std::exp(1.435e7 / (2848 * at)) - 1);
        };
        return 100 * radiance(nm) / radiance(560);
    }

    std::vector<Imath::V3d> lit_;
    double luminance_ = 0;
};

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Each of at most 81 weights is rounded to a multiple of kWeightUnit, and spectra are at most 1;
/// sums of 471 terms below 1.3 add less than 471 * 2 roundings.
constexpr double kWeightBound = 81 * Observer::kWeightUnit / 2 + 471 * 2 * 0x1p-53;

/// Dark, in the cube, on its faces, on the boundary and outside.
std::vector<XYZ> colorsOf(const Upsampler& model, int count) {
    Random random(7);
    std::vector<XYZ> colors = {XYZ(0, 0, 0), model.observer().white()};
    for (int i = 0; i < count; ++i) {
        const double top = i % 3 == 0 ? 0.01 : 1;
        RGB rgb{random(0, top), random(0, top), random(0, top)};
        if (i % 5 == 0) rgb[i % 3] = double(i % 2) * top;
        colors.push_back(model.xyz(rgb));
        const Imath::V3d d = random.direction();
        const Imath::V3d center = model.solid().center();
        colors.emplace_back(center + d / model.solid().gauge(XYZ(center + d)));
    }
    return colors;
}

UpsamplerOptions fine(const Wavelengths& bands, const std::string& method = "smooth") {
    UpsamplerOptions options;
    options.quadrature = Quadrature::fine;
    options.bands = bands;
    options.method = method;
    return options;
}

std::vector<double> atBands(const Spectrum& spectrum, const Observer& observer) {
    std::vector<double> values;
    for (const double nm : listed(observer.bands())) {
        values.push_back(valueAt(spectrum, observer.knots(), nm));
    }
    return values;
}

}  // namespace

TEST_CASE("the colour of a spectrum is a renderer's integral, under every light, for any bands") {
    Random random(3);
    for (const std::string& light : illuminantNames()) {
        const FineIntegral integral(light);
        for (const Wavelengths& bands : kBands) {
            const Observer observer(light, Quadrature::fine, bands);
            CAPTURE(light);
            CAPTURE(bands.count);
            CHECK(largest(observer.white() - integral.color(std::vector<double>(471, 1), bands)) <
                  kWeightBound);
            for (int i = 0; i < 20; ++i) {
                Spectrum spectrum;
                for (double& value : spectrum) value = random(0, 1);
                const XYZ expected = integral.color(atBands(spectrum, observer), bands);
                CHECK(largest(observer.color(spectrum) - expected) < kWeightBound);
            }
        }
    }
}

TEST_CASE("the fine white of D65 is the published one") {
    // ASTM E308, whose figures are integrals every 1 nm: 95.047 100 108.883.
    const XYZ white = Observer("D65", Quadrature::fine, {}).white();
    CHECK(std::abs(white.x - 0.95047) < 0.5e-5);
    CHECK(std::abs(white.y - 1) < 1e-10);
    CHECK(std::abs(white.z - 1.08883) < 0.5e-5);
}

TEST_CASE("solved spectra have their colour for the fine reader, and stay within [0, 1]") {
    for (const char* space : {"lin_rec709", "acescg"}) {
        for (const Wavelengths& bands : kBands) {
            const Upsampler model(*findColorSpace(space), fine(bands));
            const FineIntegral integral(model.observer().illuminant());
            CAPTURE(space);
            CAPTURE(bands.count);
            for (const XYZ& asked : colorsOf(model, 300)) {
                const ColorAnswer answer = model.solve(asked);
                REQUIRE(answer.solution.solved());
                CHECK(withinBounds(answer.solution.spectrum));
                const auto values = atBands(answer.solution.spectrum, model.observer());
                // The solvers reach 1e-11 (newton_limits.h, solid_samples.h).
                const XYZ& wanted = answer.outside ? answer.given : asked;
                CHECK(largest(integral.color(values, bands) - wanted) < kWeightBound + 1e-10);
            }
        }
    }
}

TEST_CASE("every method, and samples through the grid, too") {
    for (const char* method : {"smooth", "natural", "descent"}) {
        for (const Wavelengths& bands : {Wavelengths(), Wavelengths{400, 10, 31}}) {
            CAPTURE(method);
            CAPTURE(bands.count);
            UpsamplerOptions options = fine(bands, method);
            options.grid = 5;
            const Upsampler model(*findColorSpace("lin_rec709"), options);
            const FineIntegral integral("D65");
            Random random(11);
            std::vector<Upsampler::Color> colors = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 1}};
            for (int i = 0; i < 500; ++i) {
                colors.push_back({float(random(0, 1)), float(random(0, 1)), float(random(0, 1))});
            }
            const auto samples = model.sample(colors, SampleSelection::bands(bands));
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const float* spectrum = samples.data() + i * std::size_t(bands.count);
                // A dozen roundings of floats at most 2, the weights' sum in Z being 1.09.
                CHECK(largest(integral.color(spectrum, bands) - model.xyz(colors[i])) <
                      1.09 * 32 * 0x1p-24);
            }
        }
    }
}

TEST_CASE("more bands than the solver's are linear between knots") {
    const Wavelengths nm{380, 1, 401};
    const Upsampler whole(*findColorSpace("lin_rec709"), fine({}));
    const Upsampler everyNm(*findColorSpace("lin_rec709"), fine(nm));
    CHECK(nm.knots() == Wavelengths());
    const std::vector<Upsampler::Color> color = {{0.7F, 0.2F, 0.1F}};
    const auto coarse = whole.sample(color, SampleSelection::bands());
    const auto dense = everyNm.sample(color, SampleSelection::bands(nm));
    for (std::size_t m = 0; m < coarse.size(); ++m) {
        // Both solve the same problem, with weights that are rounded alike but for their order.
        CHECK(std::abs(dense[5 * m] - coarse[m]) < 1e-6F);
    }
    CHECK(std::abs(dense[7] - (0.6F * dense[5] + 0.4F * dense[10])) < 1e-6F);
}

TEST_CASE("wavelengths are parsed, and refused with a reason") {
    CHECK(parseWavelengths("400:700:10") == Wavelengths{400, 10, 31});
    CHECK(parseWavelengths("380:780:2.5") == Wavelengths{380, 2.5, 161});
    CHECK(wavelengthsText(parseWavelengths("400:700:12.5")) == "400:700:12.5");
    for (const char* text : {"", "400:700", "400:700:0", "400:700:-10", "700:400:10", "400:700:7",
                             "300:700:10", "400:900:10", "400:700:0.5", "a:b:c", "400:700:10:1",
                             "nan:700:10", "400:inf:10", "400:700:1e-30", "400:500:50"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parseWavelengths(text), ArgumentError);
    }
    UpsamplerOptions options;
    options.bands = {400, 10, 31};
    CHECK_FALSE(options.isValid());
    options.quadrature = Quadrature::fine;
    CHECK(options.isValid());
    CHECK_THROWS_AS(Observer("D65", Quadrature::bands, options.bands), ArgumentError);
}
