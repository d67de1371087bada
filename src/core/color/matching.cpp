#include "color/matching.h"

#include "color/names.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

constexpr double kCoarsestStep = 10;  // nm
constexpr std::size_t kMostRows = 10'000;
/// Below 2^35 units, as the integers of generators.h need it.
constexpr double kLargestValue = 3;

constexpr std::string_view kWideObserver = "CIE 1964 10 degree";

/// A table of one's own, evenly spaced.
struct OwnTable {
    double first = 0, step = 0;  ///< nm
    std::vector<Imath::V3d> rows;

    /// Linear between rows; 0 beyond them, where no table is needed.
    Imath::V3d at(double nm) const {
        const double place = (nm - first) / step;
        const double last = double(rows.size() - 1);
        if (place < -1e-9 || place > last + 1e-9) return Imath::V3d(0.0);
        const double below = std::clamp(std::floor(place + 1e-9), 0.0, last);
        const double share = place - below;
        const auto row = std::size_t(below);
        if (share < 1e-9 || row + 1 == rows.size()) return rows[row];
        return rows[row] * (1 - share) + rows[row + 1] * share;
    }
};

void check(std::span<const MatchingSample> table) {
    if (table.size() < 2) throw ArgumentError("a table of fewer than two rows");
    if (table.size() > kMostRows) throw ArgumentError("a table of too many rows");
    const double step =
        (table.back().wavelength - table.front().wavelength) / double(table.size() - 1);
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto& [nm, value] = table[i];
        if (!(step > 0) || !(std::abs(nm - table.front().wavelength - step * double(i)) < 1e-6)) {
            throw ArgumentError("wavelengths of colour-matching functions ascend evenly");
        }
        for (int c = 0; c < 3; ++c) {
            if (!(value[c] >= 0 && value[c] <= kLargestValue)) {
                throw ArgumentError("colour-matching functions of X, Y and Z are from 0 to 3");
            }
        }
        sum += value;
    }
    if (!(step <= kCoarsestStep + 1e-6)) {
        throw ArgumentError("colour-matching functions are wanted every 10 nm at least");
    }
    if (table.front().wavelength > 400 || table.back().wavelength < 700) {
        throw ArgumentError("colour-matching functions reach from 400 nm or less to 700 or more");
    }
    if (!(sum.x > 0 && sum.y > 0 && sum.z > 0)) {
        throw ArgumentError("a colour-matching function that is 0 everywhere");
    }
}

/// To 1e-10: ten decimals are kept exactly.
tables::BandMatching bandsOf(const OwnTable& table) {
    tables::BandMatching bands{};
    for (int m = 0; m < kBandCount; ++m) {
        const Imath::V3d value = table.at(wavelength(m));
        for (int c = 0; c < 3; ++c) {
            bands[std::size_t(m)][std::size_t(c)] =
                std::llround(value[c] * tables::kMatchingUnitsPerOne);
        }
    }
    return bands;
}

tables::FineMatching fineOf(const OwnTable& table) {
    tables::FineMatching fine{};
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const Imath::V3d value = table.at(kFinestFirst + double(i));
        fine[i] = {value.x, value.y, value.z};
    }
    return fine;
}

const std::array<std::shared_ptr<const ColorMatching>, 2>& offered() {
    static const std::array all = {
        std::make_shared<const ColorMatching>(ColorMatching{
            std::string(kUsualObserver), tables::colorMatching, tables::kFineColorMatching}),
        std::make_shared<const ColorMatching>(ColorMatching{std::string(kWideObserver),
                                                            tables::kWideColorMatching,
                                                            tables::kFineWideColorMatching})};
    return all;
}

/// The next number of a text, if there is one.
std::optional<double> nextNumber(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == ':')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return {};
    text.remove_prefix(std::size_t(end - text.data()));
    return value;
}

/// What follows the label. Nothing for other text.
std::optional<OwnTable> parsed(std::string_view text) {
    const auto first = nextNumber(text);
    const auto last = nextNumber(text);
    const auto step = nextNumber(text);
    if (!first || !last || !step || !(*step > 0)) return {};
    std::vector<MatchingSample> rows;
    while (!text.empty() && rows.size() <= kMostRows) {
        Imath::V3d value(0.0);
        for (int c = 0; c < 3; ++c) {
            const auto number = nextNumber(text);
            if (!number) return {};
            value[c] = *number;
        }
        rows.push_back({*first + *step * double(rows.size()), value});
    }
    try {
        check(rows);
    } catch (const ArgumentError&) {
        return {};
    }
    if (std::abs(rows.back().wavelength - *last) > 1e-6) return {};
    OwnTable table{*first, *step, {}};
    for (const MatchingSample& row : rows) table.rows.push_back(row.value);
    return table;
}

/// "2" and "10", the names, and these with the step of their tables.
std::shared_ptr<const ColorMatching> findOffered(std::string_view text) {
    const std::string name = lowerCase(text);
    const std::array<std::string_view, 2> angles = {"2", "10"};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const std::string full = lowerCase(offered().at(i)->name);
        const bool known = name == angles.at(i) || name == full || name == full + ", 5 nm" ||
                           name == full + ", 1 nm";
        if (known) return offered().at(i);
    }
    return nullptr;
}

}  // namespace

std::shared_ptr<const ColorMatching> internal::matchingNamed(std::string_view text) {
    if (auto known = findOffered(text)) return known;
    const std::string_view label = observerLabel(text);
    if (label != text) {
        if (const auto table = parsed(text.substr(label.size() + 1))) {
            return std::make_shared<const ColorMatching>(
                ColorMatching{std::string(text), bandsOf(*table), fineOf(*table)});
        }
    }
    throw ArgumentError("unknown observer '" + std::string(label) +
                        "': 2 and 10 are known, for the CIE's of 2 and 10 degrees");
}

const std::vector<std::string>& observerNames() {
    static const std::vector<std::string> names = {offered()[0]->name, offered()[1]->name};
    return names;
}

bool isObserver(std::string_view observer, std::string* reason) {
    try {
        static_cast<void>(matchingNamed(observer));
        return true;
    } catch (const ArgumentError& error) {
        if (reason != nullptr) *reason = error.what();
        return false;
    }
}

std::string observerText(std::string_view label, std::span<const MatchingSample> table) {
    check(table);
    const double first = table.front().wavelength;
    const double last = table.back().wavelength;
    OwnTable own{first, (last - first) / double(table.size() - 1), {}};
    for (const MatchingSample& row : table) own.rows.push_back(row.value);
    const tables::BandMatching bands = bandsOf(own);
    for (const auto& known : offered()) {
        if (known->bands == bands) return known->name;
    }
    std::string text(label);
    for (char& c : text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    text += ": " + decimal(first) + ':' + decimal(last) + ':' + decimal(own.step);
    for (const Imath::V3d& value : own.rows) {
        for (int c = 0; c < 3; ++c) text += ' ' + decimal(value[c]);
    }
    return text;
}

std::string_view observerLabel(std::string_view observer) {
    return lightLabel(observer);
}

}  // namespace specbake
