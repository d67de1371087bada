#include "file/text_table.h"

#include <specbake/core/error.h>
#include <specbake/core/quadrature.h>
#include <specbake/image/observer_file.h>

#include <filesystem>
#include <vector>

namespace specbake {

using namespace internal;

std::string readObserver(const std::string& path) {
    constexpr std::size_t mostRows = 10'000;
    std::vector<MatchingSample> table;
    for (const std::vector<double>& row : rowsOfTable(textOfTable(path), 4, mostRows)) {
        table.push_back({row[0], Imath::V3d(row[1], row[2], row[3])});
    }
    if (table.empty()) {
        throw FileError(path, "no table of wavelengths in nm and three colour-matching functions");
    }
    try {
        return observerText(std::filesystem::path(path).filename().string(), table);
    } catch (const ArgumentError& error) {
        throw FileError(path, error.what());
    }
}

}  // namespace specbake
