#pragma once

#include <specbake/bake/verify.h>
#include <specbake/core/api.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace specbake {

/// What a report shows, and how the two files are compared for it.
struct ReportOptions {
    VerifyOptions verify;
    /// Texels along the longer side of the pictures in the page: those that stand in the middle of
    /// equal blocks. Each takes some 60 bytes of the page.
    int side = 192;
    /// Lines to be shown above the attributes of the file: a name and a value.
    std::vector<std::pair<std::string, std::string>> facts;
    bool sync = false;  ///< the page outlives a power cut (output_file.h)

    static constexpr int kLargestSide = 1024;
};

/// Verifies `spectral` against `texture`, and writes what was found as one page of HTML that needs
/// nothing else: the texture under a choice of lamps, spectra of its texels, differences, and the
/// chromaticities beside those that reflectances have. The page appears whole or not at all.
/// Throws what verify() throws, and FileError if the page cannot be written.
SPECBAKE_API Verification writeReport(const std::string& spectral, const std::string& texture,
                                      const std::filesystem::path& page,
                                      const ReportOptions& options);

}  // namespace specbake
