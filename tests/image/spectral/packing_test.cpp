#include <specbake/core/error.h>
#include <specbake/image/spectral_writer.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfTiledInputFile.h>
#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

using namespace specbake;

namespace {

/// A file of samples that look like a spectral texture's: a few colours, smooth along the planes.
/// Each of its levels holds the corner of the one image.
class PackedFile {
  public:
    PackedFile(const Window& window, const StorageOptions& storage, bool alpha)
        : path_(std::filesystem::temp_directory_path() /
                ("specbake-packing-" + std::to_string(getpid()) + ".exr")),
          width_(std::size_t(window.width)),
          rows_(std::size_t(window.height)),
          names_(channelNames(alpha)),
          sampleBytes_(bytesPerSample(storage.sampleType)),
          bytes_(rows_ * names_.size() * width_ * sampleBytes_) {
        fill();
        SpectralHeader header;
        header.data = header.display = window;
        header.alpha = alpha;
        SpectralWriter writer(path_, header, storage);
        const std::vector<ChunkGrid>& levels = writer.levels();
        for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
            for (int i = 0; i < level->count(); ++i) {
                const int chunk = level->firstChunk + i;
                writer.write(chunk, writer.pack(chunk, samplesOf(level->texels(chunk))));
            }
        }
        writer.commit();
    }
    ~PackedFile() { std::filesystem::remove(path_); }
    PackedFile(const PackedFile&) = delete;
    PackedFile& operator=(const PackedFile&) = delete;

    std::string path() const { return path_.string(); }
    const std::vector<std::string>& names() const { return names_; }
    std::size_t sampleBytes() const { return sampleBytes_; }
    /// A channel's sample as it was given to the writer.
    const std::byte* sample(std::size_t row, std::size_t channel, std::size_t x) const {
        return bytes_.data() + ((row * names_.size() + channel) * width_ + x) * sampleBytes_;
    }

  private:
    void fill() {
        std::mt19937 random(5);
        std::vector<unsigned> colors(rows_ * width_);
        for (unsigned& color : colors) color = unsigned(random() % 6);
        std::size_t at = 0;
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t c = 0; c < names_.size(); ++c) {
                for (std::size_t x = 0; x < width_; ++x, at += sampleBytes_) {
                    const float phase = float(colors[row * width_ + x]) + float(c) / 20;
                    store(0.5F + 0.5F * std::sin(phase), bytes_.data() + at);
                }
            }
        }
    }
    /// A rectangle's samples: row by row, channel by channel.
    std::vector<std::byte> samplesOf(const Window& texels) const {
        std::vector<std::byte> samples;
        for (int row = 0; row < texels.height; ++row) {
            for (std::size_t c = 0; c < names_.size(); ++c) {
                const auto* first = sample(std::size_t(texels.y + row), c, std::size_t(texels.x));
                const std::size_t bytes = std::size_t(texels.width) * sampleBytes_;
                samples.insert(samples.end(), first, first + bytes);
            }
        }
        return samples;
    }
    void store(float value, std::byte* to) const {
        const Imath::half narrow = value;
        sampleBytes_ == 2 ? std::memcpy(to, &narrow, 2) : std::memcpy(to, &value, 4);
    }

    std::filesystem::path path_;
    std::size_t width_, rows_;
    std::vector<std::string> names_;
    std::size_t sampleBytes_;
    std::vector<std::byte> bytes_;
};

/// Bytes that OpenEXR's C++ classes read, row by row, channel by channel.
std::vector<std::byte> readByOpenEXR(const PackedFile& file, const Window& window) {
    Imf::InputFile input(file.path().c_str());
    const std::size_t plane = std::size_t(window.width) * file.sampleBytes();
    const std::size_t row = plane * file.names().size();
    std::vector<std::byte> bytes(row * std::size_t(window.height));
    const auto type = file.sampleBytes() == 2 ? Imf::HALF : Imf::FLOAT;
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < file.names().size(); ++c) {
        REQUIRE(input.header().channels()[file.names()[c].c_str()].type == type);
        auto* base = reinterpret_cast<char*>(bytes.data() + c * plane) -
                     std::ptrdiff_t(window.y) * std::ptrdiff_t(row) -
                     std::ptrdiff_t(window.x) * std::ptrdiff_t(file.sampleBytes());
        frame.insert(file.names()[c].c_str(), Imf::Slice(type, base, file.sampleBytes(), row));
    }
    input.setFrameBuffer(frame);
    input.readPixels(window.y, window.y + window.height - 1);
    return bytes;
}

int differencesByOpenEXR(const PackedFile& file, const Window& window) {
    const auto bytes = readByOpenEXR(file, window);
    return std::memcmp(bytes.data(), file.sample(0, 0, 0), bytes.size());
}

int differencesByOpenImageIO(const PackedFile& file, const Window& window) {
    const auto input = OIIO::ImageInput::open(file.path());
    REQUIRE(input);
    const OIIO::ImageSpec& spec = input->spec();
    REQUIRE(spec.nchannels == int(file.names().size()));
    const auto channels = file.names().size();
    std::vector<std::byte> pixels(spec.image_bytes(true));
    REQUIRE(input->read_image(0, 0, 0, spec.nchannels, spec.format, pixels.data()));
    int differences = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        const auto theirs = std::size_t(spec.channelindex(file.names()[c]));
        for (std::size_t i = 0; i < std::size_t(window.width * window.height); ++i) {
            const auto width = std::size_t(window.width);
            differences +=
                std::memcmp(pixels.data() + (i * channels + theirs) * file.sampleBytes(),
                            file.sample(i / width, c, i % width), file.sampleBytes()) != 0;
        }
    }
    return differences;
}

/// One level as OpenEXR's C++ classes read it from the tiles: differing samples.
int differencesInLevel(Imf::TiledInputFile& input, const PackedFile& file, int level) {
    const Imath::Box2i box = input.dataWindowForLevel(level);
    const auto width = std::size_t(input.levelWidth(level));
    const auto height = std::size_t(input.levelHeight(level));
    const std::size_t bytes = file.sampleBytes();
    const std::size_t row = width * bytes;
    const std::size_t plane = row * height;
    std::vector<char> planes(plane * file.names().size());
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < file.names().size(); ++c) {
        char* base = planes.data() + c * plane - std::ptrdiff_t(box.min.y) * std::ptrdiff_t(row) -
                     std::ptrdiff_t(box.min.x) * std::ptrdiff_t(bytes);
        frame.insert(file.names()[c].c_str(),
                     Imf::Slice(bytes == 2 ? Imf::HALF : Imf::FLOAT, base, bytes, row));
    }
    input.setFrameBuffer(frame);
    input.readTiles(0, input.numXTiles(level) - 1, 0, input.numYTiles(level) - 1, level);
    int differences = 0;
    for (std::size_t c = 0; c < file.names().size(); ++c) {
        for (std::size_t y = 0; y < height; ++y) {
            const char* read = &planes[c * plane + y * row];
            differences += std::memcmp(read, file.sample(y, c, 0), row) != 0;
        }
    }
    return differences;
}

struct Packing {
    Compression compression;
    int level;
};

}  // namespace

TEST_CASE("OpenEXR and OpenImageIO read every packing back, bit for bit") {
    const std::vector<Window> windows = {
        {0, 0, 1, 1}, {-3, 5, 37, 33}, {0, 0, 64, 16}, {2, -7, 129, 19}, {0, 0, 2, 70}};
    const std::vector<Packing> packings = {
        {Compression::none, 3}, {Compression::zip, 1},  {Compression::zip, 2},
        {Compression::zip, 3},  {Compression::zip, 6},  {Compression::zips, 1},
        {Compression::zips, 3}, {Compression::zips, 6}, {Compression::piz, 3}};
    for (const Window& window : windows) {
        for (const auto& [compression, level] : packings) {
            for (const SampleType type : {SampleType::half, SampleType::float32}) {
                const bool alpha = (window.width + level) % 2 == 0;
                const PackedFile file(window, {type, compression, level}, alpha);
                CAPTURE(window.width);
                CAPTURE(int(compression));
                CAPTURE(level);
                CAPTURE(alpha);
                CHECK(differencesByOpenEXR(file, window) == 0);
                CHECK(differencesByOpenImageIO(file, window) == 0);
            }
        }
    }
}

TEST_CASE("tiles of every level are read back, bit for bit") {
    const std::vector<std::pair<Window, TileSize>> cuts = {{{0, 0, 1, 1}, {64, 64}},
                                                           {{-3, 5, 37, 33}, {16, 8}},
                                                           {{2, -7, 129, 19}, {17, 5}},
                                                           {{0, 0, 2, 30}, {1, 3}}};
    for (const auto& [window, tile] : cuts) {
        for (const Compression compression :
             {Compression::none, Compression::zip, Compression::zips, Compression::piz}) {
            for (const bool mipmap : {false, true}) {
                const auto type = tile.width % 2 == 0 ? SampleType::half : SampleType::float32;
                const StorageOptions storage{type, compression, 3, tile, mipmap};
                const PackedFile file(window, storage, window.width % 2 == 0);
                CAPTURE(window.width);
                CAPTURE(int(compression));
                CAPTURE(mipmap);
                CHECK(differencesByOpenEXR(file, window) == 0);
                CHECK(differencesByOpenImageIO(file, window) == 0);
                Imf::TiledInputFile input(file.path().c_str());
                const double largest = std::max(window.width, window.height);
                REQUIRE(input.numLevels() == (mipmap ? 1 + int(std::log2(largest)) : 1));
                CHECK(int(input.tileXSize()) == tile.width);
                CHECK(int(input.tileYSize()) == tile.height);
                for (int level = 0; level < input.numLevels(); ++level) {
                    CHECK(differencesInLevel(input, file, level) == 0);
                }
            }
        }
    }
}

TEST_CASE("impossible tiles are refused") {
    for (const TileSize& tile : {TileSize{0, 8}, {8, -1}, {1025, 8}, {8, 1 << 30}}) {
        const StorageOptions storage{SampleType::half, Compression::zip, 3, tile};
        CHECK_THROWS_AS(PackedFile({0, 0, 4, 4}, storage, false), ArgumentError);
    }
    // 4/3 of 2³⁰ tiles can be numbered by 31 bits, 2³¹ cannot.
    StorageOptions storage{SampleType::half, Compression::zip, 3, TileSize{4, 4}, true};
    CHECK(chunkGrids(kLargestSide, kLargestSide, storage).size() == 18);
    storage.tile = TileSize{2, 4};
    CHECK_THROWS_AS(chunkGrids(kLargestSide, kLargestSide, storage), ArgumentError);
}

TEST_CASE("rows longer than deflate's window are packed and read back") {
    const Window window = {0, 0, 33'000, 2};
    for (const SampleType type : {SampleType::half, SampleType::float32}) {
        const PackedFile file(window, {type, Compression::zip, 3}, false);
        CHECK(differencesByOpenEXR(file, window) == 0);
    }
}

TEST_CASE("a chunk of scan lines takes 64 MiB at most, unless one row is longer") {
    for (const SampleType type : {SampleType::half, SampleType::float32}) {
        for (int width = 1; width <= 1 << 20; width = width * 3 / 2 + 1) {
            CAPTURE(width);
            SpectralHeader header;
            header.data = {0, 0, width, 16};
            header.alpha = width % 2 == 0;
            StorageOptions storage;
            storage.sampleType = type;
            const Compression used = withBoundedChunks(storage, header).compression;
            const std::size_t row =
                std::size_t(width) * (header.alpha ? 85 : 84) * (type == SampleType::half ? 2 : 4);
            CHECK((used == Compression::zip) == (16 * row <= 64 << 20));
            CHECK((used == Compression::zip || used == Compression::zips));
            for (const Compression other : {Compression::none, Compression::piz}) {
                storage.compression = other;
                CHECK(withBoundedChunks(storage, header).compression == other);
            }
        }
    }
}
