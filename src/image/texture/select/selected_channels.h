#pragma once

#include "texture/image_file.h"
#include "texture/select/channel_choice.h"

namespace specbake::internal {

/// Some channels of a file, in another order, under their names without a layer's.
class SelectedChannels : public ImageFile {
  public:
    SelectedChannels(std::unique_ptr<ImageFile> file, const ChannelChoice& choice);

    std::optional<std::string> text(const std::string& attribute) const override {
        return file_->text(attribute);
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override;

    std::unique_ptr<ImageFile> file_;
    std::vector<int> channels_;
    std::vector<std::byte> row_;  ///< with all the channels of the file
};

/// The file with those channels: the file itself if they are all of them, in its order.
std::unique_ptr<ImageFile> withChannels(std::unique_ptr<ImageFile> file,
                                        const ChannelChoice& choice);

}  // namespace specbake::internal
