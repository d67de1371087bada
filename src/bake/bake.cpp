#include "attributes.h"
#include "band.h"
#include "lookup.h"
#include "pipeline.h"
#include "solvers.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>
#include <specbake/image/spectral_writer.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>
#include <chrono>

namespace specbake {
namespace {

ColorSpace chosenSpace(const TextureInfo& info, const std::optional<std::string>& name) {
    if (!name) return info.automaticSpace;
    const ColorSpace* space = findColorSpace(*name);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + *name + "'");
    return *space;
}

SpectralHeader headerOf(const TextureInfo& info, Attributes attributes) {
    return {info.data, info.display, info.pixelAspectRatio, info.alpha.has_value(),
            std::move(attributes)};
}

/// "FILE: pixel (x, y) is …; N in all", with the window's coordinates.
[[noreturn]] void refuse(const TextureInfo& info, const TexelCensus::Kind& kind, const char* what) {
    const auto width = std::size_t(info.data.width);
    const std::string x = std::to_string(info.data.x + int(*kind.first % width));
    const std::string y = std::to_string(info.data.y + int(*kind.first / width));
    throw FileError(info.path, "pixel (" + x + ", " + y + ") " + what + "; " +
                                   std::to_string(kind.count) + " such in all");
}

void refuseIncomplete(const TextureInfo& info, const TexelCensus& census) {
    const std::pair<Fate, const char*> reasons[] = {
        {Fate::notFinite, "is not a finite number"},
        {Fate::refused, "has a colour that no reflectance has"},
        {Fate::failed, "was not solved"}};
    for (const auto& [fate, what] : reasons) {
        if (census.of(fate).count > 0) refuse(info, census.of(fate), what);
    }
}

/// The cube that the grid divides: the texture's own space, and for XYZ linear Rec.2020, which
/// holds nearly every surface colour, on the illuminant's white.
LookupSpaces spacesFor(const ColorSpace& space, const XYZ& white) {
    const ColorSpace& cube = space.isXYZ() ? *findColorSpace("lin_rec2020") : space;
    return {xyzFromRGB(space, white), xyzFromRGB(cube, white)};
}

/// One texture on its way: what the three stages of the pipeline share.
class Baking {
  public:
    Baking(const std::string& input, const std::filesystem::path& output,
           const BakeOptions& options)
        : reader_(input),
          space_(chosenSpace(reader_.info(), options.space)),
          observer_(options.illuminant.value_or(space_.illuminant)),
          solid_(observer_),
          solver_(makeSolver(options, observer_, solid_)),
          resolver_(solid_, *solver_, options.outside),
          decoder_(reader_.info(), space_),
          lookup_(options.perTexel ? std::nullopt : std::optional(options.grid),
                  spacesFor(space_, observer_.white()), resolver_),
          storage_(options.storage),
          writer_(output,
                  headerOf(reader_.info(), bakedAttributes(reader_.info().attributes, options,
                                                           space_, observer_.illuminant())),
                  storage_) {}

    BakeStatistics run(const BakeOptions& options) {
        const int height = reader_.info().data.height;
        std::vector<Band> bands = bandsOf();
        const auto write = [&](int i) {
            Band& band = bands[std::size_t(i)];
            writeBand(band);
            if (options.progress) options.progress(double(band.firstRow + band.rows) / height);
            band = {};
        };
        runPipeline(int(bands.size()),
                    {[&](int i) { readBand(bands[std::size_t(i)]); },
                     [&](int i) { processBand(bands[std::size_t(i)]); }, write},
                    options.threads, options.stop);
        refuseIncomplete(reader_.info(), census_);
        writer_.commit();
        return statistics();
    }

  private:
    /// Bands of whole chunks, at least 16 rows where they are short, so that a task is worth it.
    std::vector<Band> bandsOf() const {
        const int chunkRows = rowsPerChunk(storage_.compression);
        constexpr std::size_t worthwhile = 1 << 22;  // bytes
        const std::size_t rowBytes = writer_.chunkBytes(0) / std::size_t(writer_.chunkRows(0));
        const int chunks =
            std::max(1, int(std::min<std::size_t>(worthwhile / rowBytes, 16)) / chunkRows);
        std::vector<Band> bands;
        for (int chunk = 0; chunk < writer_.chunkCount(); chunk += chunks) {
            Band band;
            band.firstChunk = chunk;
            band.firstRow = writer_.chunkFirstRow(chunk);
            const int last = std::min(chunk + chunks, writer_.chunkCount()) - 1;
            band.rows = writer_.chunkFirstRow(last) + writer_.chunkRows(last) - band.firstRow;
            band.packed.resize(std::size_t(last - chunk + 1));
            bands.push_back(std::move(band));
        }
        return bands;
    }

    void readBand(Band& band) {
        band.stored.resize(reader_.info().bytesPerRow() * std::size_t(band.rows));
        reader_.readRows(band.firstRow, band.rows, band.stored);
    }

    void processBand(Band& band) {
        std::vector<std::byte> samples;
        for (std::size_t i = 0; i < band.packed.size(); ++i) {
            const int chunk = band.firstChunk + int(i);
            samples.resize(writer_.chunkBytes(chunk));
            for (int row = 0; row < writer_.chunkRows(chunk); ++row) {
                const std::size_t bytes = samples.size() / std::size_t(writer_.chunkRows(chunk));
                const int imageRow = writer_.chunkFirstRow(chunk) + row;
                blendRow(band, imageRow,
                         std::span(samples).subspan(std::size_t(row) * bytes, bytes));
            }
            if (band.census.complete()) band.packed[i] = writer_.pack(chunk, samples);
        }
        band.stored = {};
    }

    void blendRow(Band& band, int imageRow, std::span<std::byte> samples) {
        const TextureInfo& info = reader_.info();
        const auto width = std::size_t(info.data.width);
        std::vector<std::array<float, 3>> colors(width);
        std::vector<float> alpha(info.alpha ? width : 0);
        const std::size_t offset = info.bytesPerRow() * std::size_t(imageRow - band.firstRow);
        decoder_.decode(std::span(band.stored).subspan(offset, info.bytesPerRow()), width,
                        colors.data(), alpha.data());
        std::vector<Mix> mixes(width);
        SpectrumLookup::Scratch scratch;
        lookup_.locate(colors, std::size_t(imageRow) * width, mixes, scratch, band.census);
        const std::size_t plane = width * bytesPerSample(storage_.sampleType);
        if (info.alpha) storePlane(alpha, samples.first(plane));
        blend(mixes, blendType(), samples.data() + (info.alpha ? plane : 0), plane);
    }

    BlendType blendType() const {
        return storage_.sampleType == SampleType::half ? BlendType::half : BlendType::float32;
    }

    void storePlane(std::span<const float> values, std::span<std::byte> plane) const {
        storeSamples(values, blendType(), plane.data());
    }

    void writeBand(Band& band) {
        census_.append(band.census);
        if (!census_.complete()) return;
        for (std::size_t i = 0; i < band.packed.size(); ++i) {
            writer_.write(band.firstChunk + int(i), band.packed[i]);
        }
    }

    BakeStatistics statistics() const {
        BakeStatistics s;
        s.space = space_.name;
        s.illuminant = observer_.illuminant();
        s.texels = std::size_t(reader_.info().data.width) * std::size_t(reader_.info().data.height);
        for (const Fate fate : {Fate::solved, Fate::moved})
            s.directTexels += census_.of(fate).count;
        s.outsideTexels = census_.of(Fate::moved).count;
        s.largestMove = census_.largestMove();
        s.nodesSolved = lookup_.nodesSolved();
        s.notes = reader_.info().notes;
        return s;
    }

    TextureReader reader_;
    ColorSpace space_;
    Observer observer_;
    Solid solid_;
    std::unique_ptr<Solver> solver_;
    ColorResolver resolver_;
    TexelDecoder decoder_;
    SpectrumLookup lookup_;
    StorageOptions storage_;
    SpectralWriter writer_;
    TexelCensus census_;
};

}  // namespace

BakeStatistics bake(const std::string& input, const std::filesystem::path& output,
                    const BakeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    BakeStatistics statistics = Baking(input, output, options).run(options);
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

}  // namespace specbake
