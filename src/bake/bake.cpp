#include "attributes.h"
#include "baking.h"
#include "beside/material_map.h"
#include "beside/second_colors.h"
#include "choose/tolerances.h"
#include "identity/identity.h"
#include "watched_texture.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/model_cache.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/file_fingerprint.h>
#include <specbake/image/spectral_writer.h>

#include <chrono>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace specbake {

using namespace internal;

namespace {

const BakeOptions& checked(const BakeOptions& options) {
    std::string reason;
    if (!options.isValid(&reason)) throw ArgumentError(reason);
    return options;
}

/// A texture, its model, and the precision of its samples: what the options leave to the texture is
/// decided.
class Job {
  public:
    Job(Texture& texture, const BakeOptions& options)
        : options_(checked(options)),
          models_(options.models ? options.models : std::make_shared<ModelCache>()),
          meaning_(chosenMeaning(texture.info(), options.color, unused_)),
          decoder_(texture.info(), meaning_),
          watched_(texture),
          source_{watched_, decoder_, options.threads, options.stop},
          upsampler_(models_->model(meaning_.space, decidedModel())),
          bits_(decidedBits()) {
        openMap();
        openSecond();
    }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    SpectralHeader header() const {
        const TextureInfo& info = source_.info();
        Attributes attributes = bakedAttributes(info.attributes, meaning_, *upsampler_,
                                                half() ? std::optional(bits_) : std::nullopt);
        if (map_) addMaterials(attributes, options_.mappedMaterials, *options_.materialMap);
        if (second_) addSecond(attributes, options_.secondLight, *options_.second);
        addChosen(attributes, options_);
        return {info.data,
                info.display,
                info.pixelAspectRatio,
                info.alpha.has_value(),
                std::move(attributes),
                upsampler_->options().bands};
    }

    /// Of a texture with that fingerprint.
    std::string identity(const std::string& source) const {
        return bakeIdentity(source, *models_->model(meaning_.space, options_.model), meaning_,
                            options_);
    }

    BakeStatistics run(SpectralSink& sink) {
        Baking baking(source_, *upsampler_, sink, bits_);
        if (map_) baking.add(*map_);
        if (second_) baking.add(*second_);
        const ColorCensus census = baking.run(options_.progress);
        const TextureInfo& info = source_.info();
        statistics_.space = upsampler_->space().name;
        statistics_.colorSource = meaning_.source;
        statistics_.colorReason = meaning_.reason;
        statistics_.illuminant = lightLabel(upsampler_->observer().illuminant());
        if (isAdapted(meaning_.space, upsampler_->observer())) {
            statistics_.adapted = upsampler_->options().adapt;
        }
        statistics_.texels = std::size_t(info.data.width) * std::size_t(info.data.height);
        statistics_.grid = upsampler_->options().grid.value_or(0);
        statistics_.bits = half() ? bits_ : std::numeric_limits<float>::digits - 1;
        statistics_.directTexels = census.of(Fate::solved).count + census.of(Fate::moved).count;
        statistics_.outsideTexels = census.of(Fate::moved).count;
        statistics_.largestMove = census.largestMove();
        statistics_.secondIlluminant = options_.secondLight;
        statistics_.secondMissed = baking.besideCensus().missed;
        statistics_.largestSecondMiss = baking.besideCensus().largest;
        statistics_.nodesSolved = upsampler_->nodesSolved();
        statistics_.notes = info.notes;
        statistics_.notes.insert(statistics_.notes.end(), unused_.begin(), unused_.end());
        if (watched_.holdsNormals()) {
            statistics_.notes.emplace_back(
                "its texels are unit vectors around (0.5, 0.5, 1): normals, it seems, no colours");
        }
        std::ranges::copy(upsampler_->notes(), std::back_inserter(statistics_.notes));
        for (const std::string& note : unusedOfSecond_) {
            statistics_.notes.push_back(options_.second->string() + ": " + note);
        }
        return statistics_;
    }

  private:
    bool half() const { return options_.storage.sampleType == SampleType::half; }

    void openMap() {
        if (!options_.materialMap) return;
        mapImage_.emplace(options_.materialMap->string());
        map_.emplace(*mapImage_, watched_.info(), meaning_.space, upsampler_->options(),
                     options_.mappedMaterials);
    }

    void openSecond() {
        if (!options_.second) return;
        const Observer& first = upsampler_->observer();
        options_.secondLight = Observer(options_.secondLight).illuminant();
        if (options_.secondLight == first.illuminant()) {
            throw ArgumentError("the second light is the first, " + options_.secondLight);
        }
        secondImage_.emplace(options_.second->string());
        const ColorMeaning meaning =
            chosenMeaning(secondImage_->info(), options_.color, unusedOfSecond_);
        second_.emplace(*secondImage_, watched_.info(), meaning, first, options_.secondLight,
                        upsampler_->options().adapt);
    }

    UpsamplerOptions decidedModel() {
        UpsamplerOptions model = options_.model;
        if (!options_.maxDeviation || !model.grid) return model;
        const GridChoice choice =
            chooseGrid(source_, meaning_.space, model, *options_.maxDeviation, *models_);
        statistics_.deviation = choice.deviation;
        statistics_.largestDeviation = choice.largest;
        statistics_.deviationColors = choice.colors;
        statistics_.deviationOfAll = choice.all;
        model.grid = choice.nodes;
        return model;
    }

    int decidedBits() {
        if (!options_.maxDE || !half()) return options_.bits;
        const BitsChoice choice = chooseBits(source_, *upsampler_, *options_.maxDE);
        statistics_.difference = choice.difference;
        return choice.bits;
    }

    BakeOptions options_;
    std::shared_ptr<ModelCache> models_;
    BakeStatistics statistics_;
    std::vector<std::string> unused_;
    ColorMeaning meaning_;
    TexelDecoder decoder_;
    WatchedTexture watched_;
    TexelSource source_;
    std::shared_ptr<const Upsampler> upsampler_;
    int bits_;
    std::optional<TextureReader> mapImage_;
    std::optional<MaterialMap> map_;
    std::vector<std::string> unusedOfSecond_;
    std::optional<TextureReader> secondImage_;
    std::optional<SecondColors> second_;
};

/// How long `work` takes stands in the statistics that it returns.
template <class Work>
BakeStatistics timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    BakeStatistics statistics = work();
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

/// `source`: the fingerprint of the texture's file, if there is one.
BakeStatistics bakeToFile(Texture& texture, const std::optional<std::string>& source,
                          const std::filesystem::path& output, const BakeOptions& options) {
    return timed([&] {
        Job job(texture, options);
        SpectralHeader header = job.header();
        if (source) addIdentity(header.attributes, job.identity(*source), options);
        const StorageOptions storage = withBoundedChunks(options.storage, header);
        SpectralWriter writer(output, header, storage);
        BakeStatistics statistics = job.run(writer);
        writer.commit();
        if (storage.compression != options.storage.compression) {
            statistics.notes.emplace_back(
                "its rows are so wide that 16 of them, a chunk of zip, would take hundreds of "
                "megabytes of every reader: zips is written, a chunk a row");
        }
        return statistics;
    });
}

}  // namespace

BakeStatistics bake(Texture& texture, const std::filesystem::path& output,
                    const BakeOptions& options) {
    return bakeToFile(texture, {}, output, options);
}

BakeStatistics bake(const std::string& input, const std::filesystem::path& output,
                    const BakeOptions& options) {
    checked(options);
    const auto source = fileFingerprint(input);
    TextureReader texture(input, options.read);
    return bakeToFile(texture, source, output, options);
}

BakeStatistics bake(Texture& texture, const RowReceiver& receiver, const BakeOptions& options) {
    if (options.storage.isTiled()) throw ArgumentError("rows have neither tiles nor mip levels");
    return timed([&] {
        Job job(texture, options);
        const SpectralHeader header = job.header();
        if (receiver.begin) receiver.begin(header);
        RowSink sink(header, options.storage.sampleType, receiver.row);
        return job.run(sink);
    });
}

}  // namespace specbake
