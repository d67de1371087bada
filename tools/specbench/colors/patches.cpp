#include "colors/patches.h"

#include <filesystem>

namespace specbake::bench {

std::vector<Chart> readCharts(const Options& options) {
    std::vector<Chart> charts;
    for (const std::string& path : options.allReflectances()) {
        Chart chart{std::filesystem::path(path).stem().string(), readReflectances(path)};
        std::erase_if(chart.patches,
                      [](const NamedSpectrum& p) { return boundsViolation(p.spectrum) > 0; });
        charts.push_back(std::move(chart));
    }
    return charts;
}

}  // namespace specbake::bench
