#include "solve/samples/sample_field.h"

#include "support/solid_samples.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Row = std::vector<long double>;

struct Data {
    std::vector<Imath::V3d> places;
    std::vector<Spectrum> values;
};

Data randomData(Random& random, std::size_t count) {
    Data data;
    for (std::size_t k = 0; k < count; ++k) {
        data.places.emplace_back(random(0, 50), random(-40, 40), random(-40, 40));
        Spectrum& value = data.values.emplace_back();
        for (double& v : value) v = random(-0.3, 0.3);
    }
    return data;
}

long double phi(const FieldShape& shape, const Imath::V3d& a, const Imath::V3d& b) {
    const long double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    const long double r = std::sqrt(x * x + y * y + z * z);
    return std::exp(-r / static_cast<long double>(shape.range)) +
           static_cast<long double>(shape.weight) * std::exp(-r);
}

/// (M15) for one band: Φ c = b by Gauss-Jordan with pivoting, v(p) = Σ c_k φ(|p − p_k|).
class BruteField {
  public:
    BruteField(Data data, const FieldShape& shape) : data_(std::move(data)), shape_(shape) {}

    double at(const Imath::V3d& place, std::size_t band) const {
        const std::size_t n = data_.places.size();
        std::vector<Row> rows(n, Row(n + 1));
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                rows[i][j] = phi(shape_, data_.places[i], data_.places[j]);
            }
            rows[i][n] = data_.values[i][band];
        }
        reduce(rows);
        long double sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            sum += rows[i][n] / rows[i][i] * phi(shape_, place, data_.places[i]);
        }
        return double(sum);
    }

  private:
    static void reduce(std::vector<Row>& rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            std::size_t pivot = i;
            for (std::size_t k = i; k < rows.size(); ++k) {
                if (std::abs(rows[k][i]) > std::abs(rows[pivot][i])) pivot = k;
            }
            std::swap(rows[i], rows[pivot]);
            for (std::size_t k = 0; k < rows.size(); ++k) {
                if (k == i) continue;
                const long double factor = rows[k][i] / rows[i][i];
                for (std::size_t j = i; j < rows[k].size(); ++j) rows[k][j] -= factor * rows[i][j];
            }
        }
    }

    Data data_;
    FieldShape shape_;
};

}  // namespace

TEST_CASE("the field is (M15), by Gauss-Jordan in long doubles, and meets its values") {
    Random random(61);
    for (const FieldShape& shape : {FieldShape{}, FieldShape{32, 0}, FieldShape{4, 1}}) {
        const Data data = randomData(random, 30);
        const SampleField field(data.places, data.values, shape);
        const BruteField brute(data, shape);
        for (std::size_t k = 0; k < data.places.size(); ++k) {
            // The condition of Φ here is below 10³, and the values below 0.3: 10³ · 30 · 2⁻⁵³.
            CHECK(maxDifference(field.at(data.places[k]), data.values[k]) <= 1e-11);
        }
        for (int i = 0; i < 20; ++i) {
            const Imath::V3d place(random(0, 50), random(-40, 40), random(-40, 40));
            const auto band = std::size_t(random(0, kBandCount));
            CHECK(std::abs(field.at(place)[band] - brute.at(place, band)) <= 1e-11);
        }
    }
}

TEST_CASE("what the others say in closed form is what a field of the others says") {
    Random random(62);
    const Data data = randomData(random, 25);
    const FieldShape shape{16, 0.3};
    const auto leftOut = SampleField(data.places, data.values, shape).leftOut(data.values);
    for (std::size_t k = 0; k < data.places.size(); ++k) {
        Data others = data;
        others.places.erase(others.places.begin() + std::ptrdiff_t(k));
        others.values.erase(others.values.begin() + std::ptrdiff_t(k));
        const SampleField field(others.places, others.values, shape);
        CHECK(maxDifference(leftOut[k], field.at(data.places[k])) <= 1e-11);
    }
}

TEST_CASE("far away the field fades, and a place that is given twice does no harm") {
    Random random(63);
    Data data = randomData(random, 5);
    const SampleField once(data.places, data.values, {});
    CHECK(maxDifference(once.at({2000, 0, 0}), Spectrum{}) <= 1e-100);
    data.places.push_back(data.places[2]);
    data.values.push_back(data.values[2]);
    const SampleField twice(data.places, data.values, {});
    for (std::size_t k = 0; k < data.places.size(); ++k) {
        CHECK(maxDifference(twice.at(data.places[k]), data.values[k]) <= 1e-11);
    }
    CHECK(SampleField({}, {}, {}).at({1, 2, 3}) == Spectrum{});
}
