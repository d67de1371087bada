#include "solve/descent/face_path.h"

#include "support/sample_colors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

constexpr double kEps = 0x1p-52;

double sumOfMagnitudes(const Imath::V3d& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Rates over eight decades, amplitudes up to 1 with either sign, a start in [0, 1].
Decay randomDecay(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Decay d;
    d.start = uniform(random);
    double rates[3];
    for (double& rate : rates) rate = std::pow(10.0, 8 * uniform(random) - 4);
    std::sort(rates, rates + 3);
    d.rates = {rates[0], rates[1], rates[2]};
    for (int k = 0; k < 3; ++k) d.amplitudes[k] = 2 * uniform(random) - 1;
    return d;
}

/// A random face of the box and a point in it, with a colour to go to.
struct Scene {
    Observer observer{"D65"};
    FreeSet free;
    Spectrum start;
    Imath::V3d residual;

    Scene(testing::SampleColors& colors, std::mt19937_64& random, double gauge) {
        std::uniform_real_distribution<double> uniform(0, 1);
        for (double& value : start) value = uniform(random);
        const double fixedShare = uniform(random) * 0.8;
        free.removeIf([&](std::size_t m) {
            const bool fixed = uniform(random) < fixedShare;
            if (fixed) start[m] = start[m] < 0.5 ? 0 : 1;
            return fixed;
        });
        residual = observer.color(start) - colors.atGauge(gauge);
    }
};

}  // namespace

TEST_CASE("the first exit of a sum of exponentials is that of dense sampling") {
    std::mt19937_64 random(1);
    int exits = 0, returns = 0, stays = 0;
    for (int i = 0; i < 2000; ++i) {
        const Decay d = randomDecay(random);
        const double end = 64 / d.rates.x;
        // a dozen roundings of terms of this size
        const double rounding = 16 * kEps * (d.start + sumOfMagnitudes(d.amplitudes));
        const auto exit = firstExit(d, end);
        exits += exit.has_value();
        stays += !exit;
        if (exit) {
            CHECK(std::abs(d.value(exit->time) - exit->bound) <= rounding);
            const double last = d.value(end);
            returns += last >= 0 && last <= 1;
        }
        // 400 samples a decade, from far below the fastest time constant to the end.
        const double until = exit ? exit->time : end;
        for (double time = 1e-3 / d.rates.z; time < until; time *= 1.006) {
            const double value = d.value(time);
            if (value < -rounding || value > 1 + rounding) {
                CAPTURE(i);
                FAIL_CHECK("an earlier exit was missed");
                break;
            }
        }
    }
    CHECK(exits > 500);
    CHECK(returns > 50);  // left [0, 1] on the way, though both ends are inside
    CHECK(stays > 100);
}

TEST_CASE("a decay that starts at a bound leaves at once, or not") {
    Decay d;
    d.rates = {1, 2, 3};
    d.amplitudes = {0.1, 0.1, 0.1};  // falls
    CHECK(firstExit(d, 64).value().time == 0);
    d.amplitudes = -d.amplitudes;  // rises to 0.3
    CHECK(!firstExit(d, 64));
    d.amplitudes = {-2, 0, 0};  // rises through 1 where 2 (1 - exp(-t)) = 1
    CHECK(firstExit(d, 64).value().time == doctest::Approx(std::log(2)).epsilon(4 * kEps));
    CHECK(firstExit(d, 64).value().bound == 1);
}

TEST_CASE("the closed form obeys the gradient flow ds/dt = -W^T (W s - t) in its face") {
    std::mt19937_64 random(2);
    const Observer observer("D65");
    testing::SampleColors colors(observer, 2);
    for (int i = 0; i < 50; ++i) {
        const Scene scene(colors, random, 0.9);
        const FlowPath path(observer.weights(), scene.free, scene.start, scene.residual);
        const Imath::V3d color = Imath::V3d(observer.color(scene.start)) - scene.residual;
        for (const double fraction : {1e-4, 1e-3, 1e-2, 1e-1}) {
            const double time = fraction * path.end();
            Spectrum s = scene.start;
            for (const std::size_t m : scene.free) s[m] = path.value(m, time);
            const Imath::V3d residual = observer.color(s) - color;
            for (const std::size_t m : scene.free) {
                const Decay d = path.component(m);
                const double h = 1e-3 / d.rates.z;
                const double difference = (d.value(time + h) - d.value(time - h)) / (2 * h);
                // h^2 / 6 of the third derivative, sum rate^3 |amplitude|, and rounding over h
                double bound = 0;
                for (int k = 0; k < 3; ++k) {
                    bound += h * h / 6 * std::pow(d.rates[k], 3) * std::abs(d.amplitudes[k]);
                }
                bound += 16 * kEps * (1 + sumOfMagnitudes(d.amplitudes)) / h;
                CHECK(std::abs(difference + observer.weights()[m].dot(residual)) <= bound);
            }
        }
    }
}

TEST_CASE("both paths start alike where they should, and have the same limit") {
    std::mt19937_64 random(3);
    const Observer observer("D65");
    testing::SampleColors colors(observer, 3);
    for (int i = 0; i < 100; ++i) {
        const Scene scene(colors, random, 0.9);
        const FlowPath flow(observer.weights(), scene.free, scene.start, scene.residual);
        const StraightPath line(observer.weights(), scene.free, scene.start, scene.residual);
        Spectrum limit = scene.start;
        for (const std::size_t m : scene.free) {
            limit[m] = flow.value(m, flow.end());
            const double size = 1 + sumOfMagnitudes(flow.component(m).amplitudes);
            CHECK(std::abs(limit[m] - line.value(m, line.end())) <= 64 * kEps * size);
            CHECK(flow.value(m, 0) == scene.start[m]);
            CHECK(line.value(m, 0) == scene.start[m]);
        }
        // The limit, out of bounds or not, has the colour: 81 roundings of terms |w| |s|.
        const Imath::V3d color = Imath::V3d(observer.color(scene.start)) - scene.residual;
        CHECK((Imath::V3d(observer.color(limit)) - color).length() < 1e-11);
    }
}

TEST_CASE("no component is outside before the first hit, and one is after it") {
    std::mt19937_64 random(4);
    const Observer observer("D65");
    testing::SampleColors colors(observer, 4);
    int hits = 0;
    for (int i = 0; i < 100; ++i) {
        const Scene scene(colors, random, 0.999);
        const FlowPath path(observer.weights(), scene.free, scene.start, scene.residual);
        const auto hit = path.firstHit();
        hits += hit.has_value();
        const double until = hit ? hit->time : path.end();
        double worst = 0;
        for (const std::size_t m : scene.free) {
            const Decay d = path.component(m);
            const double rounding = 16 * kEps * (1 + sumOfMagnitudes(d.amplitudes));
            for (int k = 0; k < 500; ++k) {
                const double value = d.value(until * k / 500);
                worst = std::max(worst, std::max(-value, value - 1) / rounding);
            }
        }
        CHECK(worst <= 1);
        if (!hit) continue;
        const double after = path.value(hit->band, hit->time * (1 + 1e-6));
        CHECK((hit->bound == 0 ? after < 0 : after > 1));
    }
    CHECK(hits > 50);
}
