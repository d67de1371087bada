#include "support/same_image.h"

#include "texture/openimageio/openimageio_file.h"

#include <doctest/doctest.h>

namespace specbake::testing {

using namespace internal;

namespace {

std::string listed(const Attributes& attributes) {
    std::string list;
    for (const auto& [name, value] : attributes) {
        list += name + " = ";
        if (const auto* text = std::get_if<std::string>(&value)) list += *text;
        if (const auto* number = std::get_if<int>(&value)) list += std::to_string(*number);
        if (const auto* number = std::get_if<float>(&value)) list += std::to_string(*number);
        list += "; ";
    }
    return list;
}

}  // namespace

std::vector<std::byte> rowsOf(ImageFile& file, int first, int count) {
    const ImageDescription& d = file.description();
    std::vector<std::byte> rows(std::size_t(count) * std::size_t(d.data.width) * d.channels.size() *
                                bytesPerSample(d.sampleType));
    file.readRows(first, count, d.sampleType, rows);
    return rows;
}

std::vector<std::byte> allOf(ImageFile& file) {
    return rowsOf(file, 0, file.description().data.height);
}

void checkSameAsOpenImageIO(ImageFile& file, const std::string& path) {
    const auto oracle = openWithOpenImageIO(path);
    const ImageDescription& ours = file.description();
    const ImageDescription& theirs = oracle->description();
    CHECK(ours.data == theirs.data);
    CHECK(ours.display == theirs.display);
    CHECK(ours.pixelAspectRatio == theirs.pixelAspectRatio);
    CHECK(ours.channels == theirs.channels);
    CHECK(ours.alpha == theirs.alpha);
    CHECK(ours.associatedAlpha == theirs.associatedAlpha);
    CHECK(ours.sampleType == theirs.sampleType);
    CHECK(ours.orientation == theirs.orientation);
    CHECK(ours.signs == theirs.signs);
    INFO(listed(ours.attributes), " and ", listed(theirs.attributes));
    CHECK(ours.attributes == theirs.attributes);
    CHECK(ours.notes == theirs.notes);
    CHECK(allOf(file) == allOf(*oracle));
    for (const char* name : {"DateTime", "Software", "specbake:illuminant", "compression"}) {
        if (file.text(name)) CHECK(file.text(name) == oracle->text(name));
    }
}

}  // namespace specbake::testing
