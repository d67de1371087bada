#include <specbake/core/transfer.h>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace specbake;

namespace {

/// A few roundings of numbers of about 1, through pow() and its inverse of exponents up to 2.4.
constexpr double kRounding = 32 * 0x1p-52;

/// IEC 61966-2-1, (5) and (6).
double encodedSRGB(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// ITU-T H.273, table 3, values 1, 6, 14 and 15, with the constants that make the pieces meet.
double encodedRec709(double linear) {
    constexpr double alpha = 1.09929682680944;
    constexpr double beta = 0.018053968510807;
    return linear < beta ? 4.5 * linear : alpha * std::pow(linear, 0.45) - (alpha - 1);
}

/// ISO 22028-2, 3.4: 16 x below 1/512, where 16 / 512 is that power of 1/512 too.
double encodedRomm(double linear) {
    return linear < 0x1p-9 ? 16 * linear : std::pow(linear, 1 / 1.8);
}

struct Standard {
    Transfer transfer;
    double (*encoded)(double linear);
    double knot;  ///< of the linear component
    double gap;   ///< of the two pieces at the knot, as the standard's printed digits leave it
};

constexpr std::array kStandards = {
    Standard{Transfer::sRGB, encodedSRGB, 0.0031308, 1e-7},
    Standard{Transfer::rec709, encodedRec709, 0.018053968510807, 1e-13},
    Standard{Transfer::romm, encodedRomm, 0x1p-9, kRounding}};

}  // namespace

TEST_CASE("curves undo what their standards print, at 30,000 seeded values and at the knots") {
    std::mt19937_64 random(1);
    for (const Standard& s : kStandards) {
        CAPTURE(transferName(s.transfer));
        for (int i = 0; i < 10000; ++i) {
            // Half of the values lie around the knot.
            const double most = i % 2 == 0 ? 1 : 2 * s.knot;
            const double linear = std::uniform_real_distribution<double>(0, most)(random);
            // Between the knot and its image under the other piece, curves may take either piece.
            const double slack = std::abs(linear - s.knot) <= 10 * s.gap ? s.gap : 0;
            CHECK(std::abs(linearFrom(s.encoded(linear), s.transfer) - linear) <=
                  kRounding + slack);
        }
        CHECK(linearFrom(0, s.transfer) == 0);
        CHECK(linearFrom(1, s.transfer) == 1);
        const double below = linearFrom(s.transfer.knee, s.transfer);
        const double above = linearFrom(std::nextafter(s.transfer.knee, 1), s.transfer);
        CHECK(std::abs(above - below) <= s.gap);
        CHECK(std::abs(below - s.knot) <= s.gap);
    }
}

TEST_CASE("powers are powers, to Adobe's 2 + 51/256") {
    for (const double gamma : {1.8, 2.2, 2.4, 2.6, 2.19921875}) {
        for (const double v : {0.0, 0.003, 0.25, 0.5, 1.0, 1.5}) {
            CHECK(linearFrom(v, Transfer::power(gamma)) == std::pow(v, gamma));
        }
    }
}

TEST_CASE("curves rise, and are odd about 0") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0, 2);
    for (const Transfer& t : {Transfer::linear, Transfer::sRGB, Transfer::rec709, Transfer::romm,
                              Transfer::power(2.2)}) {
        for (int i = 0; i < 10000; ++i) {
            const double a = uniform(random);
            const double b = uniform(random);
            CHECK(linearFrom(-a, t) == -linearFrom(a, t));
            CHECK((linearFrom(a, t) < linearFrom(b, t)) == (a < b));
        }
    }
}

TEST_CASE("names of curves read back as the same curve, whatever its numbers") {
    for (const Transfer& t : {Transfer::linear, Transfer::sRGB, Transfer::rec709, Transfer::romm,
                              Transfer::power(563.0 / 256)}) {
        CHECK(transferFromName(transferName(t)) == t);
    }
    CHECK(transferName(Transfer::power(2.2)) == "gamma:2.2");
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const Transfer t{0.1 + 9.9 * uniform(random), uniform(random), 0.5 + uniform(random),
                         0.1 + 15 * uniform(random), 0.99 * uniform(random)};
        CHECK(transferFromName(transferName(t)) == t);
    }
}

TEST_CASE("words for curves, in any case, and those that are none") {
    CHECK(transferFromName("sRGB") == Transfer::sRGB);
    CHECK(transferFromName("ProPhoto") == Transfer::romm);
    CHECK(transferFromName("Gamma2.2") == Transfer::power(2.2));
    CHECK(transferFromName("gamma:1") == Transfer::linear);
    for (const char* text : {"", "gamma", "gamma:", "gamma:0", "gamma:-1", "gamma:nan", "gamma:inf",
                             "gamma:1e9", "gamma:2.2x", "curve:1,2,3", "curve:2.4,0,0,1,0",
                             "curve:2.4,0,1,0,0", "curve:2,0,1,1,1", "2.2", "pq", "hlg"}) {
        CAPTURE(text);
        CHECK_FALSE(transferFromName(text).has_value());
    }
}
