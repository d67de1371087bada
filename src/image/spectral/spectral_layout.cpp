#include <specbake/image/spectral_layout.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace specbake {

std::string bandChannelName(double nm) {
    const long long millionths = std::llround(nm * 1e6);
    const std::string decimals = std::to_string(millionths % 1'000'000);
    return "T." + std::to_string(millionths / 1'000'000) + ',' +
           std::string(6 - decimals.size(), '0') + decimals + "nm";
}

std::optional<double> bandWavelength(std::string_view channelName) {
    if (!channelName.starts_with("T.") || !channelName.ends_with("nm")) return {};
    std::string number(channelName.substr(2, channelName.size() - 4));
    const auto comma = number.find(',');
    if (comma == std::string::npos || number.find('.') != std::string::npos) return {};
    number[comma] = '.';
    double value = 0;
    const char* end = number.data() + number.size();
    const auto result = std::from_chars(number.data(), end, value, std::chars_format::fixed);
    if (result.ec != std::errc() || result.ptr != end || !(value > 0)) return {};
    return value;
}

std::span<const Compression> compressions() {
    static constexpr std::array all = {Compression::zip, Compression::zips, Compression::piz,
                                       Compression::none};
    return all;
}

std::string_view compressionName(Compression compression) {
    switch (compression) {
        case Compression::zip:
            return "zip";
        case Compression::zips:
            return "zips";
        case Compression::piz:
            return "piz";
        case Compression::none:
            break;
    }
    return "none";
}

StorageOptions withBoundedChunks(const StorageOptions& storage, const SpectralHeader& header) {
    StorageOptions bounded = storage;
    if (storage.compression != Compression::zip || storage.isTiled()) return bounded;
    constexpr std::size_t most = std::size_t(1) << 26;  // bytes
    const std::size_t rowBytes = std::size_t(header.data.width) *
                                 channelNames(header.alpha, header.bands).size() *
                                 bytesPerSample(storage.sampleType);
    if (rowBytes > most / std::size_t(rowsPerChunk(storage.compression))) {
        bounded.compression = Compression::zips;
    }
    return bounded;
}

std::vector<std::string> channelNames(bool alpha, const Wavelengths& bands) {
    std::vector<std::string> names = {"B", "G", "R"};
    if (alpha) names.insert(names.begin(), "A");
    for (int band = 0; band < bands.count; ++band) names.push_back(bandChannelName(bands.at(band)));
    return names;
}

}  // namespace specbake
