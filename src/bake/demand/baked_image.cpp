#include "attributes.h"
#include "choose/tolerances.h"
#include "demand/level_blocks.h"
#include "mantissa.h"

#include <specbake/bake/baked_image.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace specbake {

using namespace internal;

namespace {

/// Samples are made in pieces of this side, so that a large chunk needs no more memory than a
/// small one.
constexpr int kPiece = 64;

const BakeOptions& checked(const BakeOptions& options, bool isTabulated) {
    if (isTabulated && (options.maxDE || options.maxDeviation)) {
        throw ArgumentError("a table leaves nothing to choose by a difference or deviation");
    }
    std::string reason;
    if (!options.isValid(&reason)) throw ArgumentError(reason);
    if (options.materialMap || options.second) {
        throw ArgumentError("an image on demand takes no images beside its texture");
    }
    return options;
}

/// The pieces of a window, aligned to multiples of their side.
std::vector<Window> piecesOf(const Window& whole) {
    std::vector<Window> pieces;
    const int right = whole.x + whole.width;
    const int lower = whole.y + whole.height;
    for (int y = whole.y; y < lower; y = (y / kPiece + 1) * kPiece) {
        for (int x = whole.x; x < right; x = (x / kPiece + 1) * kPiece) {
            pieces.push_back({x, y, std::min((x / kPiece + 1) * kPiece, right) - x,
                              std::min((y / kPiece + 1) * kPiece, lower) - y});
        }
    }
    return pieces;
}

/// The planes of a block in which channels of the file are: alpha has number 0 if there is any.
struct Planes {
    BlockChannels channels;
    std::vector<std::size_t> of;  ///< of each channel that is asked for

    /// `bands`: how many there are.
    Planes(std::span<const int> asked, bool alpha, int bands) {
        channels.alpha = alpha;
        const int first = alpha ? 1 : 0;
        const auto all = kPreviewSamples + std::size_t(bands);
        for (const int channel : asked) {
            if (channel < 0 || channel >= first + int(all)) {
                throw ArgumentError("a channel that there is not");
            }
            if (channel >= first) channels.samples.push_back(std::size_t(channel - first));
        }
        auto& samples = channels.samples;  // each once, in order: fewer kinds of blocks to keep
        std::sort(samples.begin(), samples.end());
        samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
        if (!samples.empty() && samples.front() < kPreviewSamples) {  // a preview is of all bands
            samples.resize(all);
            std::iota(samples.begin(), samples.end(), std::size_t(0));
        }
        for (const int channel : asked) {
            const auto place =
                std::lower_bound(samples.begin(), samples.end(), std::size_t(channel - first));
            const auto plane = std::size_t(place - samples.begin()) + std::size_t(first);
            of.push_back(alpha && channel == 0 ? 0 : plane);
        }
    }
};

}  // namespace

struct BakedImage::Implementation {
    Implementation(std::unique_ptr<Texture> itsTexture, const BakeOptions& itsOptions,
                   std::shared_ptr<const TableFile> itsTable, const BakedImageMemory& memory)
        : options(checked(itsOptions, itsTable != nullptr)),
          table(std::move(itsTable)),
          texture(std::move(itsTexture)),
          info(texture->info()),
          meaning(chosenMeaning(info, options.color, unused)),
          decoder(info, meaning),
          source{*texture, decoder, options.threads, options.stop},
          upsampler(table ? nullptr : decidedModel()),
          spectra(table ? spectraOf(table) : spectraOf(upsampler)),
          bits(table ? options.bits : decidedBits()),
          header{info.data,
                 info.display,
                 info.pixelAspectRatio,
                 info.alpha.has_value(),
                 attributes(),
                 table ? table->bands() : upsampler->options().bands},
          levels(chunkGrids(info.data.width, info.data.height, options.storage)),
          rows(*texture, memory.texture),
          blocks(rows, info, decoder, *spectra, levels, memory.levels) {}

    bool half() const { return options.storage.sampleType == SampleType::half; }

    std::shared_ptr<const Upsampler> decidedModel() const {
        const auto models = options.models ? options.models : std::make_shared<ModelCache>();
        UpsamplerOptions model = options.model;
        if (options.maxDeviation && model.grid) {
            model.grid =
                chooseGrid(source, meaning.space, model, *options.maxDeviation, *models).nodes;
        }
        return models->model(meaning.space, model);
    }

    static std::unique_ptr<Spectra> spectraOf(std::shared_ptr<const TableFile> table) {
        return std::make_unique<TableSpectra>(std::move(table));
    }
    static std::unique_ptr<Spectra> spectraOf(std::shared_ptr<const Upsampler> model) {
        return std::make_unique<ModelSpectra>(std::move(model));
    }

    Attributes attributes() const {
        Attributes all = spectraAttributes();
        addChosen(all, options);
        return all;
    }

    Attributes spectraAttributes() const {
        const auto kept = half() ? std::optional(bits) : std::nullopt;
        if (!table) return bakedAttributes(info.attributes, meaning, *upsampler, kept);
        const Observer observer = observerOf(*table);
        const Adaptation adapt = adaptationOf(*table, observer, meaning.space);
        return tabulatedAttributes(info.attributes, meaning, *table, observer, adapt, kept);
    }

    int decidedBits() const {
        return options.maxDE && half() ? chooseBits(source, *upsampler, *options.maxDE).bits
                                       : options.bits;
    }

    const ChunkGrid& levelOf(int chunk) const {
        for (const ChunkGrid& level : levels) {
            if (chunk >= level.firstChunk && chunk < level.firstChunk + level.count()) return level;
        }
        throw ArgumentError("a chunk that there is not");
    }

    /// As bake() stores them.
    void store(std::span<const float> values, bool alpha, std::byte* to) const {
        if (half() && !alpha) {
            storeRounded(values, bits, to);
        } else {
            storeSamples(values, options.storage.sampleType, to);
        }
    }

    /// The samples of a piece to their places in a chunk.
    void place(const Block& block, const Planes& planes, const Window& chunk,
               std::span<std::byte> samples) const {
        const std::size_t size = bytesPerSample(options.storage.sampleType);
        const std::size_t texel = planes.of.size() * size;
        const auto width = std::size_t(block.at.width);
        std::vector<std::byte> plane(width * size);
        for (int y = 0; y < block.at.height; ++y) {
            const TexelRow& row = block.rows[std::size_t(y)];
            const std::size_t first =
                std::size_t(block.at.y + y - chunk.y) * std::size_t(chunk.width) +
                std::size_t(block.at.x - chunk.x);
            for (std::size_t c = 0; c < planes.of.size(); ++c) {
                const std::size_t from = planes.of[c];
                store(std::span(row).subspan(from * width, width),
                      planes.channels.alpha && from == 0, plane.data());
                std::byte* to = samples.data() + first * texel + c * size;
                for (std::size_t x = 0; x < width; ++x) {
                    std::memcpy(to + x * texel, plane.data() + x * size, size);
                }
            }
        }
    }

    BakeOptions options;
    std::shared_ptr<const TableFile> table;
    std::unique_ptr<Texture> texture;
    const TextureInfo& info;
    std::vector<std::string> unused;
    ColorMeaning meaning;
    TexelDecoder decoder;
    TexelSource source;
    std::shared_ptr<const Upsampler> upsampler;  ///< none with a table
    std::unique_ptr<Spectra> spectra;
    int bits;
    SpectralHeader header;
    std::vector<ChunkGrid> levels;
    StoredRows rows;
    LevelBlocks blocks;
};

BakedImage::BakedImage(std::unique_ptr<Texture> texture, const BakeOptions& options,
                       const BakedImageMemory& memory)
    : BakedImage(std::move(texture), options, nullptr, memory) {}
BakedImage::BakedImage(std::unique_ptr<Texture> texture, const BakeOptions& options,
                       std::shared_ptr<const TableFile> table, const BakedImageMemory& memory)
    : implementation_(std::make_unique<Implementation>(std::move(texture), options,
                                                       std::move(table), memory)) {}
BakedImage::~BakedImage() = default;

const SpectralHeader& BakedImage::header() const {
    return implementation_->header;
}

SampleType BakedImage::sampleType() const {
    return implementation_->options.storage.sampleType;
}

const std::vector<ChunkGrid>& BakedImage::levels() const {
    return implementation_->levels;
}

void BakedImage::readChunk(int chunk, std::span<const int> channels,
                           std::span<std::byte> samples) const {
    const ChunkGrid& level = implementation_->levelOf(chunk);
    const Window whole = level.texels(chunk);
    const Planes planes(channels, header().alpha, header().bands.count);
    const std::size_t needed = std::size_t(whole.width) * std::size_t(whole.height) *
                               channels.size() * bytesPerSample(sampleType());
    if (samples.size() < needed) throw ArgumentError("a buffer too small for its chunk");
    for (const Window& piece : piecesOf(whole)) {
        const Block block = implementation_->blocks.texels(level.level, piece, planes.channels);
        implementation_->place(block, planes, whole, samples);
    }
}

}  // namespace specbake
