#pragma once

#include <specbake/core/api.h>
#include <specbake/image/spectral_sink.h>

#include <filesystem>
#include <memory>

namespace specbake {

/// Writes one spectral EXR.
///
///     SpectralWriter writer(path, header, storage);
///     for (int chunk = 0; chunk < writer.chunkCount(); ++chunk)
///         writer.write(chunk, writer.pack(chunk, samples));
///     writer.commit();
///
/// The file appears at commit(), whole; without it nothing stays behind.
class SPECBAKE_API SpectralWriter : public SpectralSink {
  public:
    /// Throws FileError if the file cannot be created, ArgumentError for a wrong option.
    SpectralWriter(const std::filesystem::path& path, const SpectralHeader& header,
                   const StorageOptions& storage);
    ~SpectralWriter() override;

    void write(int chunk, std::span<const std::byte> packed) override;

    /// Completes the file and puts it in its place. Throws FileError.
    void commit();

  private:
    void packInPlace(int chunk, std::vector<std::byte>& samples) const override;

    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
