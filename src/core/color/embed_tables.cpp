// Build step: turns the CSV tables of data/ into one C++ source file (see tables.h).
//
//     embed_tables CMF.csv ILLUMINANTS.csv REFLECTANCES.csv FINE_CMF.csv ILLUMINANT_ENDS.csv
//     FINE_CMF_10.csv OUT.cpp
#include <cstdint>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Row = std::vector<std::string>;

std::vector<Row> readCsv(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path + ": cannot be read");
    std::vector<Row> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        Row row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        rows.push_back(row);
    }
    return rows;
}

std::vector<Row> readBands(const std::string& path) {
    std::vector<Row> rows = readCsv(path);
    if (rows.size() != 82) throw std::runtime_error(path + ": a heading and 81 rows expected");
    return rows;
}

/// A printed decimal, with or without exponent, as an exact multiple of 1e-10.
std::int64_t exactTenBillionths(const std::string& text) {
    const auto e = text.find_first_of("eE");
    const std::string mantissa = text.substr(0, e);
    int shift = 10 + (e == std::string::npos ? 0 : std::stoi(text.substr(e + 1)));
    std::int64_t value = 0;
    bool fraction = false;
    for (const char c : mantissa) {
        if (c == '.') {
            fraction = true;
            continue;
        }
        value = 10 * value + (c - '0');
        if (fraction) --shift;
    }
    if (shift < 0) throw std::runtime_error(text + ": more than ten decimals");
    for (; shift > 0; --shift) value *= 10;
    return value;
}

/// Every `step`th row from `first` on.
void writeMatching(const std::vector<Row>& cmf, const std::string& name, std::size_t first,
                   std::size_t step, std::ostream& out) {
    out << "const BandMatching " << name << " = {{\n";
    for (std::size_t band = 0; band < 81; ++band) {
        const Row& row = cmf.at(first + band * step);
        out << "    {" << exactTenBillionths(row.at(1)) << ", " << exactTenBillionths(row.at(2))
            << ", " << exactTenBillionths(row.at(3)) << "},\n";
    }
    out << "}};\n\n";
}

void writeTables(const std::vector<Row>& light, std::ostream& out) {
    out << "const std::vector<IlluminantTable> illuminants = {\n";
    for (std::size_t column = 1; column < light[0].size(); ++column) {
        out << "    {\"" << light[0][column] << "\", {";
        for (std::size_t i = 1; i < light.size(); ++i) out << light[i].at(column) << ", ";
        out << "}},\n";
    }
    out << "};\n\n";
}

/// Rows of set, name, material, and 81 integers.
void writeReflectances(const std::vector<Row>& rows, std::ostream& out) {
    out << "static constexpr ReflectanceTable kRows[] = {\n";
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Row& row = rows[i];
        if (row.size() != 84) throw std::runtime_error(row.at(0) + ": a row of 84 cells expected");
        out << "    {\"" << row[0] << "\", \"" << row[1] << "\", \"" << row[2] << "\", {";
        for (std::size_t cell = 3; cell < row.size(); ++cell) out << row[cell] << ", ";
        out << "}},\n";
    }
    out << "};\nconst std::span<const ReflectanceTable> kReflectances = kRows;\n\n";
}

std::vector<Row> readFine(const std::string& path) {
    std::vector<Row> rows = readCsv(path);
    if (rows.size() != 472) throw std::runtime_error(path + ": 360 to 830 nm every 1 nm expected");
    return rows;
}

void writeFineTable(const std::vector<Row>& cmf, const std::string& name, std::ostream& out) {
    out << "const FineMatching " << name << " = {{\n";
    for (std::size_t i = 1; i < cmf.size(); ++i) {
        out << "    {" << cmf[i].at(1) << ", " << cmf[i].at(2) << ", " << cmf[i].at(3) << "},\n";
    }
    out << "}};\n\n";
}

/// Rows of 360 to 375 nm, then of 785 to 830 nm.
void writeEnds(const std::vector<Row>& light, std::ostream& out) {
    if (light.size() != 15) throw std::runtime_error("a heading and 14 rows of ends expected");
    const auto value = [](const std::string& cell) { return cell.empty() ? "NAN" : cell; };
    out << "const std::vector<IlluminantEnds> kIlluminantEnds = {\n";
    for (std::size_t column = 1; column < light[0].size(); ++column) {
        out << "    {\"" << light[0][column] << "\", {";
        for (std::size_t i = 1; i < light.size(); ++i) {
            out << value(light[i].at(column)) << (i == 4 ? "}, {" : ", ");
        }
        out << "}},\n";
    }
    out << "};\n\n";
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 8) {
        throw std::runtime_error(
            "usage: embed_tables CMF LIGHTS REFLECTANCES FINE_CMF ENDS FINE_CMF_10 OUT");
    }
    std::ofstream out(argv[7]);
    out << "// Made from data/*.csv by embed_tables.\n#include \"color/tables.h\"\n\n#include "
           "<cmath>\n\n"
        << "namespace specbake::internal::tables {\n\n";
    writeMatching(readBands(argv[1]), "colorMatching", 1, 1, out);
    writeTables(readBands(argv[2]), out);
    writeReflectances(readCsv(argv[3]), out);
    writeFineTable(readFine(argv[4]), "kFineColorMatching", out);
    writeEnds(readCsv(argv[5]), out);
    const std::vector<Row> wide = readFine(argv[6]);
    writeMatching(wide, "kWideColorMatching", 21, 5, out);  // from 380 nm
    writeFineTable(wide, "kFineWideColorMatching", out);
    out << "}  // namespace specbake::internal::tables\n";
    return out ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "embed_tables: " << error.what() << '\n';
    return 1;
}
