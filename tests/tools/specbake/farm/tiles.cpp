#include "farm/tiles.h"

#include "support/png_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace specbake::testing {

Tiles::Tiles(const std::vector<std::pair<int, int>>& sides) {
    std::filesystem::create_directory(scratch.path("in"));
    std::string list;
    for (const auto& [width, height] : sides) {
        list += name(pixels.size()) + '\n';
        write(pixels.size(), width, height);
        pixels.push_back(std::uint64_t(width) * std::uint64_t(height));
    }
    writeFile(scratch.path("list.txt"), list);
}

std::string Tiles::name(std::size_t tile) const {
    return scratch.path("in/" + std::to_string(tile) + ".png");
}

std::string Tiles::result(std::size_t tile) const {
    return out + '/' + std::to_string(tile) + ".exr";
}

void Tiles::write(std::size_t tile, int width, int height) const {
    PngFile png;
    png.width = std::uint32_t(width);
    png.height = std::uint32_t(height);
    std::string rows;
    for (int y = 0; y < height; ++y)
        rows += '\0' + std::string(std::size_t(width) * 3, char(90 + y));
    png.packed = zlibStream(rows);
    writeFile(name(tile), png.contents());
}

std::vector<std::string> Tiles::words(const std::string& command,
                                      const std::vector<std::string>& options) const {
    std::vector<std::string> words = {command, "@" + scratch.path("list.txt"), "-o", out};
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

SetVariable::SetVariable(std::string name, const std::string& value) : name_(std::move(name)) {
    setenv(name_.c_str(), value.c_str(), 1);
}

SetVariable::~SetVariable() {
    unsetenv(name_.c_str());
}

std::vector<std::pair<std::size_t, std::string>> throughOf(const Tiles& tiles,
                                                           const std::string& stats) {
    std::vector<std::pair<std::size_t, std::string>> through;
    for (const std::string& line : linesOf(stats)) {
        const auto json = nlohmann::json::parse(line);
        for (std::size_t i = 0; i < tiles.pixels.size(); ++i) {
            if (json.at("input") == tiles.name(i)) through.emplace_back(i, json.at("status"));
        }
    }
    std::sort(through.begin(), through.end());
    return through;
}

}  // namespace specbake::testing
