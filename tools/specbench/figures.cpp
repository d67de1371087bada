#include "figures.h"

#include <specbake/core/error.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace specbake::bench {
namespace {

/// The processor as the system names it, "" where it does not say.
std::string processorName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    }
    return "";
}

std::ofstream create(const std::string& path) {
    std::ofstream out(path);
    if (!out) throw FileError(path, "cannot be written");
    return out;
}

void finish(std::ofstream& out, const std::string& path) {
    out.flush();
    if (!out) throw FileError(path, "cannot be written");
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : "";
}

std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

Figures::Figures(std::string name, std::string command)
    : name_(std::move(name)), command_(std::move(command)) {}

void Figures::addSpectrum(const std::string& set, const MethodName& method,
                          const Spectrum& spectrum) {
    for (int m = 0; m < kBandCount; ++m) {
        add({set, method, "reflectance", spectrum[std::size_t(m)], "1", double(wavelength(m)),
             "nm"});
    }
}

void Figures::write(const std::string& folder) const {
    std::error_code ignored;  // what matters is whether the files can be created
    std::filesystem::create_directories(folder, ignored);
    const std::string csvPath = folder + "/" + name_ + ".csv";
    std::ofstream csv = create(csvPath);
    fmt::print(csv, "# {}\n# {}\nset,family,parameters,quantity,value,unit,at,at_unit\n", command_,
               processorName());
    nlohmann::json rows = nlohmann::json::array();
    for (const Figure& f : figures_) {
        fmt::print(csv, "{},{},{},{},{},{},{},{}\n", quoted(f.set), quoted(f.method.family),
                   quoted(f.method.parameters), quoted(f.quantity), number(f.value), f.unit,
                   f.at ? number(*f.at) : "", f.atUnit);
        rows.push_back({{"set", f.set},
                        {"family", f.method.family},
                        {"parameters", f.method.parameters},
                        {"quantity", f.quantity},
                        {"value", f.value},
                        {"unit", f.unit}});
        if (f.at) rows.back().update({{"at", *f.at}, {"at_unit", f.atUnit}});
    }
    finish(csv, csvPath);
    const std::string jsonPath = folder + "/" + name_ + ".json";
    std::ofstream json = create(jsonPath);
    json << nlohmann::json{{"command", command_}, {"processor", processorName()}, {"figures", rows}}
                .dump(1);
    finish(json, jsonPath);
}

}  // namespace specbake::bench
