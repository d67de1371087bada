/// sampler_bench TABLE.spectab IMAGE [RGB2SPEC.so TABLE.coeff]: nanoseconds a lookup takes, from
/// linear RGB to reflectance at 1, 4, 8 and 16 wavelengths, one thread, for random colours and for
/// those of an image in the order of its texels; beside rgb2spec (W. Jakob, J. Hanika 2019), which
/// Mitsuba 3 and pbrt use, if its functions are given as a shared library.
///
/// All take turns on the same colours, so that what else the machine does falls on all alike;
/// medians are printed, and their ratios; then the errors that the table names, for readers of both
/// quadratures.
#include <specbake/image/texel_decoder.h>
#include <specbake/image/texture_reader.h>
#include <specbake/sampler.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace specbake::bench {
namespace {

using Colors = std::vector<std::array<float, 3>>;
constexpr std::size_t kColors = 1 << 16;
constexpr int kRounds = 31;

Colors randomColors() {
    std::mt19937 random(1);
    Colors colors(kColors);
    for (auto& color : colors) {
        for (float& c : color) c = float(linearFromSRGB(double(random() % 256) / 255));
    }
    return colors;
}

/// The first texels of an image, row by row.
Colors texelsOf(const std::string& path) {
    TextureReader reader(path);
    const TextureInfo& info = reader.info();
    const TexelDecoder decoder(info, info.color);
    const auto width = std::size_t(info.data.width);
    std::vector<std::byte> row(info.bytesPerRow());
    std::vector<float> alpha(width);
    Colors colors;
    for (int y = 0; y < info.data.height && colors.size() < kColors; ++y) {
        reader.readRows(y, 1, row);
        colors.resize(colors.size() + width);
        decoder.decode(row, width, &colors[colors.size() - width], alpha.data());
    }
    return colors;
}

/// The wavelengths of a light path, as renderers draw them: one at random, the others spaced
/// evenly.
template <std::size_t N>
std::array<float, N> heroWavelengths() {
    std::array<float, N> nm;
    for (std::size_t i = 0; i < N; ++i) nm[i] = 390.7F + 390.0F / float(N) * float(i);
    return nm;
}

/// A pass over all colours; what is returned depends on every result, lest any be left out.
using Pass = std::function<float(const Colors&)>;

template <std::size_t N>
Pass tablePass(const SpectralTable& table) {
    return [&table](const Colors& colors) {
        const auto at = table.wavelengths<N>(heroWavelengths<N>());
        std::array<float, N> reflectance;
        float sum = 0;
        for (const auto& c : colors) {
            table.eval(table.locate(c[0], c[1], c[2]), at, reflectance.data());
            for (const float r : reflectance) sum += r;
        }
        return sum;
    };
}

/// rgb2spec's functions, as its header declares them. They are called by scalar wavelengths: its
/// vector functions are there only in builds for processors that have them.
struct Rgb2Spec {
    void* model = nullptr;
    void (*fetch)(void* model, float* rgb, float* coefficients) = nullptr;
    float (*evalPrecise)(float* coefficients, float wavelength) = nullptr;
    float (*evalFast)(float* coefficients, float wavelength) = nullptr;
#if defined(__SSE4_2__)
    __m128 (*evalFour)(float* coefficients, __m128 wavelengths) = nullptr;
#endif
};

template <class Function>
void load(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
}

Rgb2Spec loadRgb2Spec(const char* library, const char* table) {
    void* handle = dlopen(library, RTLD_NOW);
    if (handle == nullptr) throw std::runtime_error(dlerror());
    void* (*loadModel)(const char*) = nullptr;
    Rgb2Spec loaded;
    load(handle, "rgb2spec_load", loadModel);
    load(handle, "rgb2spec_fetch", loaded.fetch);
    load(handle, "rgb2spec_eval_precise", loaded.evalPrecise);
    load(handle, "rgb2spec_eval_fast", loaded.evalFast);
#if defined(__SSE4_2__)
    load(handle, "rgb2spec_eval_sse", loaded.evalFour);
#endif
    if (loadModel == nullptr || loaded.fetch == nullptr || loaded.evalPrecise == nullptr) {
        throw std::runtime_error(std::string(library) + ": is not rgb2spec");
    }
    loaded.model = loadModel(table);
    if (loaded.model == nullptr) throw std::runtime_error(std::string(table) + ": not its table");
    return loaded;
}

template <std::size_t N>
Pass rgb2SpecPass(const Rgb2Spec& rgb2spec) {
    return [&rgb2spec](const Colors& colors) {
        const auto nm = heroWavelengths<N>();
        float sum = 0;
        for (auto c : colors) {
            std::array<float, 3> coefficients;
            rgb2spec.fetch(rgb2spec.model, c.data(), coefficients.data());
            std::size_t i = 0;
#if defined(__SSE4_2__)
            if (rgb2spec.evalFour != nullptr) {
                for (; i + 4 <= N; i += 4) {
                    std::array<float, 4> four;
                    _mm_storeu_ps(four.data(),
                                  rgb2spec.evalFour(coefficients.data(), _mm_loadu_ps(&nm[i])));
                    for (const float r : four) sum += r;
                }
            }
#endif
            for (; i < N; ++i) sum += rgb2spec.evalPrecise(coefficients.data(), nm[i]);
        }
        return sum;
    };
}

double nanoseconds(const Pass& pass, const Colors& colors) {
    const auto start = std::chrono::steady_clock::now();
    volatile float sink = pass(colors);
    static_cast<void>(sink);
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    return taken.count() / double(colors.size());
}

/// Of each pass, the median of rounds in which all take turns.
std::vector<double> medians(const std::vector<Pass>& passes, const Colors& colors) {
    std::vector<std::vector<double>> times(passes.size());
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t p = 0; p < passes.size(); ++p) {
            times[p].push_back(nanoseconds(passes[p], colors));
        }
    }
    std::vector<double> middle;
    for (auto& t : times) {
        std::nth_element(t.begin(), t.begin() + kRounds / 2, t.end());
        middle.push_back(t[kRounds / 2]);
    }
    return middle;
}

template <std::size_t N>
void printRow(const char* kind, const Colors& colors, const SpectralTable& table,
              const Rgb2Spec& rgb2spec) {
    std::vector<Pass> passes = {tablePass<N>(table)};
    if (rgb2spec.model != nullptr) passes.push_back(rgb2SpecPass<N>(rgb2spec));
    const std::vector<double> ns = medians(passes, colors);
    fmt::print("| {} | {} | {:.1f} |", kind, N, ns[0]);
    if (ns.size() > 1) fmt::print(" {:.1f} | {:.2f} |", ns[1], ns[0] / ns[1]);
    fmt::print("\n");
}

std::vector<char> contentsOf(const char* path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(std::string(path) + ": cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// What the table says of its own errors, for either reader.
void printErrors(const SpectralTable& table) {
    std::istringstream text(std::string(table.text(), table.header().textBytes));
    fmt::print("\n| CIEDE2000 of the table | mean, 99th percentile, largest |\n|---|---|\n");
    for (std::string line; std::getline(text, line);) {
        const auto sign = line.find('=');
        if (!line.starts_with("de2000_") || sign == std::string::npos) continue;
        fmt::print("| {} | {} |\n", line.substr(0, sign), line.substr(sign + 1));
    }
}

void run(const char* tablePath, const char* image, const Rgb2Spec& rgb2spec) {
    const std::vector<char> bytes = contentsOf(tablePath);
    SpectralTable table;
    if (table.view(bytes.data(), bytes.size()) != SpectralTable::Status::ok) {
        throw std::runtime_error(std::string(tablePath) + ": no table of spectra");
    }
    const bool both = rgb2spec.model != nullptr;
    fmt::print("| colours | wavelengths | specbake, ns |{}\n",
               both ? " rgb2spec, ns | ratio |" : "");
    fmt::print("|---|---|---|{}\n", both ? "---|---|" : "");
    for (const auto& [kind, colors] :
         {std::pair{"random", randomColors()}, std::pair{"an image's", texelsOf(image)}}) {
        printRow<1>(kind, colors, table, rgb2spec);
        printRow<4>(kind, colors, table, rgb2spec);
        printRow<8>(kind, colors, table, rgb2spec);
        printRow<16>(kind, colors, table, rgb2spec);
    }
    printErrors(table);
}

}  // namespace
}  // namespace specbake::bench

int main(int argc, char** argv) {
    using namespace specbake::bench;
    if (argc != 3 && argc != 5) {
        std::fprintf(stderr,
                     "usage: sampler_bench TABLE.spectab IMAGE [RGB2SPEC.so TABLE.coeff]\n");
        return 2;
    }
    try {
        run(argv[1], argv[2], argc == 5 ? loadRgb2Spec(argv[3], argv[4]) : Rgb2Spec());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sampler_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
