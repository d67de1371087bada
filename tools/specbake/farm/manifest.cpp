#include "farm/manifest.h"

#include "batch/side_by_side.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <fmt/format.h>

#include <fstream>
#include <numeric>
#include <optional>
#include <string>
#include <system_error>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

/// So many headers are read at once: it is waiting for a file server that takes the time.
constexpr int kReaders = 16;

/// FNV-1a of the textures' names and of what is read of them.
std::uint64_t listHash(std::span<const BatchItem> items, const ReadOptions& read) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    const auto add = [&](const std::string& text) {
        for (const char c : text + '\n') {
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
        }
    };
    for (const BatchItem& item : items) add(item.input.path);
    add(read.part.value_or(""));
    return hash;
}

std::string headOf(std::size_t items) {
    return fmt::format("specbake sizes 1: pixels of {} textures", items);
}

/// Nothing if there is no such file, or none of as many.
std::optional<std::vector<std::uint64_t>> readSizes(const fs::path& file, std::size_t items) {
    std::ifstream in(file);
    std::string head;
    if (!std::getline(in, head) || head != headOf(items)) return {};
    std::vector<std::uint64_t> sizes(items);
    for (std::uint64_t& size : sizes) in >> size;
    if (!in) return {};
    return sizes;
}

std::uint64_t pixelsOf(const std::string& path, const ReadOptions& read) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return 0;
    try {
        const Window window = TextureReader(path, read).info().data;
        return std::uint64_t(window.width) * std::uint64_t(window.height);
    } catch (const std::exception&) {
        return 0;  // the bake tells why
    }
}

std::vector<std::uint64_t> measuredSizes(std::span<const BatchItem> items,
                                         const ReadOptions& read) {
    std::vector<std::size_t> all(items.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<std::uint64_t> sizes(items.size());
    sideBySide(all, kReaders,
               [&](std::size_t i) { sizes[i] = pixelsOf(items[i].input.path, read); });
    return sizes;
}

/// The first to come has it: a link is made or not made, on NFS too, where a lock may be no lock.
void publish(const fs::path& path, std::span<const std::uint64_t> sizes) {
    OutputFile file(path);
    std::ofstream out(file.temporaryPath());
    out << headOf(sizes.size()) << '\n';
    for (const std::uint64_t size : sizes) out << size << '\n';
    out.close();
    if (!out) throw FileError(path.string(), "cannot be written");
    std::error_code error;
    fs::create_hard_link(file.temporaryPath(), path, error);
    // Where there are no links, or what is there is no such file, the last to come has it.
    if (error && !readSizes(path, sizes.size())) file.commit();
}

}  // namespace

std::vector<std::uint64_t> sharedSizes(std::span<const BatchItem> items, const ReadOptions& read,
                                       const fs::path& folder) {
    const fs::path path = folder / fmt::format("sizes-{:016x}.txt", listHash(items, read));
    if (auto known = readSizes(path, items.size())) return std::move(*known);
    std::vector<std::uint64_t> sizes = measuredSizes(items, read);
    publish(path, sizes);
    if (auto first = readSizes(path, items.size())) return std::move(*first);
    throw FileError(path.string(), "it was written, and cannot be read");
}

}  // namespace specbake::tool
