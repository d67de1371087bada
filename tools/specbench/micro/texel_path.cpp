/// How fast linear colours become samples, one thread, beside two things that write as much: memset
/// and the product with three fixed spectra (three multiply-adds a sample). Items are texels. Runs
/// are interleaved and repeated, since what else runs on the machine changes them all: speed.py
/// takes the medians' ratios.
#include <specbake/core/upsampler.h>

#include <benchmark/benchmark.h>

#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace specbake {
namespace {

using Color = Upsampler::Color;

constexpr std::size_t kWidth = 2048;
constexpr std::size_t kRows = 128;  ///< more samples than caches hold
constexpr std::size_t kSamples = kRows * kWidth * kTexelSamples;

enum class Colors { random, coherent };

/// 8-bit sRGB colours: anywhere in the cube, or a slow ramp with a dither of one code, so that
/// most neighbours differ and yet lie in one tetrahedron.
std::vector<Color> makeColors(Colors kind) {
    std::mt19937 random(1);
    std::vector<Color> colors(kWidth * kRows);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto ramp = unsigned(i % kWidth * 16 / kWidth + 64 * c + 30 + random() % 2);
            const unsigned code = kind == Colors::random ? unsigned(random() % 256) : ramp;
            colors[i][c] = float(linearFromSRGB(double(code) / 255));
        }
    }
    return colors;
}

/// Cache-line aligned memory, touched, so that the timing meets no page fault.
class Planes {
  public:
    explicit Planes(std::size_t bytes)
        : bytes_(bytes), memory_(new (std::align_val_t(64)) std::byte[bytes]) {
        std::memset(memory_.get(), 1, bytes);
    }
    std::byte* data() { return memory_.get(); }
    std::size_t size() const { return bytes_; }

  private:
    struct Free {
        void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t(64)); }
    };
    std::size_t bytes_;
    std::unique_ptr<std::byte[], Free> memory_;
};

void countTexels(benchmark::State& state) {
    state.SetItemsProcessed(std::int64_t(state.iterations()) * std::int64_t(kWidth * kRows));
}

void memsetPlanes(benchmark::State& state, std::size_t sampleBytes) {
    Planes planes(kSamples * sampleBytes);
    for (auto _ : state) {
        std::memset(planes.data(), 2, planes.size());
        benchmark::ClobberMemory();
    }
    countTexels(state);
}

void threePrimaries(benchmark::State& state, Colors kind) {
    const std::vector<Color> colors = makeColors(kind);
    Planes planes(kSamples * sizeof(float));
    std::array<std::array<float, kTexelSamples>, 3> basis;
    for (auto& b : basis) b.fill(0.3F);
    std::vector<float> red(kWidth), green(kWidth), blue(kWidth);
    for (auto _ : state) {
        auto* out = reinterpret_cast<float*>(planes.data());
        for (std::size_t y = 0; y < kRows; ++y) {
            for (std::size_t x = 0; x < kWidth; ++x) {
                const Color& color = colors[y * kWidth + x];
                red[x] = color[0], green[x] = color[1], blue[x] = color[2];
            }
            for (std::size_t p = 0; p < kTexelSamples; ++p, out += kWidth) {
                for (std::size_t x = 0; x < kWidth; ++x) {
                    out[x] = basis[0][p] * red[x] + basis[1][p] * green[x] + basis[2][p] * blue[x];
                }
            }
        }
        benchmark::ClobberMemory();
    }
    countTexels(state);
}

/// The model of sRGB textures with its nodes solved.
const Upsampler& upsampler() {
    static const Upsampler made = [] {
        Upsampler solved(*findColorSpace("lin_rec709"));
        solved.solveNodes();
        return solved;
    }();
    return made;
}

void texelPath(benchmark::State& state, Colors kind, SampleType type) {
    const std::vector<Color> colors = makeColors(kind);
    const std::size_t stride = kWidth * bytesPerSample(type);
    Planes planes(kRows * kTexelSamples * stride);
    const SampleSelection channels = SampleSelection::channels();
    Upsampler::Workspace workspace;
    for (auto _ : state) {
        for (std::size_t y = 0; y < kRows; ++y) {
            const auto target =
                SampleTarget::planar(type, planes.data() + y * kTexelSamples * stride, stride);
            benchmark::DoNotOptimize(upsampler().sample(
                std::span(colors).subspan(y * kWidth, kWidth), channels, target, workspace));
        }
        benchmark::ClobberMemory();
    }
    countTexels(state);
}

BENCHMARK_CAPTURE(memsetPlanes, float, sizeof(float));
BENCHMARK_CAPTURE(memsetPlanes, half, std::size_t(2));
BENCHMARK_CAPTURE(threePrimaries, float, Colors::random);
BENCHMARK_CAPTURE(texelPath, random_float, Colors::random, SampleType::float32);
BENCHMARK_CAPTURE(texelPath, coherent_float, Colors::coherent, SampleType::float32);
BENCHMARK_CAPTURE(texelPath, random_half, Colors::random, SampleType::half);
BENCHMARK_CAPTURE(texelPath, coherent_half, Colors::coherent, SampleType::half);

int run(int argc, char** argv) {
    std::vector<std::string> arguments = {argv[0], "--benchmark_enable_random_interleaving=true",
                                          "--benchmark_repetitions=9", "--benchmark_min_time=0.1",
                                          "--benchmark_report_aggregates_only=true"};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    int count = int(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}  // namespace
}  // namespace specbake

int main(int argc, char** argv) {
    return specbake::run(argc, argv);
}
