#pragma once

#include <specbake/core/adaptation.h>
#include <specbake/core/color_census.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/table_file.h>

#include <Imath/ImathVec.h>
#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <span>
#include <vector>

namespace specbake::internal {

/// Where the spectra of decoded colours come from. Any number of threads may share one.
class Spectra {
  public:
    Spectra() = default;
    virtual ~Spectra() = default;
    Spectra(const Spectra&) = delete;
    Spectra& operator=(const Spectra&) = delete;

    /// Samples by their numbers in SampleSelection::channels(), all of them or bands alone: a plane
    /// of `planes` each.
    virtual ColorCensus sample(std::span<const Upsampler::Color> colors,
                               std::span<const std::size_t> numbers, float* planes) const = 0;
};

/// Of a model.
class ModelSpectra final : public Spectra {
  public:
    explicit ModelSpectra(std::shared_ptr<const Upsampler> model) : model_(std::move(model)) {}
    ColorCensus sample(std::span<const Upsampler::Color> colors,
                       std::span<const std::size_t> numbers, float* planes) const override;

  private:
    std::shared_ptr<const Upsampler> model_;
    mutable tbb::enumerable_thread_specific<Upsampler::Workspace> workspaces_;
};

/// Of a table, as renderers look them up in it.
class TableSpectra final : public Spectra {
  public:
    /// Throws FileError where the table does not say what it was made for.
    explicit TableSpectra(std::shared_ptr<const TableFile> table);
    ColorCensus sample(std::span<const Upsampler::Color> colors,
                       std::span<const std::size_t> numbers, float* planes) const override;

  private:
    std::shared_ptr<const TableFile> table_;
    std::vector<Imath::V3f> previewOfBand_;  ///< B, G, R at reflectance 1
};

/// Who observes a table's spectra. Throws FileError for a light or quadrature that is not known.
Observer observerOf(const TableFile& table);

/// How colours of the space are adapted to the table's light. Throws FileError where the table is
/// for no colours of this space.
Adaptation adaptationOf(const TableFile& table, const Observer& observer, const ColorSpace& space);

}  // namespace specbake::internal
