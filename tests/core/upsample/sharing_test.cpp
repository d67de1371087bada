#include <specbake/core/upsampler.h>
#include <specbake/image/spectral_writer.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <random>
#include <thread>

using namespace specbake;

namespace {

/// Calls `work(i)` on so many threads at once.
template <class Work>
void onThreads(int count, const Work& work) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < count; ++i) threads.emplace_back([&work, i] { work(i); });
}

using Color = Upsampler::Color;

UpsamplerOptions fiveNodes() {
    UpsamplerOptions options;
    options.grid = 5;
    return options;
}

std::vector<float> samplesOf(const Upsampler& upsampler, const Color& color) {
    return upsampler.sample({&color, 1}, SampleSelection::channels());
}

/// Of few colours, so that threads meet at the same nodes and the same slots of the cache: in the
/// cube, beyond its faces, outside the solid.
std::vector<Color> colors() {
    std::mt19937 random(12);
    std::uniform_real_distribution<float> channel(-0.05F, 1.05F);
    std::vector<Color> result(300);
    for (Color& color : result) color = {channel(random), channel(random), channel(random)};
    return result;
}

std::vector<std::byte> someSamples(std::size_t count, int seed) {
    std::vector<std::byte> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        samples[i] = std::byte(i % 2 == 0 ? i / 50 + std::size_t(seed) : 56);
    }
    return samples;
}

}  // namespace

TEST_CASE("threads that share a model find what one alone finds") {
    for (const char* name : {"lin_rec709", "acescg"}) {
        const std::vector<Color> all = colors();
        std::vector<std::vector<float>> expected;
        {
            const Upsampler alone(*findColorSpace(name), fiveNodes());
            for (const Color& color : all) expected.push_back(samplesOf(alone, color));
        }
        const Upsampler shared(*findColorSpace(name), fiveNodes());
        std::atomic<int> differences = 0;
        onThreads(6, [&](int thread) {
            std::vector<std::size_t> order(all.size());
            std::iota(order.begin(), order.end(), 0);
            // Two threads each go the same way, so that they meet where nothing is found yet.
            std::shuffle(order.begin(), order.end(), std::mt19937(unsigned(thread / 2)));
            for (const std::size_t i : order)
                differences += samplesOf(shared, all[i]) != expected[i];
        });
        CHECK(differences == 0);
    }
}

TEST_CASE("threads that share a writer pack what one alone packs") {
    const auto path = std::filesystem::temp_directory_path() /
                      ("specbake-sharing-" + std::to_string(getpid()) + ".exr");
    for (const Compression compression : {Compression::zip, Compression::piz}) {
        SpectralHeader header;
        header.data = header.display = {0, 0, 70, 130};
        StorageOptions storage;
        storage.compression = compression;
        SpectralWriter writer(path, header, storage);
        const int chunks = writer.chunkCount();
        REQUIRE(chunks > 4);
        const auto pack = [&writer](int chunk) {
            return writer.pack(chunk, someSamples(writer.chunkBytes(chunk), chunk));
        };
        std::vector<std::vector<std::byte>> expected;
        for (int chunk = 0; chunk < chunks; ++chunk) expected.push_back(pack(chunk));
        std::atomic<int> differences = 0;
        onThreads(4, [&](int thread) {
            for (int i = 0; i < chunks; ++i) {
                const int chunk = (i + thread) % chunks;
                differences += pack(chunk) != expected[std::size_t(chunk)];
            }
        });
        CHECK(differences == 0);
    }  // the writer, without commit(), leaves nothing behind
    CHECK_FALSE(std::filesystem::exists(path));
}
