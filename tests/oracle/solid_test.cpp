#include "support/brute_solid.h"
#include "support/csv.h"

#include <specbake/core/solid.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using specbake::testing::BruteSolid;
using specbake::testing::readCsv;

namespace {

constexpr double kUnit = 0x1p-53;  // half of the spacing of doubles at 1

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    /// In the box of the solid, widened on each side by `margin` of its size.
    XYZ inBox(const Solid& solid, double margin) {
        const XYZ w = solid.white();
        const auto part = [&] { return (*this)(-margin, 1 + margin); };
        return {w.x * part(), w.y * part(), w.z * part()};
    }
    Imath::V3d direction() {
        std::normal_distribution<double> normal;
        return Imath::V3d(normal(engine_), normal(engine_), normal(engine_)).normalized();
    }
    /// On the boundary: by direction from the centre, or, every other time, in a base: a sliver
    /// that no random direction meets.
    XYZ onBoundary(const Observer& observer, const Solid& solid) {
        if ((*this)(0, 2) < 1) return inBase(observer);
        const Imath::V3d d = direction();
        return XYZ(solid.center() + d / solid.gauge(XYZ(solid.center() + d)));
    }
    XYZ inBase(const Observer& observer) {
        const double blue = std::round((*this)(0, 1));
        const double steepness = (*this)(0, 1) < 0.5 ? 1 : 10;  // 10: most values 0 or 1
        Spectrum s;
        for (std::size_t m = 0; m < s.size(); ++m) {
            const double red = std::clamp(0.5 + steepness * (*this)(-0.5, 0.5), 0.0, 1.0);
            s[m] = observer.weights()[m].z == 0 ? red : blue;
        }
        return observer.color(s);
    }

  private:
    std::mt19937_64 engine_;
};

/// The rounding of an 81-term sum W s.
double sumRounding(const Solid& solid) {
    return 81 * kUnit * (solid.white().x + solid.white().y + solid.white().z);
}

bool withinBounds(const Spectrum& s) {
    return std::all_of(s.begin(), s.end(), [](double v) { return v >= 0 && v <= 1; });
}

/// How much colour the difference of two spectra moves, band by band: a difference where the eye is
/// all but blind (1e-7 of the luminance at 780 nm) counts for as little.
double weightedDifference(const Observer& observer, const Spectrum& a, const Spectrum& b) {
    double largest = 0;
    for (std::size_t m = 0; m < a.size(); ++m) {
        largest = std::max(largest, std::abs(a[m] - b[m]) * observer.weights()[m].length());
    }
    return largest;
}

}  // namespace

TEST_CASE("all faces are parallelograms: no third generator in the plane of a pair") {
    const BruteSolid brute(Observer("E"));
    CHECK(brute.faceCount() == 5454);
    CHECK(brute.coplanarTriples() == 0);
}

TEST_CASE("the gauge agrees with brute force over all pairs") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const BruteSolid brute(observer);
        Random random(1);
        double worst = 0;
        for (int i = 0; i < 10000; ++i) {
            const XYZ t = random.inBox(solid, 0.5);
            const double expected = brute.gauge(t);
            worst = std::max(worst, std::abs(solid.gauge(t) - expected) / std::max(1.0, expected));
        }
        CHECK(worst <= 2 * solid.gaugeError());  // either has the same bound
    }
}

TEST_CASE("the gauge of black and white is 1, of the centre 0, and grows linearly") {
    for (const std::string& name : illuminantNames()) {
        const Solid solid{Observer(name)};
        CHECK(solid.gaugeError() < 1e-13);
        CHECK(std::abs(solid.gauge(XYZ(0, 0, 0)) - 1) <= solid.gaugeError());
        CHECK(std::abs(solid.gauge(solid.white()) - 1) <= solid.gaugeError());
        CHECK(solid.gauge(solid.center()) == 0);
        CHECK(solid.exit(solid.center()).spectrum == constantSpectrum(0.5));
        Random random(2);
        for (int i = 0; i < 1000; ++i) {
            const Imath::V3d d = random.direction();
            const double r = solid.gauge(XYZ(solid.center() + d));
            for (const double scale : {1e-6, 0.5, 3.0, 1e6}) {
                const double scaled = solid.gauge(XYZ(solid.center() + d * scale));
                CHECK(std::abs(scaled - r * scale) <=
                      2 * solid.gaugeError() * std::max(1.0, r * scale));
            }
        }
    }
}

TEST_CASE("a convex mixture of spectra is inside; its gauge is at most 1") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        Spectrum s;
        const double coin = random(0, 1);
        for (double& v : s) v = random(0, 1) < coin ? std::round(random(0, 1)) : random(0, 1);
        CHECK(solid.gauge(observer.color(s)) <= 1 + solid.gaugeError());
    }
}

TEST_CASE("a boundary colour's spectrum has that colour and is bounded") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        Random random(4);
        for (int i = 0; i < 5000; ++i) {
            const Solid::Exit exit = solid.exit(random.onBoundary(observer, solid));
            CHECK(withinBounds(exit.spectrum));
            CHECK(std::abs(exit.gauge - 1) <= solid.gaugeError());
            CHECK((observer.color(exit.spectrum) - exit.color).length() <=
                  solid.gaugeError() * solid.white().length() + sumRounding(solid));
        }
    }
}

TEST_CASE("a boundary spectrum has at most two changing generators, or is a base's") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(5);
    int onBase = 0;
    for (int i = 0; i < 5000; ++i) {
        const Solid::Exit exit = solid.exit(random.onBoundary(observer, solid));
        const Spectrum& s = exit.spectrum;
        CHECK(s[70] == s[74]);  // 730 and 750 nm
        CHECK(s[75] == s[77]);  // 755 and 765 nm
        CHECK(s[75] == s[79]);  // and 775 nm
        const auto isFree = [](double v) { return v > 0 && v < 1; };
        if (std::abs(exit.color.z - solid.center().z) >= solid.center().z * (1 - 1e-14)) {
            ++onBase;
            CHECK(std::none_of(s.begin(), s.begin() + 54, isFree));  // below 650 nm, Z > 0
        } else {
            // Members of a merged group count once.
            CHECK(std::count_if(s.begin(), s.end(), isFree) - (isFree(s[70]) + 2 * isFree(s[75])) <=
                  2);
        }
    }
    CHECK(onBase > 100);
}

TEST_CASE("boundary spectra are those of the opposite point, turned over") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const XYZ t = random.onBoundary(observer, solid);
        Spectrum turned = solid.exit(XYZ(solid.white() - t)).spectrum;
        for (double& v : turned) v = 1 - v;
        // s of a face is rounding / (length times sine): weighted by the length, 1/sine remains,
        // below 1e4 for neighbouring bands.
        CHECK(weightedDifference(observer, solid.exit(t).spectrum, turned) <
              1e4 * solid.gaugeError());
    }
}

TEST_CASE("the boundary spectrum is continuous over sides, bases and their rims") {
    for (const char* name : {"D65", "A", "F11"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        Random random(7);
        double worst = 0;
        for (int i = 0; i < 300; ++i) {
            // Halve a segment 40 times, each time keeping the half over which the spectrum changes
            // more: a jump would stay.
            XYZ a = random.onBoundary(observer, solid);
            XYZ b = i % 2 ? random.onBoundary(observer, solid) : XYZ(a + random.direction() * 0.01);
            for (int halving = 0; halving < 40; ++halving) {
                const XYZ middle((a + b) / 2);
                const Spectrum s = solid.exit(middle).spectrum;
                const double before = weightedDifference(observer, solid.exit(a).spectrum, s);
                const double after = weightedDifference(observer, s, solid.exit(b).spectrum);
                (before > after ? b : a) = middle;
            }
            worst = std::max(worst, weightedDifference(observer, solid.exit(a).spectrum,
                                                       solid.exit(b).spectrum));
        }
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("the nearest point agrees with brute force over all faces") {
    for (const char* name : {"D65", "A", "F11", "E"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const BruteSolid brute(observer);
        Random random(8);
        int outside = 0;
        for (int i = 0; outside < 2500; ++i) {
            const double reach = std::pow(10.0, random(-9, 1));
            const XYZ t =
                i % 2 ? random.inBox(solid, 0.5)
                      : XYZ(random.onBoundary(observer, solid) + random.direction() * reach);
            if (solid.gauge(t) <= 1 + solid.gaugeError()) continue;
            ++outside;
            const Solid::Nearest nearest = solid.nearest(t);
            XYZ point;
            const double expected = brute.distance(t, &point);
            // Both points are in the solid to rounding, so neither distance is below the true one
            // by more.
            const double rounding = 2 * (sumRounding(solid) + 3 * kUnit * t.length());
            CHECK(std::abs(nearest.distance - expected) <= rounding);
            // The solid is convex: points of it whose distances differ by e are sqrt(2 d e + e^2)
            // apart at the most.
            CHECK((nearest.color - point).length() <=
                  std::sqrt(2 * expected * rounding + rounding * rounding) + rounding);
        }
    }
}

TEST_CASE(
    "the nearest point is optimal, its spectrum bounded and its own, however far the colour") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const XYZ w = solid.white();
        Random random(9);
        for (int i = 0; i < 4000; ++i) {
            const double reach = std::pow(10.0, random(-9, 6));
            const XYZ t(random.onBoundary(observer, solid) + random.direction() * reach);
            const Solid::Nearest nearest = solid.nearest(t);
            if (!nearest.spectrum) continue;
            CHECK(withinBounds(*nearest.spectrum));
            CHECK((observer.color(*nearest.spectrum) - nearest.color).length() <=
                  sumRounding(solid));
            // (t − p)·(q − p) <= 0 for every q, to rounding. With e = 79u(|t| + w), the rounding of
            // t − W s, the search stops at slopes of e·w_j as it computes them, which are e·w_j
            // from the true ones; here t − p and the support round by as much again. Σ w_j = w.
            const Imath::V3d gap = t - nearest.color;
            double rounding = 0;
            for (int k = 0; k < 3; ++k) {
                rounding += 3 * 81 * kUnit * (std::abs(t[k]) + w[k]) * w[k];
            }
            CHECK(solid.support(gap) - gap.dot(nearest.color) <= rounding);
        }
    }
}

TEST_CASE("the nearest point of a colour inside is itself, of a nearest point the same") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(10);
    for (int i = 0; i < 5000; ++i) {
        const XYZ t = random.inBox(solid, 0.2);
        const Solid::Nearest nearest = solid.nearest(t);
        if (solid.gauge(t) <= 1) {
            CHECK(nearest.color == t);
            CHECK(nearest.distance == 0);
            CHECK(!nearest.spectrum);
        } else {
            CHECK(nearest.distance == (t - nearest.color).length());
            CHECK((solid.nearest(nearest.color).color - nearest.color).length() <=
                  2 * (solid.gaugeError() * solid.white().length() + sumRounding(solid)));
        }
    }
}

TEST_CASE("the nearest points of colours picked by hand") {
    const Observer observer("D65");
    const Solid solid(observer);
    const XYZ w = solid.white();
    // Every w_j has components >= 0, so that 0 and white are nearest to what lies opposite.
    CHECK(solid.nearest(XYZ(-1, -2, -3)).color == XYZ(0, 0, 0));
    CHECK(solid.exit(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
    CHECK(solid.exit(w).spectrum == constantSpectrum(1));
    CHECK(*solid.nearest(XYZ(-1e6, -1e6, -1e6)).spectrum == constantSpectrum(0));
    CHECK(*solid.nearest(XYZ(w * 2)).spectrum == constantSpectrum(1));
    CHECK(*solid.nearest(XYZ(1e6, 1e6, 1e6)).spectrum == constantSpectrum(1));
    // Below the centre of the base at Z = 0 only that component changes.
    XYZ base;
    for (const Imath::V3d& v : observer.weights()) {
        if (v.z == 0) base += v / 2;
    }
    for (const double depth : {1e-9, 1.0, 1e6}) {
        const Solid::Nearest nearest = solid.nearest(XYZ(base.x, base.y, -depth));
        CHECK((nearest.color - base).length() <= sumRounding(solid));
        for (std::size_t m = 0; m < kBandCount; ++m) {
            const double expected = observer.weights()[m].z == 0 ? 0.5 : 0;
            // A base's spectrum changes by at most 1/(2h) for a shift along a normal n.
            CHECK(std::abs((*nearest.spectrum)[m] - expected) < 1e-12);
        }
    }
}

namespace {

/// A row of macadam_limits.csv.
struct Limit {
    double x, y, Y;
    explicit Limit(const std::vector<std::string>& row)
        : x(std::stod(row[1])), y(std::stod(row[2])), Y(std::stod(row[3]) / 100) {}

    XYZ color() const { return {x / y * Y, Y, (1 - x - y) / y * Y}; }

    /// What half a unit of the last printed digit of x and y, the fourth, moves in XYZ.
    double printing() const {
        constexpr double half = 0.5e-4;
        const Imath::V3d byX(1, 0, -1);
        const Imath::V3d byY(-x / y, 0, -1 - (1 - x - y) / y);
        return half * Y / y * (byX.length() + byY.length());
    }
};

/// An ideal spectrum jumps at any wavelength; here a jump within a band is a fraction of the band's
/// weight. The colour then moves along the chord instead of the curve, which stands off by up to an
/// eighth of its second difference: |w_{m+1} − w_{m−1}| / 16 for each band with a jump.
double chordError(const Observer& observer, const Spectrum& s) {
    const auto& w = observer.weights();
    double sum = 0;
    for (std::size_t m = 1; m + 1 < s.size(); ++m) {
        if (s[m - 1] != s[m + 1]) sum += (w[m + 1] - w[m - 1]).length() / 16;
    }
    return sum;
}

}  // namespace

TEST_CASE("published optimal-colour limits lie on the boundary") {
    for (const char* name : {"A", "C", "D65"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        int points = 0;
        int astray = 0;
        for (const auto& row : readCsv("tests/data/macadam_limits.csv")) {
            if (row[0] != name) continue;
            const Limit limit(row);
            const XYZ t = limit.color();
            const Solid::Exit exit = solid.exit(t);
            const double depth = (1 - exit.gauge) * (exit.color - solid.center()).length();
            const double away = exit.gauge > 1 ? solid.nearest(t).distance : depth;
            ++points;
            if (away > limit.printing() + chordError(observer, exit.spectrum)) ++astray;
        }
        CHECK(points >= 197);
        // The table of C was computed by hand in 1935 and holds slips: (0.32, 0.6357) at Y = 40 is
        // 0.026 inside the solid, the next worst 0.009.
        CHECK(astray == (observer.illuminant() == "C" ? 8 : 0));
    }
}
