#include "upsample/texel_solver.h"

#include <specbake/core/ciede2000.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

using Color = TexelSolver::Color;

NodeValues difference(const NodeValues& a, const NodeValues& b) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) result.value[p] = a.value[p] - b.value[p];
    return result;
}

/// The most of a step that keeps a spectrum within [0, 1].
float room(const NodeValues& values, const NodeValues& step) {
    float most = 1;
    for (std::size_t p = kPreviewSamples; p < kTexelSamples; ++p) {
        const float v = values.value[p];
        const float d = step.value[p];
        if (v + d > 1) most = std::min(most, (1 - v) / d);
        if (v + d < 0) most = std::min(most, -v / d);
    }
    return most;
}

bool hasSpectrum(const SolvedTexel& texel) {
    return texel.fate == Fate::solved || texel.fate == Fate::moved;
}

/// Adds what the grid's spectrum has beyond the solved one at the nearest point of the cube: all of
/// it at the cube's face, less and less farther out, and nowhere more than keeps within [0, 1].
/// Both have the same colour, so that the sum keeps its own.
void addStep(const NodeValues& inGrid, const NodeValues& solved, float most, NodeValues& values) {
    const NodeValues step = difference(inGrid, solved);
    const float share = std::min(most, room(values, step));
    for (std::size_t p = 0; p < kTexelSamples; ++p) values.value[p] += share * step.value[p];
}

}  // namespace

void TexelSolver::solve(std::span<const Color> colors, std::span<SolvedTexel> texels) {
    std::vector<std::size_t> places;
    std::vector<Color> anew;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (!isFinite(colors[i])) {
            texels[i] = {{}, Fate::notFinite, 0};
        } else if (const auto known = cache_.find(colors[i])) {
            texels[i] = *known;
        } else {
            places.push_back(i);
            anew.push_back(colors[i]);
        }
    }
    const std::vector<SolvedTexel> solved = solveAnew(anew);
    for (std::size_t k = 0; k < places.size(); ++k) {
        texels[places[k]] = solved[k];
        cache_.store(anew[k], solved[k]);
    }
}

/// The colours, and with them the points of the cube that their steps need.
std::vector<SolvedTexel> TexelSolver::solveAnew(std::span<const Color> colors) {
    const std::vector<FaceStep> steps = faceSteps(colors);
    std::vector<XYZ> asked;
    for (const Color& color : colors) asked.push_back(spaces_.xyzOfTexel(color));
    for (const FaceStep& step : steps) asked.push_back(spaces_.xyzOfPoint(step.onFace));
    std::vector<SolvedTexel> texels = solveColors(asked);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        SolvedTexel& texel = texels[steps[k].texel];
        const SolvedTexel& onFace = texels[colors.size() + k];
        if (!hasSpectrum(texel) || !hasSpectrum(onFace)) continue;
        addStep(blended(steps[k].place.mix), onFace.values, steps[k].place.margin * steps[k].share,
                texel.values);
    }
    texels.resize(colors.size());
    return texels;
}

/// Those that a texel's distance from the cube leaves anything of.
std::vector<TexelSolver::FaceStep> TexelSolver::faceSteps(std::span<const Color> colors) {
    constexpr float fadedOut = 1.0F / 16;  // distance, linear RGB
    std::vector<FaceStep> steps;
    if (lattice_ == nullptr) return steps;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Color point = spaces_.gridPoint(colors[i]);
        if (isInUnitCube(point)) continue;
        FaceStep step;
        step.texel = i;
        float distance = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            step.onFace[c] = std::clamp(point[c], 0.0F, 1.0F);
            distance = std::max(distance, std::abs(point[c] - step.onFace[c]));
        }
        if (distance >= fadedOut) continue;
        step.share = 1 - distance / fadedOut;
        lattice_->note(step.onFace);
        steps.push_back(step);
    }
    lattice_->store.findNoted();
    for (FaceStep& step : steps) step.place = lattice_->at(step.onFace);
    std::erase_if(steps, [](const FaceStep& step) { return step.place.margin == 0; });
    return steps;
}

std::vector<SolvedTexel> TexelSolver::solveColors(std::span<const XYZ> asked) const {
    std::vector<ColorResolver::Resolved> resolved(asked.size());
    resolver_.resolveMany(asked, resolved);
    std::vector<SolvedTexel> texels;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        texels.push_back(texelOf(asked[i], resolved[i]));
    }
    return texels;
}

SolvedTexel TexelSolver::texelOf(const XYZ& asked, const ColorResolver::Resolved& resolved) const {
    if (!resolved.solution.solved()) {
        return {{}, resolved.outside ? Fate::refused : Fate::failed, 0};
    }
    const NodeValues values = encoder_.encode(resolved.solution.spectrum);
    if (!resolved.outside) return {values, Fate::solved, 0};
    const XYZ& white = resolver_.solid().white();
    return {values, Fate::moved,
            ciede2000(labFromXYZ(asked, white), labFromXYZ(resolved.given, white))};
}

}  // namespace specbake::internal
