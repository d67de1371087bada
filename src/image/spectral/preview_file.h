#pragma once

#include <span>

namespace specbake::internal {

/// What stands behind a PreviewWriter: see there for what the functions do.
class PreviewFile {
  public:
    PreviewFile() = default;
    virtual ~PreviewFile() = default;
    PreviewFile(const PreviewFile&) = delete;
    PreviewFile& operator=(const PreviewFile&) = delete;

    virtual void writeRow(std::span<const float> rgba) = 0;
    /// When all is written. Throws FileError.
    virtual void close() = 0;
};

}  // namespace specbake::internal
