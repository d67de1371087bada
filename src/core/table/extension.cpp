#include "table/extension.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace specbake::internal {
namespace {

constexpr int kSteps = 150;

/// Colours a tetrahedron: (order + 1)(order + 2)(order + 3) / 6 of them. Small ones need fewer.
int latticeOrder(int nodesPerAxis) {
    return nodesPerAxis <= 17 ? 4 : nodesPerAxis <= 33 ? 3 : 1;
}

using Values = std::array<float, kBandCount>;

/// What of a value leaves [0, 1].
float excess(float value) {
    return value - std::min(std::max(value, 0.0F), 1.0F);
}

class Extension {
  public:
    Extension(const Grid& grid, const Upsampler& upsampler, NodeSpectra& nodes)
        : grid_(grid), upsampler_(upsampler), correction_(upsampler.observer()), nodes_(nodes) {
        chooseColors();
        start();
    }

    void run() {
        double t = 1;
        for (int step = 0; step < kSteps; ++step) {
            const double next = (1 + std::sqrt(1 + 4 * t * t)) / 2;
            extrapolate(float((t - 1) / next));
            descend();
            t = next;
        }
        for (std::size_t i = 0; i < free_.size(); ++i) {
            nodes_.spectrum[free_[i]] = withOwnColor(i, values_[i]);
        }
    }

  private:
    /// Colours of the solid whose blend needs a node beyond it.
    void chooseColors() {
        const int cells = grid_.axis().nodes() - 1;
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) {
                for (int k = 0; k < cells; ++k) chooseFromCell({i, j, k});
            }
        }
    }

    /// From its six tetrahedra: one for each order in which the axes are gone along.
    void chooseFromCell(const std::array<int, 3>& cell) {
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do {
            std::array<int, 3> at = cell;
            std::array<std::uint32_t, 4> corners{grid_.node(at[0], at[1], at[2])};
            for (std::size_t a = 0; a < 3; ++a) {
                ++at[axes[a]];
                corners[a + 1] = grid_.node(at[0], at[1], at[2]);
            }
            if (nodes_.isCut({corners, {1, 1, 1, 1}})) chooseFromTetrahedron(corners);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }

    /// Colours within it, evenly.
    void chooseFromTetrahedron(const std::array<std::uint32_t, 4>& corners) {
        const int order = latticeOrder(grid_.axis().nodes());
        const auto weight = [order](int steps) {
            return (float(steps) + 0.25F) / (float(order) + 1);
        };
        for (int i = 0; i <= order; ++i) {
            for (int j = 0; i + j <= order; ++j) {
                for (int k = 0; i + j + k <= order; ++k) {
                    const GridSimplex color{
                        corners, {weight(i), weight(j), weight(k), weight(order - i - j - k)}};
                    if (isAttainable(color)) colors_.push_back(color);
                }
            }
        }
    }

    bool isAttainable(const GridSimplex& simplex) const {
        Upsampler::Color color{};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::array<float, 3> corner = grid_.position(simplex.node[k]);
            for (std::size_t c = 0; c < 3; ++c) color[c] += simplex.weight[k] * corner[c];
        }
        return upsampler_.solid().contains(upsampler_.xyz(color));
    }

    /// Numbers the nodes that the colours need: first those that are free to move, then the rest.
    void start() {
        for (const bool attainable : {false, true}) {
            for (const GridSimplex& simplex : colors_) {
                for (const std::uint32_t node : simplex.node) {
                    if ((nodes_.attainable[node] == 1) != attainable) continue;
                    if (!number_.try_emplace(node, number_.size()).second) continue;
                    if (!attainable) free_.push_back(node);
                    Spectrum from = nodes_.spectrum[node];
                    if (!attainable) {
                        correction_.apply(from, upsampler_.xyz(grid_.position(node)));
                    }
                    Values& to = values_.emplace_back();
                    for (std::size_t m = 0; m < to.size(); ++m) to[m] = float(from[m]);
                }
            }
        }
        for (GridSimplex& simplex : colors_) {
            for (std::uint32_t& node : simplex.node) node = std::uint32_t(number_.at(node));
        }
        previous_.assign(values_.begin(), values_.begin() + std::ptrdiff_t(free_.size()));
    }

    /// y = x + β (x − x of the step before)
    void extrapolate(float beta) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            for (std::size_t m = 0; m < kBandCount; ++m) {
                const float x = values_[i][m];
                values_[i][m] = x + beta * (x - previous_[i][m]);
                previous_[i][m] = x;
            }
        }
    }

    /// A step of 1 / Σ weights a node: as the weights of a blend add up to 1, the square of a blend
    /// is at most the blend of squares, so that this diagonal is above the Hessian.
    void descend() {
        std::vector<Values> slope(free_.size(), Values{});
        std::vector<float> weight(free_.size());
        for (const GridSimplex& color : colors_) {
            const Values over = excessOf(color);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t i = color.node[k];
                if (i >= free_.size()) continue;
                weight[i] += color.weight[k];
                for (std::size_t m = 0; m < kBandCount; ++m) {
                    slope[i][m] += color.weight[k] * over[m];
                }
            }
        }
        for (std::size_t i = 0; i < free_.size(); ++i) {
            if (!(weight[i] > 0)) continue;
            Values moved = values_[i];
            for (std::size_t m = 0; m < kBandCount; ++m) moved[m] -= slope[i][m] / weight[i];
            const Spectrum projected = withOwnColor(i, moved);
            for (std::size_t m = 0; m < kBandCount; ++m) values_[i][m] = float(projected[m]);
        }
    }

    Values excessOf(const GridSimplex& color) const {
        Values blend{};
        for (std::size_t k = 0; k < 4; ++k) {
            const Values& node = values_[color.node[k]];
            for (std::size_t m = 0; m < kBandCount; ++m) blend[m] += color.weight[k] * node[m];
        }
        for (float& value : blend) value = excess(value);
        return blend;
    }

    /// Onto the spectra of the node's colour within the range, by turns; the colour has the last
    /// word.
    Spectrum withOwnColor(std::size_t i, const Values& values) const {
        constexpr int turns = 4;
        Spectrum spectrum;
        std::copy(values.begin(), values.end(), spectrum.begin());
        const XYZ color = upsampler_.xyz(grid_.position(free_[i]));
        for (int turn = 0; turn < turns; ++turn) {
            correction_.apply(spectrum, color);
            for (double& value : spectrum) value = std::clamp(value, kLowestValue, kHighestValue);
        }
        correction_.apply(spectrum, color);
        return spectrum;
    }

    const Grid& grid_;
    const Upsampler& upsampler_;
    ColorCorrection correction_;
    NodeSpectra& nodes_;
    std::vector<GridSimplex> colors_;  ///< by number in values_, once start() is done
    std::unordered_map<std::uint32_t, std::size_t> number_;
    std::vector<std::uint32_t> free_;  ///< nodes beyond the solid: the first of values_
    std::vector<Values> values_;
    std::vector<Values> previous_;  ///< of the free nodes, a step before
};

}  // namespace

void extendBeyondSolid(const Grid& grid, const Upsampler& upsampler, NodeSpectra& nodes) {
    if (!nodes.areAttainable()) Extension(grid, upsampler, nodes).run();
}

}  // namespace specbake::internal
