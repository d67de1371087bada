#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::bench {

/// What all commands share. The sizes are chosen so that `charts` takes minutes on two cores.
struct Options {
    std::string out = "build/bench";        ///< folder of the results
    std::string data = SPECBENCH_DATA_DIR;  ///< folder of the tables
    std::vector<std::string> reflectances;  ///< CSV files, beside the ColorChecker of `data`
    std::vector<std::string> textures;      ///< sRGB images, beside the project's own
    std::string charts = "docs/charts";     ///< folder of the charts
    bool full = false;                      ///< more colours, longer runs

    std::size_t colors() const { return full ? 100'000 : 5'000; }
    /// Of the sets beyond the RGB cube, where some methods take a hundred times as long.
    std::size_t solidColors() const { return full ? 5'000 : 500; }

    std::vector<std::string> allReflectances() const;
    std::vector<std::string> allTextures() const;
    /// The command line that measures the same again.
    std::string commandLine(const std::string& command) const;
};

/// Speed and accuracy of every method and setting: accuracy.csv, accuracy.json.
void runAccuracy(const Options& options);
/// Failures, residual and continuity towards the boundary: stability.*, and map.csv.
void runStability(const Options& options);
/// What a texture needs of the grid and of the half floats: scene.*.
void runScene(const Options& options);
/// The spectra of a dozen measured colours by every method: spectra.*.
void runSpectra(const Options& options);
/// Measured sets rebuilt from their colours, each without its own votes: nature.*, and the table of
/// docs/nature.md.
void runNature(const Options& options);
/// Whether any colour of the solid fails, and how steep spectra get: exhaustive.*. `full`: 10^6
/// colours of the solid, 10^5 of each other set. Throws Error if a colour fails.
void runExhaustive(const Options& options);
/// The first four, then the charts. Throws Error if the plotting step fails.
void runCharts(const Options& options);

}  // namespace specbake::bench
