#include "measures.h"

#include "statistics.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

namespace specbake::bench {
namespace {

double share(std::size_t part, std::size_t all) {
    return all == 0 ? 0 : double(part) / double(all);
}

/// What is measured of every colour of a set, gathered.
struct Gathered {
    std::vector<double> residual, deltaE, violation, roughness;
    std::size_t outside = 0, samplesOutside = 0, failed = 0;
};

Gathered gather(const Method& method, const ColorSet& set) {
    Gathered all;
    for (const XYZ& color : set.colors) {
        Reconstruction r = method.reconstruct(color);
        for (double& value : r.spectrum) value = double(float(value));
        const Verdict v = judge(method, color, r);
        all.residual.push_back(v.residual);
        all.deltaE.push_back(v.deltaE);
        all.violation.push_back(v.violation);
        all.roughness.push_back(roughness(r.spectrum));
        all.outside += v.violation > 0;
        all.samplesOutside +=
            std::size_t(std::ranges::count_if(r.spectrum, [](double s) { return s < 0 || s > 1; }));
        all.failed += v.failed;
    }
    return all;
}

/// Texels to go through, and room for their spectra.
class Racetrack {
  public:
    Racetrack() : texels_(kTexels), spectra_(kTexels * kBandCount) {
        std::mt19937_64 random(22);
        const auto unit = [&] { return float(random() >> 40) * 0x1p-24F; };
        for (Imath::V3f& t : texels_) t = {unit(), unit(), unit()};
    }

    double secondsFor(const Method& method, std::size_t count) {
        return secondsOf([&] {
            for (std::size_t done = 0; done < count; done += kTexels) {
                const std::size_t part = std::min(kTexels, count - done);
                method.reconstructTexels({texels_.data(), part},
                                         {spectra_.data(), part * kBandCount});
            }
        });
    }

    /// How many texels the method does in about this time.
    std::size_t texelsIn(const Method& method, std::chrono::duration<double> time) {
        std::size_t count = 64;
        while (secondsFor(method, count) < 0.25 * time.count()) count *= 2;
        return 4 * count;
    }

  private:
    static constexpr std::size_t kTexels = 1 << 18;  // 85 MB of floats: more than caches hold
    std::vector<Imath::V3f> texels_;
    std::vector<float> spectra_;
};

}  // namespace

Verdict judge(const Method& method, const XYZ& color, const Reconstruction& result) {
    const Observer& observer = method.frame().observer;
    const XYZ reached = observer.color(result.spectrum);
    Verdict v;
    v.residual = largestComponent(reached - color);
    v.deltaE =
        ciede2000(labFromXYZ(color, observer.white()), labFromXYZ(reached, observer.white()));
    v.violation = boundsViolation(result.spectrum);
    // written so that NaN fails
    v.failed = !(result.converged && v.deltaE <= kVisible && v.violation <= kUsableViolation);
    return v;
}

std::vector<Measure> measureRoundTrip(const Method& method, const ColorSet& set) {
    const Gathered all = gather(method, set);
    const std::size_t n = set.colors.size();
    return {
        {"residual max", largest(all.residual), "XYZ"},
        {"residual RMS", rootMeanSquare(all.residual), "XYZ"},
        {"round trip mean", mean(all.deltaE), "CIEDE2000"},
        {"round trip p99", quantile(all.deltaE, 0.99), "CIEDE2000"},
        {"round trip max", largest(all.deltaE), "CIEDE2000"},
        {"out of bounds", share(all.outside, n), "share of colours"},
        {"samples out of bounds", share(all.samplesOutside, n * kBandCount), "share of samples"},
        {"out of bounds by", largest(all.violation), "reflectance"},
        {"failed", share(all.failed, n), "share of colours"},
        {"roughness", mean(all.roughness), "reflectance per band²"}};
}

std::vector<double> continuity(const Method& method, const std::vector<XYZ>& colors,
                               double distance) {
    std::mt19937_64 random(21);
    const auto step = [&](double from) {
        const double d = (random() & 1) != 0 ? distance : -distance;
        const bool inside = from >= 0 && from <= 1;
        return inside && (from + d < 0 || from + d > 1) ? -d : d;
    };
    std::vector<double> ratios;
    for (const XYZ& color : colors) {
        const RGB rgb = method.frame().rgb(color);
        const double dr = step(rgb.x), dg = step(rgb.y), db = step(rgb.z);
        const XYZ neighbour(color + method.frame().xyz(RGB(dr, dg, db)));
        const Spectrum here = method.reconstruct(color).spectrum;
        const Spectrum there = method.reconstruct(neighbour).spectrum;
        ratios.push_back(maxDifference(here, there) / distance);
    }
    return ratios;
}

std::vector<Measure> measureContinuity(const Method& method, const ColorSet& set) {
    const auto ratios = continuity(method, set.colors, set.neighbour);
    const char* unit = "reflectance per RGB";
    return {{"continuity median", median(ratios), unit},
            {"continuity p99.9", quantile(ratios, 0.999), unit},
            {"continuity max", largest(ratios), unit}};
}

XYZ Light::color(const Spectrum& s) const {
    Imath::V3d sum(0.0);
    for (std::size_t m = 0; m < s.size(); ++m) sum += weights[m] * s[m];
    return XYZ(sum);
}

Light lightOf(const Observer& observer) {
    return {observer.illuminant(), observer.weights(), observer.white()};
}

Light readLight(const std::string& name, const std::string& path) {
    const auto rows = readCsv(path);
    if (rows.size() != kBandCount) throw FileError(path, "81 rows expected");
    Light light{name, Observer("E").weights(), {}};
    double luminance = 0;
    for (std::size_t m = 0; m < rows.size(); ++m) {
        light.weights[m] *= numberIn(rows[m], 1, path);
        luminance += light.weights[m].y;
    }
    for (Imath::V3d& w : light.weights) w /= luminance;
    light.white = light.color(constantSpectrum(1));
    return light;
}

std::vector<Measure> measureNature(const Method& method, const std::vector<NamedSpectrum>& measured,
                                   const std::vector<Light>& lights) {
    std::vector<Spectrum> rebuilt;
    std::vector<double> error;
    for (const NamedSpectrum& patch : measured) {
        const XYZ color = method.frame().observer.color(patch.spectrum);
        rebuilt.push_back(method.reconstruct(color).spectrum);
        error.push_back(rmsDifference(rebuilt.back(), patch.spectrum));
    }
    std::vector<Measure> measures{{"reflectance error mean RMS", mean(error), "reflectance"},
                                  {"reflectance error max RMS", largest(error), "reflectance"}};
    for (const Light& light : lights) {
        std::vector<double> deltaE;
        for (std::size_t i = 0; i < measured.size(); ++i) {
            deltaE.push_back(ciede2000(labFromXYZ(light.color(measured[i].spectrum), light.white),
                                       labFromXYZ(light.color(rebuilt[i]), light.white)));
        }
        measures.push_back({"under " + light.name + " mean", mean(deltaE), "CIEDE2000"});
        measures.push_back({"under " + light.name + " p95", quantile(deltaE, 0.95), "CIEDE2000"});
        measures.push_back({"under " + light.name + " max", largest(deltaE), "CIEDE2000"});
    }
    return measures;
}

double secondsOf(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<double> throughput(const std::vector<const Method*>& methods, int runs,
                               std::chrono::duration<double> runTime) {
    Racetrack track;
    std::vector<std::size_t> counts;
    for (const Method* method : methods) counts.push_back(track.texelsIn(*method, runTime));
    std::vector<std::vector<double>> rates(methods.size());
    for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            rates[i].push_back(double(counts[i]) / track.secondsFor(*methods[i], counts[i]));
        }
    }
    std::vector<double> medians;
    for (std::vector<double>& of : rates) medians.push_back(median(std::move(of)));
    return medians;
}

}  // namespace specbake::bench
