#include "report/page.h"
#include "report/page_data.h"
#include "report/sampled_texels.h"
#include "verify/observed.h"

#include <specbake/bake/report.h>
#include <specbake/core/error.h>
#include <specbake/image/output_file.h>
#include <specbake/image/spectral_reader.h>

#include <optional>
#include <string_view>

namespace specbake {

using namespace internal;

namespace {

std::string fileName(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// A lamp or an observer of one's own is hundreds of numbers.
std::string shortened(const std::string& value) {
    constexpr std::size_t most = 300;
    return value.size() <= most ? value : value.substr(0, value.rfind(' ', most)) + " ...";
}

/// The page with `text` in the place {{name}}.
void fill(std::string& page, std::string_view name, std::string_view text) {
    const std::string place = "{{" + std::string(name) + "}}";
    page.replace(page.find(place), place.size(), text);
}

/// The data are filled in last: whatever stands in them is no place.
std::string pageOf(const PageContent& content) {
    std::string page(kPageFrame);
    fill(page, "style", kPageStyle);
    fill(page, "script", kPageScript);
    fill(page, "data", pageData(content));
    return page;
}

}  // namespace

Verification writeReport(const std::string& spectral, const std::string& texture,
                         const std::filesystem::path& page, const ReportOptions& options) {
    if (options.side < 1 || options.side > ReportOptions::kLargestSide) {
        throw ArgumentError("a report's pictures have 1 to 1024 texels along a side");
    }
    const SpectralReader reader(spectral);
    const Window window = reader.header().data;
    SampledTexels texels(Blocks(window.width, window.height, options.side),
                         reader.wavelengths().size());
    std::optional<ReportColors> colors;
    Verification verified = verifyObserved(spectral, texture, options.verify,
                                           [&](const ComparedRows& rows, const Upsampler& model) {
                                               if (!colors) colors.emplace(model, spectral, reader);
                                               texels.take(rows);
                                           });
    PageContent content{fileName(spectral), fileName(texture), window, texels, *colors,
                        verified,           options.facts};
    for (const auto& [name, value] : reader.facts().attributes) {
        content.facts.emplace_back(name, shortened(value));
    }
    writeWhole(page, pageOf(content), options.sync);
    return verified;
}

}  // namespace specbake
