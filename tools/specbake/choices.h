#pragma once

#include "cli_declared.h"
#include "light/light_choices.h"

#include <specbake/core/upsampler.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/spectral_layout.h>
#include <specbake/image/texture_reader.h>

#include <optional>
#include <string>
#include <vector>

/// Options that several commands offer, alike in each, with the defaults of the library.
namespace specbake::tool {

/// What a texture's numbers mean, as words of the command line.
struct ColorArguments {
    std::string space = "auto";
    std::optional<std::string> transfer;
    std::optional<std::string> primaries;
    std::optional<std::string> config;

    /// Throws ArgumentError for a space that is not known.
    ColorWishes wishes() const;
};

/// `--space`, `--primaries`. `automatic`: what "auto" means; empty: it is not offered.
void addSpaceOptions(CLI::App& command, ColorArguments& arguments, const std::string& automatic);

/// The same, and `--transfer`.
void addColorOptions(CLI::App& command, ColorArguments& arguments, const std::string& automatic);

/// Of a texture: its path has a part in it.
inline constexpr const char* kFileRules =
    ", and auto asks its file rules, all but the default one, before what the file says";

/// `--colorconfig`, or $OCIO. `automatic`: what "auto" does with it, if anything.
void addConfigOption(CLI::App& command, ColorArguments& arguments,
                     const std::string& automatic = {});

/// For `--adapt`.
CLI::Validator adaptationCheck();

/// Nothing for "auto".
std::optional<std::string> unlessAuto(const std::string& name);

/// What reads the spectra, as words of the command line.
struct BandArguments {
    std::optional<std::string> quadrature;   ///< none: fine with --wavelengths, else bands
    std::optional<std::string> wavelengths;  ///< START:STOP:STEP

    /// Throw ArgumentError for wavelengths that cannot be.
    Wavelengths bands() const;
    Quadrature usedQuadrature() const;
};

/// How colours become spectra, as words of the command line.
struct ModelArguments {
    std::string illuminant = "auto";
    std::string observer{kUsualObserver};
    std::string method = UpsamplerOptions().method;
    std::string material;  ///< "" for none; several with commas
    std::string samples;   ///< a file, "" for none
    std::string outside{outsideName(UpsamplerOptions().outside)};
    std::string adapt{adaptationName(UpsamplerOptions().adapt)};
    BandArguments reader;

    /// The options with all else as it is by default. Reads the samples; what there is to tell of
    /// their file is added to `notes`. Throws FileError, and ArgumentError for several materials or
    /// wavelengths that cannot be.
    UpsamplerOptions options(std::vector<std::string>& notes) const;
    std::vector<std::string> materials() const;
};

/// `--illuminant`, `--observer`, `--adapt`, `--method`, `--material`, `--samples`, `--quadrature`,
/// `--wavelengths`. `white`: what "auto" means for the light.
void addModelOptions(CLI::App& command, ModelArguments& arguments, const std::string& white);

/// `--quadrature`, `--wavelengths`
void addBandOptions(CLI::App& command, BandArguments& arguments);

/// `--outside`
void addOutsideOption(CLI::App& command, ModelArguments& arguments);

/// To stderr, a line each: the notes of the options, then those of the model made of them.
void printNotes(const std::vector<std::string>& notes, const Upsampler& upsampler);

/// `--quadrature` of a command that reads a spectral image, which says itself what it is.
void addReaderQuadrature(CLI::App& command, std::optional<std::string>& name);

/// Of its name, which must be one.
std::optional<Quadrature> quadratureOf(const std::optional<std::string>& name);

/// What of a texture is read, as words of the command line.
struct ReadArguments {
    std::string channels;  ///< with commas; empty: the texture's colours
    std::optional<std::string> part;
    bool orient = false;

    ReadOptions options() const;
};

/// `--channels`, `--part`, `--orient`. `otherwise`: what holds without them.
void addReadOptions(CLI::App& command, ReadArguments& arguments, const std::string& otherwise);

/// "zip", "zip:6", "none" and so on into `storage`. Throws ArgumentError.
void parseCompression(const std::string& text, StorageOptions& storage);

/// Throws ArgumentError.
SampleType parseSampleType(const std::string& name);
std::vector<std::string> sampleTypeNames();

/// A check that a number is one: it passes neither "nan" nor "inf".
CLI::Validator isFinite();

/// `-j,--threads`, or $SPECBAKE_THREADS
void addThreads(CLI::App& command, int& threads);

}  // namespace specbake::tool
