#include "colors/patches.h"
#include "colors/texture.h"
#include "commands.h"
#include "figures.h"
#include "mantissa.h"
#include "measures.h"
#include "methods/grid_method.h"
#include "methods/solver_method.h"
#include "progress.h"
#include "statistics.h"
#include "upsample/node_values.h"

#include <specbake/bake/bake.h>
#include <specbake/core/ciede2000.h>
#include <specbake/core/methods.h>
#include <specbake/core/solid.h>

#include <Imath/half.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

namespace specbake::bench {

using namespace internal;

namespace {

/// What a bake uses if it is told nothing.
const std::string kMethod(methods().front().name);

std::shared_ptr<const Solver> defaultSolver(const Observer& observer) {
    return methods().front().makeSolver(observer, Solid(observer), SolverUse::gridNodes);
}

constexpr int kGrids[] = {5, 9, 13, 17, 25, 33, 65};
constexpr std::size_t kBakes = 5;    // of which the median counts
constexpr double kBakesSeconds = 1;  // after which there are no more

/// Colours to try, and the texture they are from, if they are.
struct Scene {
    std::string name;
    std::vector<XYZ> colors;
    std::string texture;  ///< path, or ""
};

std::vector<Scene> scenesOf(const Options& options, const Frame& frame) {
    std::vector<Scene> scenes;
    for (ColorSet& set : rgbSets(frame, options.colors())) {
        if (set.name == "RGB cube" || set.name == "dark") {
            scenes.push_back({set.name, std::move(set.colors), ""});
        }
    }
    for (const Chart& chart : readCharts(options)) {
        scenes.push_back({chart.name, {}, ""});
        for (const NamedSpectrum& patch : chart.patches) {
            scenes.back().colors.push_back(frame.observer.color(patch.spectrum));
        }
    }
    for (const std::string& path : options.allTextures()) {
        scenes.push_back({std::filesystem::path(path).filename().string(), {}, path});
        for (const RGB& color : distinctColors(path, options.colors())) {
            scenes.back().colors.push_back(frame.xyz(color));
        }
    }
    return scenes;
}

std::vector<Spectrum> spectraOf(const Method& method, const std::vector<XYZ>& colors) {
    std::vector<Spectrum> spectra;
    for (const XYZ& color : colors) spectra.push_back(method.reconstruct(color).spectrum);
    return spectra;
}

/// What a spectrum becomes when it is stored as halves with so many bits of mantissa.
Spectrum storedAsHalves(const Spectrum& spectrum, int bits) {
    std::array<float, kBandCount> floats;
    std::ranges::transform(spectrum, floats.begin(), [](double v) { return float(v); });
    std::array<Imath::half, kBandCount> halves;
    internal::storeRounded(floats, bits, std::as_writable_bytes(std::span(halves)).data());
    Spectrum stored;
    std::ranges::copy(halves, stored.begin());
    return stored;
}

class Run {
  public:
    Run(const Options& options, Progress& progress)
        : options_(options),
          progress_(progress),
          figures_("scene", options.commandLine("scene")),
          frame_(sRGBFrame()),
          solver_(defaultSolver(frame_.observer)),
          scenes_(scenesOf(options, frame_)),
          incandescent_("A") {
        const SolverMethod direct({kMethod, "direct"}, frame_, solver_);
        for (const Scene& scene : scenes_) direct_.push_back(spectraOf(direct, scene.colors));
    }

    void measureGrid(int nodes) {
        GridMethod grid({kMethod, ""}, frame_, solver_, nodes);
        progress_.next(grid.name().full());
        const double setUp = secondsOf([&] { grid.setUp(); });
        BakeOptions bakeOptions;
        bakeOptions.model.grid = nodes;
        for (std::size_t i = 0; i < scenes_.size(); ++i) {
            const auto add = adder(scenes_[i], grid.name(), nodes, "nodes per axis");
            add({"all nodes, time", setUp, "s"});
            add({"all nodes, memory", double(grid.bytes()), "byte"});
            addDeviation(direct_[i], spectraOf(grid, scenes_[i].colors), add);
            addBake(scenes_[i].texture, bakeOptions, add);
        }
    }

    void measureBits(int bits) {
        const MethodName name{kMethod, "half"};
        progress_.next(std::to_string(bits) + " bits");
        BakeOptions bakeOptions;
        bakeOptions.bits = bits;
        for (std::size_t i = 0; i < scenes_.size(); ++i) {
            const auto add = adder(scenes_[i], name, bits, "mantissa bits");
            std::vector<Spectrum> rounded = direct_[i];
            for (Spectrum& s : rounded) s = storedAsHalves(s, bits);
            addDeviation(direct_[i], rounded, add);
            addBake(scenes_[i].texture, bakeOptions, add);
        }
    }

    void write() const { figures_.write(options_.out); }

  private:
    using Adder = std::function<void(const Measure&)>;

    Adder adder(const Scene& scene, const MethodName& name, int at, const char* unit) {
        return [this, set = scene.name, name, at, unit](const Measure& m) {
            figures_.add({set, name, m.quantity, m.value, m.unit, double(at), unit});
        };
    }

    void addDeviation(const std::vector<Spectrum>& from, const std::vector<Spectrum>& to,
                      const Adder& add) const {
        std::vector<double> rms, most, deltaE;
        for (std::size_t i = 0; i < from.size(); ++i) {
            rms.push_back(rmsDifference(from[i], to[i]));
            most.push_back(maxDifference(from[i], to[i]));
            const XYZ& white = incandescent_.white();
            deltaE.push_back(ciede2000(labFromXYZ(incandescent_.color(from[i]), white),
                                       labFromXYZ(incandescent_.color(to[i]), white)));
        }
        add({"deviation RMS", rootMeanSquare(rms), "reflectance"});  // as bake --max-deviation
        add({"deviation max", largest(most), "reflectance"});
        add({"under A mean", mean(deltaE), "CIEDE2000"});
        add({"under A p99", quantile(deltaE, 0.99), "CIEDE2000"});
        add({"under A max", largest(deltaE), "CIEDE2000"});
    }

    /// The whole bake of the texture, half and ZIP: processor time of all threads, and the file.
    void addBake(const std::string& texture, const BakeOptions& bakeOptions,
                 const Adder& add) const {
        if (texture.empty()) return;
        const std::filesystem::path file = std::filesystem::path(options_.out) / "scene.exr";
        BakeStatistics statistics;
        std::vector<double> seconds;
        double sum = 0;
        while (seconds.size() < kBakes && sum < kBakesSeconds) {
            seconds.push_back(secondsOf([&] { statistics = bake(texture, file, bakeOptions); }));
            sum += seconds.back();
        }
        const double texels = double(statistics.texels);
        add({"bake", median(seconds), "s"});
        add({"bake, per texel", 1e6 * median(seconds) / texels, "µs"});
        add({"nodes solved", double(statistics.nodesSolved), "1"});
        add({"nodes, memory", double(statistics.nodesSolved * sizeof(internal::NodeValues)),
             "byte"});
        add({"file", double(std::filesystem::file_size(file)) / texels, "byte per texel"});
        std::filesystem::remove(file);
    }

    const Options& options_;
    Progress& progress_;
    Figures figures_;
    Frame frame_;
    std::shared_ptr<const Solver> solver_;
    std::vector<Scene> scenes_;
    Observer incandescent_;
    std::vector<std::vector<Spectrum>> direct_;  ///< by scene
};

}  // namespace

void runScene(const Options& options) {
    std::filesystem::create_directories(options.out);
    Progress progress("scene", std::size(kGrids) + BakeOptions::kMostMantissaBits -
                                   BakeOptions::kFewestMantissaBits + 1);
    Run run(options, progress);
    for (const int nodes : kGrids) run.measureGrid(nodes);
    for (int bits = BakeOptions::kFewestMantissaBits; bits <= BakeOptions::kMostMantissaBits;
         ++bits)
        run.measureBits(bits);
    run.write();
}

}  // namespace specbake::bench
