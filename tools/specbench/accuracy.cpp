#include "colors/patches.h"
#include "colors/texture.h"
#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "methods/catalog.h"
#include "statistics.h"
#include "tasks.h"

#include <algorithm>
#include <filesystem>

namespace specbake::bench {
namespace {

/// Writes as much as the methods do, and nothing else: what the memory allows.
class WriteAlone : public Method {
  public:
    WriteAlone() : Method({"memset", ""}, sRGBFrame()) {}
    Reconstruction reconstruct(const XYZ&) const override { return {}; }
    void reconstructTexels(std::span<const Imath::V3f>, std::span<float> spectra) const override {
        std::ranges::fill(spectra, 0.0F);
    }
};

std::vector<Light> lights(const Options& options) {
    std::vector<Light> list;
    for (const char* name : {"A", "D50", "F2", "F11"}) list.push_back(lightOf(Observer(name)));
    list.push_back(readLight("LED-B3", options.data + "/illuminant_led_b3.csv"));
    return list;
}

ColorSet colorsOf(const std::string& texturePath, const Frame& frame, std::size_t count) {
    ColorSet set{.name = std::filesystem::path(texturePath).filename().string(), .colors = {}};
    for (const RGB& color : distinctColors(texturePath, count)) {
        set.colors.push_back(frame.xyz(color));
    }
    return set;
}

class Run {
  public:
    explicit Run(const Options& options)
        : options_(options),
          figures_("accuracy", options.commandLine("accuracy")),
          methods_(everyMethod(options.data)),
          charts_(readCharts(options)),
          lights_(lights(options)) {}

    /// One thread, and nothing beside it; likewise measureThroughput().
    void setUp() {
        Progress progress("set-up", methods_.size());
        for (const auto& method : methods_) {
            progress.next(method->name().full());
            const double seconds = secondsOf([&] { method->setUp(); });
            figures_.add({"", method->name(), "set-up", seconds, "s", {}, ""});
        }
    }

    void measureThroughput() {
        const WriteAlone limit;
        std::vector<const Method*> all{&limit};
        for (const auto& method : methods_) all.push_back(method.get());
        Progress progress("throughput", 1);
        progress.next("all methods in turn");
        const auto runTime = std::chrono::duration<double>(options_.full ? 0.5 : 0.15);
        const auto rates = throughput(all, options_.full ? 15 : 7, runTime);
        for (std::size_t i = 0; i < all.size(); ++i) {
            figures_.add({"RGB cube", all[i]->name(), "throughput", rates[i], "texel/s", {}, ""});
        }
    }

    /// On all cores.
    void measureAccuracy() {
        for (const auto& method : methods_) addTasks(*method);
        Progress progress("accuracy", tasks_.size());
        for (const std::vector<Figure>& some : onAllCores(tasks_, progress)) {
            for (const Figure& figure : some) figures_.add(figure);
        }
    }

    void write() const { figures_.write(options_.out); }

  private:
    using Measures = std::vector<Measure>;

    void addTask(const Method& method, const std::string& set, std::function<Measures()> measure) {
        tasks_.push_back(
            {method.name().full() + ": " + set,
             [name = method.name(), set, measure = std::move(measure)] {
                 std::vector<Figure> figures;
                 for (const Measure& m : measure()) {
                     figures.push_back({set, name, m.quantity, m.value, m.unit, {}, ""});
                 }
                 return figures;
             }});
    }

    void addTasks(const Method& method) {
        if (!method.cubeOnly()) {
            const Solid solid(method.frame().observer);
            for (ColorSet& set : solidSets(method.frame(), solid, options_.solidColors())) {
                addTask(method, set.name, [&method, set] { return measureRoundTrip(method, set); });
            }
        }
        std::vector<ColorSet> sets = rgbSets(method.frame(), options_.colors());
        for (const std::string& path : options_.allTextures()) {
            sets.push_back(colorsOf(path, method.frame(), options_.colors()));
        }
        for (const ColorSet& set : sets) {
            addTask(method, set.name, [&method, set] {
                Measures all = measureRoundTrip(method, set);
                std::ranges::copy(measureContinuity(method, set), std::back_inserter(all));
                return all;
            });
        }
        for (const Chart& chart : charts_) {
            addTask(method, chart.name, [this, &method, &chart] {
                return measureNature(method, chart.patches, lights_);
            });
        }
    }

    const Options& options_;
    Figures figures_;
    Methods methods_;
    std::vector<Chart> charts_;
    std::vector<Light> lights_;
    std::vector<Task<std::vector<Figure>>> tasks_;
};

}  // namespace

void runAccuracy(const Options& options) {
    Run run(options);
    run.setUp();
    run.measureThroughput();
    run.measureAccuracy();
    run.write();
}

}  // namespace specbake::bench
