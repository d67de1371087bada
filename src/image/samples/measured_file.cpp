#include "samples/sample_table.h"

#include <specbake/core/error.h>
#include <specbake/core/wavelengths.h>
#include <specbake/image/measured_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace specbake {

using namespace internal;

namespace {

std::string contentOf(const std::string& path) {
    constexpr std::size_t most = 16'000'000;
    std::ifstream in(path, std::ios::binary);
    if (!in) throw FileError(path, "cannot be read");
    std::string text(4096, '\0');
    std::size_t size = 0;
    while (in.read(&text[size], std::streamsize(text.size() - size)) || in.gcount() > 0) {
        size += std::size_t(in.gcount());
        if (size > most) throw FileError(path, "larger than 16 MB: no table of samples");
        text.resize(2 * size + 4096);
    }
    text.resize(size);
    return text;
}

std::string whole(double nm) {
    return std::to_string(std::lround(nm));
}

double largestValue(const SampleTable& table) {
    double largest = 0;
    for (const SampleTable::Row& row : table.samples) {
        for (const double value : row.values) largest = std::max(largest, value);
    }
    return largest;
}

/// By the table's unit: nothing that is measured as 0 to 1 reaches 2, and no chart in percent stays
/// below.
void toReflectance(SampleTable& table, std::vector<std::string>& notes) {
    if (largestValue(table) < 2) return;
    for (SampleTable::Row& row : table.samples) {
        for (double& value : row.values) value /= 100;
    }
    notes.emplace_back("samples: values are taken as percent");
}

/// Linear between the table's wavelengths, flat beyond them.
double valueAt(const std::vector<double>& wavelengths, const std::vector<double>& values,
               double nm) {
    const auto above = std::ranges::lower_bound(wavelengths, nm);
    if (above == wavelengths.begin()) return values.front();
    if (above == wavelengths.end()) return values.back();
    const std::size_t i = std::size_t(above - wavelengths.begin());
    const double f = (nm - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
    return values[i - 1] + f * (values[i] - values[i - 1]);  // equal ones stay
}

/// In [0, 1]; `held` is set if that changed anything. Throws ArgumentError if it would be too much.
MeasuredSample sampleOf(const SampleTable& table, const SampleTable::Row& row, bool& held) {
    constexpr double most = 0.05;
    MeasuredSample sample{row.name, {}, ""};
    for (std::size_t m = 0; m < sample.reflectance.size(); ++m) {
        const double nm = double(wavelength(int(m)));
        const double value = valueAt(table.wavelengths, row.values, nm);
        const double inside = std::clamp(value, 0.0, 1.0);
        if (!(std::abs(value - inside) <= most)) {  // so that NaN is refused
            throw ArgumentError("the sample '" + row.name + "' is " + std::to_string(value) +
                                " at " + whole(nm) + " nm: no reflectance");
        }
        held = held || value != inside;
        sample.reflectance[m] = inside;
    }
    return sample;
}

void noteRange(const SampleTable& table, std::vector<std::string>& notes) {
    const double first = table.wavelengths.front(), last = table.wavelengths.back();
    if (first <= kFirstWavelength && last >= wavelength(kBandCount - 1)) return;
    notes.push_back("samples reach from " + whole(first) + " to " + whole(last) +
                    " nm: extended flat beyond");
}

MeasuredFile measuredFile(SampleTable table) {
    MeasuredFile file;
    toReflectance(table, file.notes);
    noteRange(table, file.notes);
    std::size_t held = 0;
    for (const SampleTable::Row& row : table.samples) {
        bool changed = false;
        file.samples.push_back(sampleOf(table, row, changed));
        held += std::size_t(changed);
    }
    if (held > 0) {
        file.notes.push_back(std::to_string(held) + " samples leave [0, 1] a little: held there");
    }
    return file;
}

}  // namespace

MeasuredFile readMeasuredFile(const std::string& path) {
    const std::string text = contentOf(path);
    try {
        return measuredFile(parseSampleTable(text));
    } catch (const ArgumentError& error) {
        throw FileError(path, error.what());
    }
}

}  // namespace specbake
