#pragma once

#include <specbake/core/api.h>
#include <specbake/core/wavelengths.h>
#include <specbake/sampler.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace specbake {

/// A table of spectra in memory (docs/table-format.md), and the view of it that renderers have.
class SPECBAKE_API TableFile {
  public:
    /// Throws FileError on `name` for bytes that are no table.
    TableFile(std::string name, std::vector<std::byte> bytes);
    /// Reads it whole. Throws FileError, also where the checksum does not agree.
    static TableFile read(const std::filesystem::path& path);

    // The view is of the bytes where they are.
    TableFile(TableFile&&) = default;
    TableFile& operator=(TableFile&&) = default;

    const std::string& name() const { return name_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }
    const SpectralTable& view() const { return view_; }
    /// Where its bands stand.
    Wavelengths bands() const;

    /// What it says of itself: names and values, in the file's order.
    std::vector<std::pair<std::string, std::string>> facts() const;
    /// One of these; none if it is not there.
    std::optional<std::string> fact(std::string_view name) const;

  private:
    std::string name_;
    std::vector<std::byte> bytes_;
    SpectralTable view_;
};

}  // namespace specbake
