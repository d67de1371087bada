#include "solve/natural/vote.h"

#include "solve/natural/kernel.h"
#include "solve/natural/weighted_sum.h"
#include "solve/shell.h"
#include "support/csv.h"
#include "support/each_target.h"
#include "support/solid_samples.h"

#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

/// (M14) term by term from the file, nothing left out, in long doubles.
class BruteVote {
  public:
    BruteVote(const Observer& observer, const Solver& solver) : white_(observer.white()) {
        for (const auto& row : readCsv("data/natural.csv")) {
            Spectrum s;
            for (std::size_t m = 0; m < s.size(); ++m) s[m] = std::stod(row.at(m + 3)) / 1e4;
            if (sets_.empty() || name_ != row.at(0)) sets_.emplace_back();
            name_ = row.at(0);
            const XYZ color = observer.color(s);
            const Spectrum solved = solver.solve(color).spectrum;
            for (std::size_t m = 0; m < s.size(); ++m) s[m] -= solved[m];
            sets_.back().push_back({labFromXYZ(color, white_), s});
        }
    }

    Spectrum at(const XYZ& color) const {
        const Lab lab = labFromXYZ(color, white_);
        std::vector<long double> q;
        std::vector<std::vector<long double>> means;
        for (const auto& set : sets_) {
            long double mass = 0;
            std::vector<long double> sum(kBandCount, 0);
            for (const auto& [place, black] : set) {
                const long double weight = std::exp(-squared(lab, place) / (2 * 3 * 3));
                mass += weight;
                for (std::size_t m = 0; m < sum.size(); ++m) {
                    sum[m] += weight * static_cast<long double>(black[m]);
                }
            }
            for (long double& value : sum) value /= mass;
            q.push_back(mass / (mass + 0.5L));
            means.push_back(sum);
        }
        return believed(lab, q, means);
    }

    /// The blacks themselves.
    std::vector<Spectrum> blacks() const {
        std::vector<Spectrum> all;
        for (const auto& set : sets_) {
            for (const auto& sample : set) all.push_back(sample.second);
        }
        return all;
    }

  private:
    static long double compressed(const Lab& lab) {
        const long double chroma = std::sqrt(lab.a * lab.a + lab.b * lab.b);
        return chroma == 0 ? 1 : std::log(1 + 0.03L * chroma) / (0.03L * chroma);
    }
    static long double squared(const Lab& one, const Lab& two) {
        const long double f = compressed(one), g = compressed(two);
        const long double L = (one.L - two.L) / 2, a = one.a * f - two.a * g,
                          b = one.b * f - two.b * g;
        return L * L + a * a + b * b;
    }
    static Spectrum believed(const Lab& lab, const std::vector<long double>& q,
                             const std::vector<std::vector<long double>>& means) {
        long double Q = 0, size = 0, V = 0;
        for (const long double vote : q) Q += vote;
        std::vector<long double> mean(kBandCount, 0);
        for (std::size_t m = 0; m < mean.size(); ++m) {
            for (std::size_t j = 0; j < q.size(); ++j) mean[m] += q[j] * means[j][m] / Q;
            size += mean[m] * mean[m];
            for (std::size_t j = 0; j < q.size(); ++j) {
                V += q[j] * (means[j][m] - mean[m]) * (means[j][m] - mean[m]) / Q;
            }
        }
        const long double f = compressed(lab);
        const long double chroma = f * f * (lab.a * lab.a + lab.b * lab.b);
        const long double fade = chroma / (chroma + 4) * lab.L * lab.L / (lab.L * lab.L + 100);
        Spectrum v;
        for (std::size_t m = 0; m < v.size(); ++m) {
            v[m] = double(fade * Q / (Q + 0.5L) * size / (size + 0.1L * V / Q) * mean[m]);
        }
        return v;
    }

    XYZ white_;
    std::string name_;
    std::vector<std::vector<std::pair<Lab, Spectrum>>> sets_;
};

}  // namespace

TEST_CASE("the vote is (M14), by brute force from the file, and has no colour") {
    for (const char* light : {"D65", "A", "F11"}) {
        CAPTURE(light);
        const Observer observer(light);
        const ShellSolver solver(observer);
        const Vote vote(observer, solver, builtInSets());
        const BruteVote brute(observer, solver);
        // Each sample is solved to 1e-12 of its colour, below 1.2 here.
        for (const Spectrum& black : brute.blacks()) {
            REQUIRE(largestComponent(observer.color(black)) <=
                    1.2e-12 + 2 * sumRounding(solver.solid()));
        }
        Random random(51);
        double largest = 0;
        for (int i = 0; i < 1000; ++i) {
            const XYZ t = random.inBox(solver.solid(), 0);
            if (solver.solid().gauge(t) > 1) continue;
            const Spectrum v = vote.at(t);
            // What is left out: 800 weights of 2^-40, beside e; then up to 1/(Q + ½) of it.
            REQUIRE(maxDifference(v, brute.at(t)) <= 800 * 0x1p-40 / 0.5 / 0.5);
            REQUIRE(largestComponent(observer.color(v)) <= 2e-12);
            for (const double value : v) largest = std::max(largest, std::abs(value));
        }
        CHECK(largest > 0.05);
    }
}

TEST_CASE("far from all samples, and without any, there is no vote") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    CHECK(Vote(observer, solver, {}).at(XYZ(0.3, 0.2, 0.1)) == Spectrum{});
    CHECK(Vote(observer, solver, {{"empty", {}}}).at(XYZ(0.3, 0.2, 0.1)) == Spectrum{});
    MeasuredSample sample{"one", constantSpectrum(0.2), ""};
    for (std::size_t m = 40; m < kBandCount; ++m) sample.reflectance[m] = 0.7;
    const Vote one(observer, solver, {{"one", {sample}}});
    CHECK(one.at(XYZ(0.1, 0.2, 0.9)) == Spectrum{});
    const XYZ color = observer.color(sample.reflectance);
    const Spectrum missed = solver.solve(color).spectrum;
    const Spectrum v = one.at(color);
    // One set, one sample, at its own colour: q = 1/(1 + e), V = 0, so Q/(Q + ½) = 4/7, but for the
    // fade, the same in all bands.
    const double part = v[80] / (0.7 - missed[80]);
    CHECK(part < 4.0 / 7);
    CHECK(part > 0.9 * 4 / 7);
    for (std::size_t m = 0; m < kBandCount; ++m) {
        CHECK(std::abs(v[m] - part * (sample.reflectance[m] - missed[m])) <= 1e-14);
    }
}

TEST_CASE("the file holds the sets, each in [0, 1], and the materials that are asked for") {
    std::size_t samples = 0;
    std::vector<std::string> materials;
    for (const MeasuredSet& set : builtInSets()) {
        for (const MeasuredSample& sample : set.samples) {
            CHECK(withinBounds(sample.reflectance));
            materials.push_back(sample.material);
            ++samples;
        }
    }
    CHECK(samples == readCsv("data/natural.csv").size());
    const auto count = [&](const char* of) { return std::ranges::count(materials, of); };
    CHECK(count("skin") == 71 + 30);  // the set, and those among the objects
    CHECK(count("leaf") == 18);
    CHECK(count("wood") == 9);
    CHECK(count("ground") == 25);
    const std::array<std::string_view, 2> charts = {"SG", "ColorChecker"};
    CHECK(builtInSetsWithout(charts).size() == builtInSets().size() - 2);
}

TEST_CASE("weighted sums are those of a plain loop, bit for bit") {
    Random random(17);
    for (std::size_t count = 0; count < 20; ++count) {
        std::vector<Spectrum> spectra(count);
        std::vector<Weighted> terms;
        for (Spectrum& s : spectra) {
            for (double& value : s) value = random(-1, 1);
            terms.push_back({random(-1, 1), &s});
        }
        Spectrum sum{};
        sum[0] = 1;
        Spectrum expected = sum;
        addWeighted(terms, sum);
        for (const Weighted& term : terms) {
            for (std::size_t m = 0; m < expected.size(); ++m) {
                expected[m] += term.weight * (*term.spectrum)[m];
            }
        }
        CHECK(sum == expected);
    }
}

TEST_CASE("near places have the weights of the kernel, in their order, on every processor") {
    // exp is within 1 unit in the last place (Highway), its argument and 1/2h² within 4 roundings
    // of up to 28: weights differ by 28 · 4 u + 2 u of themselves at most.
    constexpr double limit = 114 * 0x1p-53;
    Random random(23);
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 100U}) {
        CAPTURE(count);
        Places places;
        std::vector<Imath::V3d> all;
        for (std::size_t k = 0; k < count; ++k) {
            all.emplace_back(random(0, 60), random(-30, 30), random(-30, 30));
            places.add(all.back());
        }
        const Imath::V3d p(random(0, 60), random(-30, 30), random(-30, 30));
        onEachTarget([&] {
            Near near;
            weighNear(places, p, 3, near);
            std::size_t found = 0;
            for (std::size_t k = 0; k < count; ++k) {
                const double expected = std::exp(-(all[k] - p).length2() / 18);
                if (expected < 0x1p-40) continue;
                REQUIRE(found < near.indices.size());
                CHECK(near.indices[found] == k);
                CHECK(std::abs(near.weights[found] - expected) <= limit * expected);
                ++found;
            }
            CHECK(found == near.indices.size());
        });
    }
}
