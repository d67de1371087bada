#include "help/wrapped_text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace specbake::tool {
namespace {

bool beginsCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::size_t columnsOf(const std::string& word) {
    return std::size_t(std::count_if(word.begin(), word.end(), beginsCharacter));
}

/// The bytes of the first `columns` characters.
std::size_t bytesOf(const std::string& word, std::size_t columns) {
    std::size_t at = 0;
    for (std::size_t seen = 0; at < word.size(); ++at) {
        if (beginsCharacter(word[at]) && seen++ == columns) break;
    }
    return at;
}

std::size_t columnsOfTerminal() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    const char* columns = std::getenv("COLUMNS");
    const long number = columns == nullptr ? 0 : std::strtol(columns, nullptr, 10);
    return number > 0 ? std::size_t(number) : 80;
}

}  // namespace

std::size_t textWidth() {
    return std::clamp<std::size_t>(columnsOfTerminal(), 40, 100);
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t first,
                    std::size_t indent) {
    std::string lines;
    std::size_t column = first;
    bool begun = false;  // whether the line has a word
    const auto next = [&] {
        lines += '\n' + std::string(indent, ' ');
        column = indent;
        begun = false;
    };
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        if (begun && column + 1 + columnsOf(word) > width) next();
        if (!begun && column > indent && column + columnsOf(word) > width) next();
        while (!begun && column + columnsOf(word) > width) {
            const std::size_t part = bytesOf(word, width - column);
            lines += word.substr(0, part);
            word.erase(0, part);
            next();
        }
        lines += (begun ? " " : "") + word;
        column += columnsOf(word) + (begun ? 1 : 0);
        begun = true;
    }
    return lines;
}

}  // namespace specbake::tool
