#include "target.h"

#include <specbake/image/spectral_reader.h>
#include <specbake/image/spectral_writer.h>

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

namespace specbake::fuzz {
namespace {

/// Numbers out of the fuzzer's bytes; 0 where there are no more.
class Numbers {
  public:
    explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    int below(int end) { return int(next()) % end; }
    std::uint8_t next() {
        if (bytes_.empty()) return 0;
        const std::uint8_t first = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return first;
    }

  private:
    std::span<const std::uint8_t> bytes_;
};

/// Any samples, the same at each place of the file whatever its chunks.
std::byte sampleByte(std::size_t at, std::uint8_t seed) {
    return std::byte((at * 131 + seed) >> (seed % 5));
}

}  // namespace

/// Any file that the writer takes is read back, with the samples that it was given.
void run(std::span<const std::uint8_t> bytes) {
    Numbers numbers(bytes);
    SpectralHeader header;
    header.data = {numbers.below(9) - 4, numbers.below(9) - 4, 1 + numbers.below(40),
                   1 + numbers.below(40)};
    header.display = {0, 0, 1 + numbers.below(40), 1 + numbers.below(40)};
    header.alpha = numbers.below(2) == 1;
    StorageOptions storage;
    storage.sampleType = SampleType::float32;
    storage.compression = compressions()[std::size_t(numbers.below(int(compressions().size())))];
    storage.level = 1 + numbers.below(StorageOptions::kHighestLevel);
    if (numbers.below(2) == 1) storage.tile = {1 + numbers.below(40), 1 + numbers.below(40)};
    const std::uint8_t seed = numbers.next();
    static const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("fuzz." + std::to_string(getpid()) + ".exr");
    SpectralWriter writer(path, header, storage);
    for (int chunk = 0; chunk < writer.chunkCount(); ++chunk) {
        std::vector<std::byte> samples(writer.chunkBytes(chunk));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            // Floats with an exponent that is finite.
            samples[i] = i % 4 == 3 ? std::byte{0x3f} : sampleByte(i, seed);
        }
        writer.write(chunk, writer.pack(chunk, samples));
    }
    writer.commit();
    SpectralReader reader(path.string());
    expect(reader.header().data == header.data);
    std::vector<float> row(std::size_t(header.data.width) * reader.wavelengths().size());
    for (int y = 0; y < header.data.height; ++y) {
        reader.readRows(y, 1, row);
        for (const float value : row) expect(std::isfinite(value) && value > 0);
    }
    std::filesystem::remove(path);
}

}  // namespace specbake::fuzz
