#pragma once

#include <specbake/image/spectral_layout.h>

#include <OpenEXR/openexr.h>

#include <filesystem>
#include <string>

namespace specbake {

/// An OpenEXRCore file being written: one part, its header written by the constructor.
class ExrContext {
  public:
    /// `file` is written, `shownAs` is what errors call it.
    ExrContext(const std::filesystem::path& file, std::string shownAs, const SpectralHeader& header,
               const StorageOptions& storage);
    ~ExrContext();
    ExrContext(const ExrContext&) = delete;
    ExrContext& operator=(const ExrContext&) = delete;

    exr_context_t get() const { return context_; }

    /// Throws FileError if a call of the library failed.
    void check(exr_result_t result) const;

    /// Writes what remains and closes the file.
    void finish();

  private:
    std::string shownAs_;
    exr_context_t context_ = nullptr;
};

}  // namespace specbake
