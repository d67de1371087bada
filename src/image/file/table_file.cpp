#include <specbake/core/error.h>
#include <specbake/image/table_file.h>

#include <cstdint>
#include <fstream>
#include <ios>
#include <sstream>
#include <system_error>

namespace specbake {
namespace {

const char* reasonOf(SpectralTable::Status status) {
    switch (status) {
        case SpectralTable::Status::ok:
            return "";
        case SpectralTable::Status::truncated:
            return "it ends too early";
        case SpectralTable::Status::notATable:
            return "no table of spectra";
        case SpectralTable::Status::otherVersion:
            return "a table of another version";
        case SpectralTable::Status::badSizes:
            return "its sizes contradict each other";
        case SpectralTable::Status::bigEndianHost:
            break;
    }
    return "tables are read by little-endian machines only";
}

/// More than the largest table: hostile files may be of any size.
constexpr std::uintmax_t kMostBytes = std::uintmax_t(8) << 30;

}  // namespace

TableFile::TableFile(std::string name, std::vector<std::byte> bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
    const SpectralTable::Status status = view_.view(bytes_.data(), bytes_.size());
    if (status != SpectralTable::Status::ok) throw FileError(name_, reasonOf(status));
}

TableFile TableFile::read(const std::filesystem::path& path) {
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(path, missing);
    if (missing) throw FileError(path.string(), missing.message());
    if (size > kMostBytes) throw FileError(path.string(), "larger than any table");
    std::vector<std::byte> bytes(size);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    if (!stream) throw FileError(path.string(), "cannot be read whole");
    TableFile table(path.string(), std::move(bytes));
    if (!table.view().intact()) throw FileError(path.string(), "its checksum does not agree");
    return table;
}

Wavelengths TableFile::bands() const {
    const SpectralTableHeader& h = view_.header();
    return {double(h.firstWavelength), double(h.wavelengthStep), int(h.bands)};
}

std::vector<std::pair<std::string, std::string>> TableFile::facts() const {
    std::vector<std::pair<std::string, std::string>> all;
    std::istringstream lines(std::string(view_.text(), std::size_t(view_.header().textBytes)));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equal = line.find('=');
        if (equal != std::string::npos)
            all.emplace_back(line.substr(0, equal), line.substr(equal + 1));
    }
    return all;
}

std::optional<std::string> TableFile::fact(std::string_view name) const {
    for (auto& [known, value] : facts()) {
        if (known == name) return std::move(value);
    }
    return {};
}

}  // namespace specbake
