#include "solve/samples/with_samples.h"
#include "upsample/lookup.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>
#include <specbake/core/methods.h>
#include <specbake/core/upsampler.h>
#include <specbake/version.h>

#include <utility>

namespace specbake {

using namespace internal;

namespace {

const UpsamplerOptions& checked(const UpsamplerOptions& options) {
    std::string reason;
    if (!options.isValid(&reason)) throw ArgumentError(reason);
    return options;
}

Observer observerOf(const ColorSpace& space, const UpsamplerOptions& options) {
    return Observer(options.illuminant.value_or(space.illuminant), options.quadrature,
                    options.bands, options.observer);
}

/// The preview is for a screen, whose colours are those that the usual observer sees.
NodeEncoder encoderFor(const Observer& observer) {
    return NodeEncoder(Observer("D65", observer.quadrature(), observer.bands()));
}

/// The cube that the grid divides: the texture's own space, and for XYZ linear Rec.2020, which
/// holds nearly every surface colour, on the illuminant's white.
LookupSpaces spacesFor(const ColorSpace& space, const Observer& light, Adaptation adapt) {
    const Imath::M33d texel = xyzFromRGB(space, light, adapt);
    if (!space.isXYZ()) return {texel, texel};
    return {texel, xyzFromRGB(*findColorSpace("lin_rec2020"), light.white())};
}

NotedSolver solverFor(const UpsamplerOptions& options, const Observer& observer,
                      const Solid& solid) {
    const SolverUse use = options.grid ? SolverUse::gridNodes : SolverUse::singleColors;
    return withSamples(options, observer,
                       findMethod(options.method)->makeSolver(observer, solid, use));
}

std::string described(const ColorSpace& space) {
    if (space.isXYZ()) return space.name;
    return space.name + " (" + primariesText(*space.primaries) + ")";
}

/// What the fine quadrature adds to a name; nothing for the sum over the bands.
std::string otherBands(const UpsamplerOptions& options) {
    if (options.quadrature == Quadrature::bands) return {};
    return "; " + std::string(quadratureText(options.quadrature)) + "; " +
           wavelengthsText(options.bands) + " nm";
}

}  // namespace

struct Upsampler::Parts {
    Parts(const ColorSpace& itsSpace, const UpsamplerOptions& itsOptions,
          std::shared_ptr<const Solver> itsSolver)
        : space(itsSpace),
          options(itsOptions),
          observer(observerOf(space, options)),
          solid(observer),
          solver(itsSolver ? NotedSolver{std::move(itsSolver), {}}
                           : solverFor(options, observer, solid)),
          resolver(solid, *solver.solver, options.outside),
          spaces(spacesFor(space, observer, options.adapt)),
          lookup(options.grid, spaces, resolver, encoderFor(observer)) {}

    ColorSpace space;
    UpsamplerOptions options;
    Observer observer;
    Solid solid;
    NotedSolver solver;
    ColorResolver resolver;
    LookupSpaces spaces;
    SpectrumLookup lookup;
};

struct Upsampler::Workspace::Memory {
    std::vector<Mix> mixes;
    SpectrumLookup::Scratch scratch;
};

Upsampler::Workspace::Workspace() : memory_(std::make_unique<Memory>()) {}
Upsampler::Workspace::~Workspace() = default;
Upsampler::Workspace::Workspace(Workspace&&) noexcept = default;
Upsampler::Workspace& Upsampler::Workspace::operator=(Workspace&&) noexcept = default;

Upsampler::Upsampler(const ColorSpace& space, const UpsamplerOptions& options)
    : parts_(std::make_unique<Parts>(space, checked(options), nullptr)) {}
Upsampler::Upsampler(const ColorSpace& space, const UpsamplerOptions& options,
                     std::shared_ptr<const Solver> solver)
    : parts_(std::make_unique<Parts>(space, options, std::move(solver))) {}
Upsampler::~Upsampler() = default;
Upsampler::Upsampler(Upsampler&&) noexcept = default;
Upsampler& Upsampler::operator=(Upsampler&&) noexcept = default;

const ColorSpace& Upsampler::space() const {
    return parts_->space;
}

const UpsamplerOptions& Upsampler::options() const {
    return parts_->options;
}

const Observer& Upsampler::observer() const {
    return parts_->observer;
}

const Solid& Upsampler::solid() const {
    return parts_->solid;
}

std::string Upsampler::identity() const {
    const UpsamplerOptions& o = parts_->options;
    return "specbake " + std::string(kVersion) + "; " + o.method + "; " +
           (o.material ? "material " + *o.material + "; " : "") +
           (o.samples.empty() ? "" : samplesIdentity() + "; ") +
           (o.grid ? "grid " + std::to_string(*o.grid) : "each colour by itself") +
           "; outside: " + std::string(outsideName(o.outside)) + "; " + described(parts_->space) +
           "; " + observer().illuminant() +
           (isAdapted(parts_->space, observer())
                ? ", adapted: " + std::string(adaptationName(o.adapt))
                : "") +
           "; " + std::string(observer().name()) + otherBands(o);
}

std::string Upsampler::samplesIdentity() const {
    return identityOf(parts_->options.samples);
}

const std::vector<std::string>& Upsampler::notes() const {
    return parts_->solver.notes;
}

XYZ Upsampler::xyz(const RGB& color) const {
    return XYZ(color * parts_->spaces.xyzFromTexel());
}

XYZ Upsampler::xyz(const Color& color) const {
    return xyz(RGB{double(color[0]), double(color[1]), double(color[2])});
}

Attainable Upsampler::attainable(const XYZ& asked) const {
    return specbake::attainable(parts_->solid, asked, parts_->options.outside);
}

ColorAnswer Upsampler::solve(const XYZ& asked) const {
    const ColorResolver::Resolved resolved = parts_->resolver.resolve(asked);
    ColorAnswer answer;
    answer.solution = resolved.solution;
    answer.asked = asked;
    answer.given = resolved.given;
    answer.gauge = solid().gauge(asked);
    answer.outside = resolved.outside;
    const XYZ& white = observer().white();
    answer.difference = ciede2000(labFromXYZ(asked, white), labFromXYZ(answer.given, white));
    return answer;
}

ColorCensus Upsampler::sample(std::span<const Color> colors, const SampleSelection& wanted,
                              const SampleTarget& target, Workspace& workspace) const {
    auto& [mixes, scratch] = *workspace.memory_;
    mixes.resize(colors.size());
    scratch.clear();
    ColorCensus census;
    parts_->lookup.locate(colors, mixes, scratch, census);
    if (wanted.isChannels() && target.perColor == bytesPerSample(target.type)) {
        blend(mixes, target.type, target.to, target.perSample, wanted.count());
    } else {
        blendSome(mixes, wanted, target);
    }
    return census;
}

std::vector<float> Upsampler::sample(std::span<const Color> colors,
                                     const SampleSelection& wanted) const {
    std::vector<float> samples(colors.size() * wanted.count());
    Workspace workspace;
    const auto target = SampleTarget::interleaved(
        SampleType::float32, reinterpret_cast<std::byte*>(samples.data()), wanted);
    const ColorCensus census = sample(colors, wanted, target, workspace);
    for (const Fate fate : {Fate::notFinite, Fate::refused, Fate::failed}) {
        if (const auto first = census.of(fate).first) {
            throw ArgumentError("colour " + std::to_string(*first) + " has no spectrum");
        }
    }
    return samples;
}

void Upsampler::solveNodes() const {
    parts_->lookup.noteAllNodes();
    parts_->lookup.solveNotedNodes();
}

std::size_t Upsampler::noteNodes(std::span<const Color> colors) const {
    parts_->lookup.noteNodes(colors);
    return parts_->lookup.notedCount();
}

void Upsampler::solveNotedNodes() const {
    parts_->lookup.solveNotedNodes();
}

std::size_t Upsampler::nodesSolved() const {
    return parts_->lookup.nodesSolved();
}

}  // namespace specbake
