#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color_census.h>
#include <specbake/core/color_space.h>
#include <specbake/core/observer.h>
#include <specbake/core/sampling.h>
#include <specbake/core/solver.h>
#include <specbake/core/upsampler_options.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace specbake {

/// One colour, solved by itself.
struct ColorAnswer {
    Solution solution;  ///< status `outside` where the rule is Outside::error
    XYZ asked;
    XYZ given;              ///< the colour that the spectrum has
    double gauge = 0;       ///< of the colour asked for: at most 1 inside the solid
    bool outside = false;   ///< another colour than was asked for
    double difference = 0;  ///< CIEDE2000 from the colour asked for to that given
};

/// The model: colours of one space to reflectance spectra under one light.
///
/// Colours are linear RGB of the space, or X, Y, Z. Most spectra are blends of the spectra at the
/// nodes of a grid over the unit cube, which are solved when they are first needed. Each has
/// exactly the colour of its texel under the light, is continuous in the colour, and stays within
/// [0, 1]; also where the solid's boundary cuts the grid (M11) and beyond the cube (M12,
/// docs/method.md).
///
/// Any number of threads may share it. What it answers depends on the space, the options and the
/// colour alone: neither on what was asked before nor on the threads.
class SPECBAKE_API Upsampler {
  public:
    using Color = std::array<float, 3>;

    /// Throws ArgumentError, with the reason, for options that are not valid.
    explicit Upsampler(const ColorSpace& space, const UpsamplerOptions& options = {});
    /// The same with a solver of the caller's, made for the observer of this space and light;
    /// `options.method` is then a name for it, for the identity.
    Upsampler(const ColorSpace& space, const UpsamplerOptions& options,
              std::shared_ptr<const Solver> solver);
    ~Upsampler();
    Upsampler(Upsampler&&) noexcept;
    Upsampler& operator=(Upsampler&&) noexcept;

    const ColorSpace& space() const;
    const UpsamplerOptions& options() const;
    const Observer& observer() const;
    const Solid& solid() const;

    /// All that its spectra depend on, as one line of text.
    std::string identity() const;

    /// The samples of the options in a few words: how many, and a hash of them. The same for the
    /// same spectra in the same order.
    std::string samplesIdentity() const;

    /// What is to be told of the samples of the options, a line each: which were averaged, and how
    /// near spectra are to each sample if it is left out. Empty without samples.
    const std::vector<std::string>& notes() const;

    /// The tristimulus of a linear colour of the space.
    XYZ xyz(const RGB& color) const;
    XYZ xyz(const Color& color) const;

    /// The colour that is given for one asked for: another only outside the solid.
    Attainable attainable(const XYZ& asked) const;

    /// One colour, solved by itself and not through the grid.
    ColorAnswer solve(const XYZ& asked) const;

    /// Memory that a thread keeps from run to run, lest it be asked for again each time.
    class SPECBAKE_API Workspace {
      public:
        Workspace();
        ~Workspace();
        Workspace(Workspace&&) noexcept;
        Workspace& operator=(Workspace&&) noexcept;

      private:
        friend class Upsampler;
        struct SPECBAKE_LOCAL Memory;
        std::unique_ptr<Memory> memory_;
    };

    /// The samples of a run of colours. A colour that has no spectrum gets that of black, and
    /// counts. Numbers in the census are indices of `colors`.
    [[nodiscard]] ColorCensus sample(std::span<const Color> colors, const SampleSelection& wanted,
                                     const SampleTarget& target, Workspace& workspace) const;

    /// The same in a vector: all samples of the first colour, then those of the next. Throws
    /// ArgumentError, naming the first, if a colour has no spectrum.
    std::vector<float> sample(std::span<const Color> colors, const SampleSelection& wanted) const;

    /// Solves now every node of the grid that has a spectrum; else each is solved when it is first
    /// needed.
    void solveNodes() const;

    /// Notes the nodes of the grid that these colours need and that were not asked for before;
    /// returns how many are noted now, from whichever call, and not yet taken by a thread. sample()
    /// solves what it needs by itself: this is for callers who have many colours, or many threads.
    std::size_t noteNodes(std::span<const Color> colors) const;
    /// Solves noted nodes, some dozens at a time, until none is left to take. Several threads that
    /// call it share the work.
    void solveNotedNodes() const;

    /// How many nodes were looked at so far.
    std::size_t nodesSolved() const;

  private:
    struct SPECBAKE_LOCAL Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace specbake
