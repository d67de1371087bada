#include "file/text_table.h"

#include <specbake/core/error.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace specbake::internal {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t(1) << 24;  // bytes

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

std::string textOfTable(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw FileError(path, "no such file");
    if (std::filesystem::file_size(path, ignored) > kLargestFile) {
        throw FileError(path, "too long for a table");
    }
    std::ifstream in(path);
    std::ostringstream all;
    all << in.rdbuf();
    if (!in) throw FileError(path, "cannot be read");
    return all.str();
}

std::vector<double> numbersIn(const std::string& line) {
    std::vector<double> numbers;
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at != end) {
        const bool begins = isDigit(*at) || ((*at == '-' || *at == '.') && at + 1 != end &&
                                             (isDigit(at[1]) || at[1] == '.'));
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (begins && error == std::errc()) {
            numbers.push_back(value);
            at = next;
        } else {
            ++at;
        }
    }
    return numbers;
}

std::vector<std::vector<double>> rowsOfTable(const std::string& text, std::size_t columns,
                                             std::size_t most) {
    std::vector<std::vector<double>> rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line) && rows.size() < most;) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        std::vector<double> numbers = numbersIn(line);
        constexpr double shortest = 200;
        constexpr double longest = 3000;  // nm: no head of a table
        if (numbers.size() != columns || numbers[0] < shortest || numbers[0] > longest) continue;
        rows.push_back(std::move(numbers));
    }
    return rows;
}

}  // namespace specbake::internal
