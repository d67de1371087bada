#pragma once

#include "texture/image_file.h"

#include <specbake/core/error.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace specbake::internal {

/// An image that its library reads from the top only: asked for a row above, it begins anew. A
/// Decoder is made from a path, stands before the first row, and has
///
///     const ImageDescription& description() const;
///     void readRow(std::byte* samples);  // of the file's own type; throws FileError
template <class Decoder>
class SequentialFile : public ImageFile {
  public:
    SequentialFile(std::string path, std::unique_ptr<Decoder> decoder)
        : ImageFile(decoder->description()),
          path_(std::move(path)),
          decoder_(std::move(decoder)),
          skipped_(rowBytes(description().sampleType)) {}
    /// With another description of the same pixels.
    SequentialFile(std::string path, std::unique_ptr<Decoder> decoder,
                   ImageDescription itsDescription)
        : ImageFile(std::move(itsDescription)),
          path_(std::move(path)),
          decoder_(std::move(decoder)),
          skipped_(rowBytes(description().sampleType)) {}

    std::optional<std::string> text(const std::string& attribute) const override {
        const auto found = description().attributes.find(attribute);
        if (found == description().attributes.end()) return {};
        const auto* text = std::get_if<std::string>(&found->second);
        return text == nullptr ? std::optional<std::string>() : *text;
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override {
        if (type != description().sampleType) throw ArgumentError("samples of another type");
        if (first < nextRow_) {
            decoder_ = std::make_unique<Decoder>(path_);
            nextRow_ = 0;
        }
        for (; nextRow_ < first; ++nextRow_) decoder_->readRow(skipped_.data());
        for (int row = 0; row < count; ++row, ++nextRow_) {
            decoder_->readRow(samples.data() + std::size_t(row) * skipped_.size());
        }
    }

    std::string path_;
    std::unique_ptr<Decoder> decoder_;
    std::vector<std::byte> skipped_;  ///< a row that nobody asked for
    int nextRow_ = 0;
};

}  // namespace specbake::internal
