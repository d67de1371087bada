#pragma once

#include <OpenEXR/openexr.h>

#include <memory>
#include <string>

namespace specbake::internal {

/// The first four bytes of an EXR (OpenEXR file layout): 20000630 in little-endian order.
inline constexpr const char* kExrSignature = "\x76\x2f\x31\x01";

/// An OpenEXRCore file being read.
class ExrInput {
  public:
    /// Not open if the file is no EXR, its header is damaged or a side is beyond kLargestSide.
    explicit ExrInput(std::string path);

    bool isOpen() const { return context_ != nullptr; }
    exr_const_context_t get() const { return context_.get(); }

    /// Throws FileError if a call of the library failed.
    void check(exr_result_t result) const;

    /// Of the first part.
    exr_compression_t compression() const;

  private:
    struct Finish {
        void operator()(_priv_exr_context_t* context) const { exr_finish(&context); }
    };
    std::string path_;
    std::unique_ptr<_priv_exr_context_t, Finish> context_;
};

}  // namespace specbake::internal
