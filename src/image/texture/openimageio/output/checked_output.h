#pragma once

#include "file/write_stream.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <string>

namespace specbake::internal {

/// A file that an ImageOutput writes through us, so that no error of the disk is lost: most formats
/// of OpenImageIO 2.4.7 do not ask whether their bytes were written. Those that write nowhere but
/// into files of their own write into memory first.
class CheckedOutput {
  public:
    /// Into `file`, which is there and empty.
    explicit CheckedOutput(const std::filesystem::path& file);
    ~CheckedOutput();
    CheckedOutput(const CheckedOutput&) = delete;
    CheckedOutput& operator=(const CheckedOutput&) = delete;

    /// False if the output says so.
    bool open(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec);

    /// Once the output is closed: false if anything of it did not get into the file.
    bool close();

    /// The system's word on what went wrong first; empty if nothing did.
    std::string error() const { return stream_.error(); }

  private:
    /// What an ImageOutput takes for a file.
    class Proxy : public OIIO::Filesystem::IOProxy {
      public:
        Proxy(WriteStream& stream, bool& empty)
            : IOProxy("", Mode::Write), stream_(stream), empty_(empty) {}

        const char* proxytype() const override { return "specbake"; }
        std::size_t size() const override { return size_; }
        std::size_t write(const void* bytes, std::size_t count) override;
        std::size_t pwrite(const void* bytes, std::size_t count, std::int64_t offset) override;

      private:
        WriteStream& stream_;
        bool& empty_;
        std::size_t size_ = 0;
    };

    bool isCut() const;
    bool copyMemory();

    WriteStream stream_;
    bool empty_ = true;  ///< no byte was written yet: OpenImageIO 2.4.7 writes no JPEG 2000 at all
    Proxy proxy_{stream_, empty_};
    int memory_ = -1;  ///< the descriptor of a file without a disk, or none
};

}  // namespace specbake::internal
