#include "solid/generators.h"
#include "solid/solid_data.h"

#include <specbake/core/solid_mesh.h>

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <unordered_map>

namespace specbake {

using namespace internal;

namespace {

class MeshBuilder {
  public:
    MeshBuilder(const Generators& generators, const std::vector<Imath::V3d>& vectors)
        : generators_(generators), vectors_(vectors) {
        for (std::size_t j = 0; j < vectors.size(); ++j) all_[j] = true;
    }

    SolidMesh build() {
        for (const SidePair& side : generators_.sides) {
            const auto upper = corners(side);
            mesh_.parallelograms.push_back(indices(upper));
            mesh_.parallelograms.push_back(indices(opposite(upper)));
        }
        const std::vector<GeneratorSet> top = topRim();
        for (const GeneratorSet& set : top) mesh_.bases[1].push_back(index(set));
        // The opposite point turns the rim by half, and seen from below the other way round.
        for (auto set = top.rbegin(); set != top.rend(); ++set) {
            mesh_.bases[0].push_back(index(all_ & ~*set));
        }
        return std::move(mesh_);
    }

  private:
    using Corners = std::array<GeneratorSet, 4>;

    /// Counterclockwise about n = w_first x w_second.
    static Corners corners(const SidePair& side) {
        Corners c;
        c.fill(side.above);
        c[1].set(std::size_t(side.first));
        c[2].set(std::size_t(side.first)).set(std::size_t(side.second));
        c[3].set(std::size_t(side.second));
        return c;
    }

    Corners opposite(const Corners& c) const {
        return {all_ & ~c[3], all_ & ~c[2], all_ & ~c[1], all_ & ~c[0]};
    }

    /// The lower chain takes the reds by ascending angle, the upper one gives them back.
    std::vector<GeneratorSet> topRim() const {
        GeneratorSet set = all_;
        for (const int j : generators_.red) set.reset(std::size_t(j));
        std::vector<GeneratorSet> rim;
        for (const bool value : {true, false}) {
            for (const int j : generators_.red) {
                rim.push_back(set);
                set[std::size_t(j)] = value;
            }
        }
        return rim;
    }

    int index(const GeneratorSet& set) {
        const auto [place, isNew] = indexOf_.try_emplace(set, int(mesh_.vertices.size()));
        if (isNew) {
            Imath::V3d sum(0.0);
            for (std::size_t j = 0; j < vectors_.size(); ++j) {
                if (set[j]) sum += vectors_[j];
            }
            mesh_.vertices.push_back(sum);
        }
        return place->second;
    }

    std::array<int, 4> indices(const Corners& c) {
        std::array<int, 4> result{};
        for (std::size_t i = 0; i < 4; ++i) result[i] = index(c[i]);
        return result;
    }

    const Generators& generators_;
    const std::vector<Imath::V3d>& vectors_;
    GeneratorSet all_;
    SolidMesh mesh_;
    std::unordered_map<GeneratorSet, int> indexOf_;
};

template <typename Face>
void writeFace(const Face& face, std::ostream& out) {
    out << 'f';
    for (const int vertex : face) out << ' ' << vertex + 1;
    out << '\n';
}

}  // namespace

SolidMesh solidMesh(const Solid& solid) {
    return MeshBuilder(*solid.data_->generators, solid.data_->vectors).build();
}

void writeObj(const SolidMesh& mesh, std::ostream& out) {
    out << "# Object-colour solid: " << mesh.vertices.size() << " vertices, "
        << mesh.parallelograms.size() << " parallelograms, 2 bases; x y z = X Y Z\n"
        << "o object_color_solid\n"
        << std::setprecision(17);
    for (const Imath::V3d& v : mesh.vertices) {
        out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    }
    for (const auto& face : mesh.parallelograms) writeFace(face, out);
    for (const auto& base : mesh.bases) writeFace(base, out);
}

}  // namespace specbake
