// A host has threads and settings of its own: a bake leaves them as they are.
#include <specbake/bake/bake.h>
#include <specbake/bake/relight.h>
#include <specbake/bake/verify.h>
#include <specbake/image/memory_texture.h>

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <random>
#include <thread>

using namespace specbake;

namespace {

const std::string kImages = std::string(SPECBAKE_SOURCE_DIR) + "/testimages/";

/// What a library could change of its host.
struct Settings {
    std::size_t parallelism =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    int openImageIOThreads = OIIO::get_int_attribute("threads");
    int exrThreads = OIIO::get_int_attribute("exr_threads");
    bool operator==(const Settings&) const = default;
};

/// An image of noise that notes how many threads TBB lets work beside the one that reads it. (Not
/// how many come: TBB may exchange the workers of an arena, but never lets in more than its limit.)
class Noise : public Texture {
  public:
    Noise() {
        info_.path = "noise";
        info_.data = info_.display = {0, 0, 256, 512};
        info_.channels = 3;
        info_.sampleType = TexelType::uint8;
        info_.color.space = *findColorSpace("srgb");
    }
    const TextureInfo& info() const override { return info_; }
    void readRows(int first, int count, std::span<std::byte> samples) override {
        const int limit = tbb::this_task_arena::max_concurrency();
        int most = threads_;
        while (limit > most && !threads_.compare_exchange_weak(most, limit)) {
        }
        const std::size_t rowBytes = info_.bytesPerRow();
        for (int row = 0; row < count; ++row) {
            std::mt19937 random{unsigned(first + row)};
            const auto bytes = samples.subspan(rowBytes * std::size_t(row), rowBytes);
            for (std::byte& byte : bytes) byte = std::byte(random());
        }
    }
    int threads() const { return threads_; }

  private:
    TextureInfo info_;
    std::atomic<int> threads_ = 0;
};

struct Bake {
    std::vector<std::byte> samples;
    int threads = 0;

    explicit Bake(int count) {
        Noise noise;
        BakeOptions options;
        options.threads = count;
        bake(noise,
             {.begin = {},
              .row =
                  [this](int, std::span<const std::byte> row) {
                      samples.insert(samples.end(), row.begin(), row.end());
                  }},
             options);
        threads = noise.threads();
    }
};

}  // namespace

TEST_CASE("settings of the host are as they were, while the libraries work and after") {
    // As a host may have it: more threads than cores, and OpenImageIO with two.
    const tbb::global_control own(tbb::global_control::max_allowed_parallelism, 5);
    OIIO::attribute("threads", 2);
    const Settings before;
    REQUIRE(before.parallelism == 5);
    const auto folder =
        std::filesystem::temp_directory_path() / ("specbake-host-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const std::string spectral = (folder / "s.exr").string();
    int changes = 0;
    const auto look = [&](double) { changes += Settings() != before; };
    // TIFF is read by OpenImageIO.
    BakeOptions options;
    options.threads = 3;
    options.progress = look;
    bake(kImages + "rgb8.tif", spectral, options);
    VerifyOptions check;
    check.threads = 2;
    static_cast<void>(verify(spectral, kImages + "rgb8.tif", check));
    RelightOptions relit;
    relit.threads = 1;
    relit.progress = look;
    relight(spectral, folder / "p.png", relit);
    CHECK(changes == 0);
    CHECK(Settings() == before);
    std::filesystem::remove_all(folder);
}

TEST_CASE("bakes with different numbers of threads do not disturb each other") {
    const tbb::global_control own(tbb::global_control::max_allowed_parallelism, 8);
    const Bake alone(2);
    std::map<int, std::unique_ptr<Bake>> bakes;
    {
        std::mutex mutex;
        std::vector<std::jthread> hosts;
        for (const int count : {1, 2, 4}) {
            hosts.emplace_back([&, count] {
                auto done = std::make_unique<Bake>(count);
                const std::lock_guard lock(mutex);
                bakes[count] = std::move(done);
            });
        }
    }
    for (const auto& [count, done] : bakes) {
        CAPTURE(count);
        CHECK(done->samples == alone.samples);
        CHECK(done->threads == count);
    }
}
