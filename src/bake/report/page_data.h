#pragma once

#include "lit_bands.h"
#include "report/sampled_texels.h"

#include <specbake/bake/report.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/image_types.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace specbake::internal {

/// The colours that the texels of a report are held against.
struct ReportColors {
    std::string space;
    std::string light;
    std::vector<double> wavelengths;                      ///< of the bands, nm
    std::vector<Imath::V3d> weights;                      ///< w_m, of the file's bands
    std::vector<std::pair<std::string, LitBands>> lamps;  ///< by name
    std::optional<std::array<Chromaticity, 3>> triangle;  ///< of the space; none for XYZ

    /// `path` and `reader`: the spectral file.
    ReportColors(const Upsampler& model, const std::string& path, const SpectralReader& reader);
};

/// All that a page shows.
struct PageContent {
    std::string title;    ///< the spectral file
    std::string texture;  ///< its texture
    Window window;        ///< the data window
    const SampledTexels& texels;
    const ReportColors& colors;
    const Verification& verified;
    std::vector<std::pair<std::string, std::string>> facts;
};

/// As JSON that may stand in a script of a page: without "<".
std::string pageData(const PageContent& content);

}  // namespace specbake::internal
