#include "samples/sample_table.h"

#include <specbake/core/error.h>
#include <specbake/core/measured_sample.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace specbake::internal {
namespace {

constexpr double kLeastWavelength = 200;  // nm: smaller numbers are no wavelengths
constexpr double kMostWavelength = 5000;
constexpr std::size_t kMostCells = 10'000;  // of a line

using Cells = std::vector<std::string_view>;

struct Line {
    std::size_t number = 0;  ///< in the file, from 1
    Cells cells;
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view around = " \t\r\"'";
    const auto first = text.find_first_not_of(around);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(around) - first + 1);
}

/// With a decimal point, or, as spreadsheets of half of Europe have it, a decimal comma.
std::optional<double> number(std::string_view text) {
    constexpr std::size_t most = 64;  // characters
    if (text.size() > most) return {};
    std::string digits(text);
    std::ranges::replace(digits, ',', '.');
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) return {};
    return value;
}

bool isWavelength(std::optional<double> value) {
    return value && *value >= kLeastWavelength && *value <= kMostWavelength;
}

/// The number that a heading ends in: of "380", "380 nm", "SPECTRAL_NM380", "R_380.0"; not that of
/// "paint 380", which is a name.
std::optional<double> wavelengthIn(std::string_view heading) {
    if (heading.ends_with("nm")) heading = trimmed(heading.substr(0, heading.size() - 2));
    const auto last = heading.find_last_not_of("0123456789.");
    if (last != std::string_view::npos && heading[last] == ' ') return {};
    const auto value = number(last == std::string_view::npos ? heading : heading.substr(last + 1));
    return isWavelength(value) ? value : std::nullopt;
}

[[noreturn]] void fail(const Line& line, const std::string& reason) {
    throw ArgumentError("line " + std::to_string(line.number) + ": " + reason);
}

double valueOf(const Line& line, std::size_t cell) {
    if (cell >= line.cells.size()) fail(line, "fewer values than the heading has");
    const auto value = number(line.cells[cell]);
    if (!value) {
        std::string reason("no number: ");
        reason += line.cells[cell].substr(0, 40);
        fail(line, reason);
    }
    return *value;
}

/// Cells between any of the separators; of blanks, several are one. Without empty ones at the end.
Cells split(std::string_view text, std::string_view separators) {
    const bool blanks = separators.find(' ') != std::string_view::npos;
    Cells cells;
    std::size_t first = 0;
    while (first <= text.size()) {
        const bool quoted = first < text.size() && text[first] == '"';
        const auto close = quoted ? text.find('"', first + 1) : first;
        const auto end =
            std::min(text.find_first_of(separators, std::min(close, text.size())), text.size());
        const auto cell = trimmed(text.substr(first, end - first));
        if (!blanks || !cell.empty()) cells.push_back(cell);
        if (cells.size() > kMostCells) throw ArgumentError("a line of too many cells");
        first = end + 1;
    }
    while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
    return cells;
}

/// Lines that hold something; those that begin with # do not count.
std::vector<Line> linesOf(std::string_view text, std::string_view separators) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte-order mark
    std::vector<Line> lines;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        const auto line = text.substr(0, end);
        const auto next = text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
        text.remove_prefix(std::min(next, text.size()));
        if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
        lines.push_back({number, split(line, separators)});
    }
    if (lines.empty()) throw ArgumentError("no spectra");
    return lines;
}

/// The columns of a heading that are wavelengths, and those before the first, which are labels.
struct Columns {
    std::vector<std::size_t> labels, values;
};

Columns columnsOf(const Cells& heading) {
    Columns columns;
    for (std::size_t i = 0; i < heading.size(); ++i) {
        if (wavelengthIn(heading[i])) {
            columns.values.push_back(i);
        } else if (columns.values.empty()) {
            columns.labels.push_back(i);
        }
    }
    return columns;
}

/// Of a row's labels, those that are no numbers, or else the first.
std::string nameOf(const Line& line, const std::vector<std::size_t>& labels, std::size_t index) {
    constexpr std::size_t most = 80;  // characters of a label
    std::string name, first;
    for (const std::size_t label : labels) {
        if (label >= line.cells.size() || line.cells[label].empty()) continue;
        const std::string cell(line.cells[label].substr(0, most));
        if (first.empty()) first = cell;
        if (!number(cell)) name += (name.empty() ? "" : " ") + cell;
    }
    if (name.empty()) name = first;
    return name.empty() ? "sample " + std::to_string(index + 1) : name;
}

void checkCount(std::size_t samples) {
    if (samples <= kMostSamples) return;
    throw ArgumentError(std::to_string(samples) + " samples, of at most " +
                        std::to_string(kMostSamples));
}

SampleTable sampleARow(const Cells& heading, std::vector<Line>::const_iterator first,
                       std::vector<Line>::const_iterator last) {
    const Columns columns = columnsOf(heading);
    checkCount(std::size_t(last - first));
    SampleTable table;
    for (const std::size_t column : columns.values) {
        table.wavelengths.push_back(*wavelengthIn(heading[column]));
    }
    for (auto line = first; line != last; ++line) {
        SampleTable::Row& row = table.samples.emplace_back();
        row.name = nameOf(*line, columns.labels, table.samples.size() - 1);
        for (const std::size_t column : columns.values) {
            row.values.push_back(valueOf(*line, column));
        }
    }
    return table;
}

SampleTable wavelengthARow(const std::vector<Line>& lines) {
    const bool heading = !number(lines.front().cells.front());
    const std::size_t count = lines.front().cells.size() - 1;
    checkCount(count);
    SampleTable table;
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<std::size_t> label{i + 1};
        table.samples.push_back({nameOf(heading ? lines.front() : Line{}, label, i), {}});
    }
    for (std::size_t l = heading ? 1 : 0; l < lines.size(); ++l) {
        table.wavelengths.push_back(valueOf(lines[l], 0));
        for (std::size_t i = 0; i < count; ++i) {
            table.samples[i].values.push_back(valueOf(lines[l], i + 1));
        }
    }
    return table;
}

SampleTable cgats(std::string_view text) {
    const std::vector<Line> lines = linesOf(text, " \t");
    const auto at = [&](std::string_view word) {
        return std::ranges::find_if(lines, [&](const Line& l) { return l.cells.front() == word; });
    };
    const auto format = at("BEGIN_DATA_FORMAT"), formatEnd = at("END_DATA_FORMAT");
    const auto data = at("BEGIN_DATA"), dataEnd = at("END_DATA");
    if (!(format < formatEnd && formatEnd < data && data < dataEnd && dataEnd != lines.end())) {
        throw ArgumentError("CGATS without a format and data, each from BEGIN to END");
    }
    Cells fields;
    for (auto line = format + 1; line != formatEnd; ++line) {
        fields.insert(fields.end(), line->cells.begin(), line->cells.end());
    }
    return sampleARow(fields, data + 1, dataEnd);
}

/// Of the first line that holds something: semicolons or tabs if it has any, else commas.
std::string_view separatorsOf(std::string_view text) {
    const std::vector<Line> lines = linesOf(text, "\n");
    const std::string_view heading = lines.front().cells.front();
    for (const std::string_view separator : {";", "\t"}) {
        if (heading.find(separator) != std::string_view::npos) return separator;
    }
    return ",";
}

/// Wavelengths that descend are turned round.
void putInOrder(SampleTable& table) {
    if (table.wavelengths.empty() || table.wavelengths.front() <= table.wavelengths.back()) return;
    std::ranges::reverse(table.wavelengths);
    for (SampleTable::Row& row : table.samples) std::ranges::reverse(row.values);
}

void check(const SampleTable& table) {
    if (table.wavelengths.size() < 2 || table.samples.empty()) {
        throw ArgumentError("no spectra: neither columns nor rows are wavelengths");
    }
    for (std::size_t i = 0; i < table.wavelengths.size(); ++i) {
        if (!isWavelength(table.wavelengths[i])) {
            throw ArgumentError(std::to_string(table.wavelengths[i]) + " is no wavelength in nm");
        }
        if (i > 0 && !(table.wavelengths[i] > table.wavelengths[i - 1])) {
            throw ArgumentError("the wavelengths do not ascend");
        }
    }
}

/// Whether the heading says so: two columns or more are wavelengths, as numbers or, in a table
/// whose rows are not, in names.
bool isSampleARow(const std::vector<Line>& lines) {
    const Cells& heading = lines.front().cells;
    const auto plain = [](std::string_view cell) { return isWavelength(number(cell)); };
    if (columnsOf(heading).values.size() < 2) return false;
    if (std::ranges::count_if(heading, plain) >= 2) return true;
    const auto begins = [&](const Line& line) { return plain(line.cells.front()); };
    return !std::all_of(lines.begin() + 1, lines.end(), begins);
}

SampleTable tableOf(std::string_view text) {
    if (text.find("BEGIN_DATA_FORMAT") != std::string_view::npos) return cgats(text);
    const std::vector<Line> lines = linesOf(text, separatorsOf(text));
    if (!isSampleARow(lines)) return wavelengthARow(lines);
    return sampleARow(lines.front().cells, lines.begin() + 1, lines.end());
}

}  // namespace

SampleTable parseSampleTable(std::string_view text) {
    SampleTable table = tableOf(text);
    putInOrder(table);
    check(table);
    return table;
}

}  // namespace specbake::internal
