#include "texture/openimageio/color_config.h"

#include <specbake/core/error.h>

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

namespace specbake::internal {
namespace {

namespace ocio = OCIO_NAMESPACE;

/// A configuration is read once. One that changes while a program runs is not read again.
ocio::ConstConfigRcPtr configOf(const std::string& path) {
    static std::mutex mutex;
    static std::map<std::string, ocio::ConstConfigRcPtr> known;
    const std::lock_guard lock(mutex);
    ocio::ConstConfigRcPtr& config = known[path];
    if (config) return config;
    try {
        config = ocio::Config::CreateFromFile(path.c_str());
        return config;
    } catch (const ocio::Exception& error) {
        known.erase(path);
        throw FileError(path, std::string("no configuration of OpenColorIO that can be used: ") +
                                  std::string(error.what()).substr(0, 300));
    }
}

std::vector<std::string> namesOf(const ocio::ConstColorSpaceRcPtr& space) {
    std::vector<std::string> names = {space->getName()};
    for (std::size_t i = 0; i < space->getNumAliases(); ++i) {
        names.emplace_back(space->getAlias(i));
    }
    return names;
}

std::vector<std::string> allNames(const ocio::Config& config) {
    std::vector<std::string> all;
    for (int i = 0; i < config.getNumColorSpaces(); ++i) {
        for (std::string& name : namesOf(config.getColorSpace(config.getColorSpaceNameByIndex(i))))
            all.push_back(std::move(name));
    }
    for (int i = 0; i < config.getNumRoles(); ++i) all.emplace_back(config.getRoleName(i));
    return all;
}

/// Where the colours of a configuration go.
struct Target {
    std::string name;  ///< of the configuration
    ColorSpace space;
};

std::optional<Target> knownTarget(const ocio::Config& config) {
    for (const char* wanted : {"acescg", "lin_rec709", "lin_rec2020", "aces2065-1"}) {
        const ColorSpace* space = findColorSpace(wanted);
        for (int i = 0; i < config.getNumColorSpaces(); ++i) {
            const char* name = config.getColorSpaceNameByIndex(i);
            for (const std::string& word : namesOf(config.getColorSpace(name))) {
                if (findColorSpace(word) == space) return Target{name, *space};
            }
        }
    }
    return {};
}

Target targetOf(const ocio::Config& config, const ColorWishes& wishes) {
    if (auto known = knownTarget(config)) return *std::move(known);
    if (config.hasRole("aces_interchange")) {
        return {"aces_interchange", *findColorSpace("aces2065-1")};
    }
    if (wishes.primaries && config.hasRole("scene_linear")) {
        return {"scene_linear", colorSpaceFromPrimaries(primariesFromText(*wishes.primaries))};
    }
    throw ArgumentError(*wishes.config +
                        ": neither a space of it nor its role aces_interchange says which light "
                        "its numbers are; --primaries says those of its role scene_linear");
}

/// Stored pixels through a processor, which any number of threads may use.
class ConfigTransform : public PixelTransform {
  public:
    ConfigTransform(ocio::ConstCPUProcessorRcPtr processor, bool grey)
        : processor_(std::move(processor)), grey_(grey) {}

    void run(const float* stored, std::size_t count, std::array<float, 3>* linear) const override {
        for (std::size_t i = 0; i < count; ++i) {
            if (grey_) {
                linear[i].fill(stored[i]);
            } else {
                std::copy_n(stored + 3 * i, 3, linear[i].begin());
            }
        }
        ocio::PackedImageDesc pixels(linear, long(count), 1, 3);
        processor_->apply(pixels);
    }

  private:
    ocio::ConstCPUProcessorRcPtr processor_;
    bool grey_;
};

/// The configuration's name of the space that is meant, if it has one.
std::optional<std::string> meantSpace(const ocio::Config& config, const TextureInfo& texture,
                                      const ColorWishes& wishes) {
    if (wishes.space) {
        const auto space = config.getColorSpace(wishes.space->c_str());
        if (space) return space->getName();
        if (findColorSpace(*wishes.space) != nullptr) return {};
        const std::vector<std::string> names = allNames(config);
        throw ArgumentError("--space: '" + *wishes.space + "' is no space of " + *wishes.config +
                            suggestion(*wishes.space, names));
    }
    const std::string path = std::filesystem::absolute(texture.path).string();
    if (config.filepathOnlyMatchesDefaultRule(path.c_str())) return {};
    const auto space = config.getColorSpace(config.getColorSpaceFromFilepath(path.c_str()));
    if (!space) return {};
    return space->getName();
}

ColorMeaning meaningIn(const ocio::Config& config, const std::string& name,
                       const TextureInfo& texture, const ColorWishes& wishes) {
    const Target target = targetOf(config, wishes);
    const auto processor = config.getProcessor(name.c_str(), target.name.c_str());
    const int colors = texture.channels - (texture.alpha ? 1 : 0);
    ColorMeaning meaning;
    meaning.space = target.space;
    meaning.source = ColorSource::config;
    meaning.configSpace = name;
    meaning.configHash = processor->getCacheID();
    meaning.reason = "'" + name + "' of " +
                     std::filesystem::path(*wishes.config).filename().string() +
                     (wishes.space ? "" : ", by its file rules");
    meaning.transform = std::make_shared<const ConfigTransform>(
        processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS), colors == 1);
    return meaning;
}

}  // namespace

std::optional<ColorMeaning> meaningByConfig(const TextureInfo& texture, const ColorWishes& wishes) {
    const ocio::ConstConfigRcPtr config = configOf(*wishes.config);
    try {
        const std::optional<std::string> name = meantSpace(*config, texture, wishes);
        if (!name) return {};
        if (wishes.transfer) {
            throw ArgumentError("--transfer: '" + *name + "' of " + *wishes.config +
                                " has its own curve");
        }
        if (config->getColorSpace(name->c_str())->isData()) {
            throw ArgumentError("'" + *name + "' of " + *wishes.config +
                                " is for data: numbers that are no colours");
        }
        if (texture.model != ColorModel::rgb) {
            throw FileError(texture.path, "CMYK and Lab have no space in a configuration");
        }
        return meaningIn(*config, *name, texture, wishes);
    } catch (const ocio::Exception& error) {
        throw FileError(*wishes.config, error.what());
    }
}

}  // namespace specbake::internal
