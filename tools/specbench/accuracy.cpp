#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "methods/catalog.h"
#include "progress.h"
#include "statistics.h"

#include <filesystem>

namespace specbake::bench {
namespace {

constexpr double kContinuityDistance = 1e-4;  // in RGB

struct Chart {
    std::string name;
    std::vector<NamedSpectrum> patches;
};

/// Reflectances that conserve energy; the tables hold a few fluorescent ones that do not.
Chart readChart(const std::string& path) {
    Chart chart{std::filesystem::path(path).stem().string(), {}};
    for (NamedSpectrum& patch : readReflectances(path)) {
        if (boundsViolation(patch.spectrum) == 0) chart.patches.push_back(std::move(patch));
    }
    return chart;
}

std::vector<Chart> readCharts(const Options& options) {
    std::vector<Chart> charts;
    for (const std::string& path : options.reflectances) charts.push_back(readChart(path));
    if (charts.empty()) charts.push_back(readChart(options.data + "/colorchecker_24.csv"));
    return charts;
}

std::vector<Light> lights(const Options& options) {
    std::vector<Light> list;
    for (const char* name : {"A", "D50", "F2", "F11"}) list.push_back(lightOf(Observer(name)));
    list.push_back(readLight("LED-B3", options.data + "/illuminant_led_b3.csv"));
    return list;
}

class Run {
  public:
    explicit Run(const Options& options)
        : options_(options),
          figures_("accuracy", options.full ? "specbench accuracy --full" : "specbench accuracy"),
          charts_(readCharts(options)),
          lights_(lights(options)) {}

    void measure(Method& method) {
        addSpeed(method);
        addRoundTrip(method);
        addNature(method);
    }
    void write() const { figures_.write(options_.out); }

  private:
    void add(const Method& method, const std::string& set, const Measure& m) {
        figures_.add({set, method.name(), m.quantity, m.value, m.unit, {}, ""});
    }

    void addSpeed(Method& method) {
        const double seconds = secondsOf([&] { method.setUp(); });
        add(method, "", {"set-up", seconds, "s"});
        const auto runTime = std::chrono::duration<double>(options_.full ? 0.5 : 0.1);
        const double rate = throughput(method, options_.full ? 9 : 5, runTime);
        add(method, "RGB cube", {"throughput", rate, "texel/s"});
    }

    void addRoundTrip(const Method& method) {
        for (const ColorSet& set : beyondTheCube(method)) {
            for (const Measure& m : measureRoundTrip(method, set)) add(method, set.name, m);
        }
        for (const ColorSet& set : rgbSets(method.frame(), options_.colors())) {
            for (const Measure& m : measureRoundTrip(method, set)) add(method, set.name, m);
            const auto ratios = continuity(method, set.colors, kContinuityDistance);
            add(method, set.name, {"continuity median", median(ratios), "reflectance per RGB"});
            add(method, set.name,
                {"continuity p99.9", quantile(ratios, 0.999), "reflectance per RGB"});
            add(method, set.name, {"continuity max", largest(ratios), "reflectance per RGB"});
        }
    }

    std::vector<ColorSet> beyondTheCube(const Method& method) const {
        if (method.cubeOnly()) return {};
        const Solid solid(method.frame().observer);
        return solidSets(method.frame(), solid, options_.solidColors());
    }

    void addNature(const Method& method) {
        for (const Chart& chart : charts_) {
            for (const Measure& m : measureNature(method, chart.patches, lights_)) {
                add(method, chart.name, m);
            }
        }
    }

    const Options& options_;
    Figures figures_;
    std::vector<Chart> charts_;
    std::vector<Light> lights_;
};

}  // namespace

void runAccuracy(const Options& options) {
    Run run(options);
    const Methods methods = everyMethod(options.data);
    Progress progress(methods.size());
    for (const auto& method : methods) {
        progress.next(method->name().full());
        run.measure(*method);
    }
    run.write();
}

}  // namespace specbake::bench
