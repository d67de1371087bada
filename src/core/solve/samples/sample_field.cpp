#include "solve/samples/sample_field.h"

#include <cmath>
#include <utility>

namespace specbake::internal {
namespace {

/// Below this a pivot is rounding (Φ has a diagonal of 1 + ω): the place is another's, and the
/// sample gets no coefficient.
constexpr double kLeastPivot = 1e-12;

/// a −= factor b
void subtract(Spectrum& a, double factor, const Spectrum& b) {
    for (std::size_t m = 0; m < a.size(); ++m) a[m] -= factor * b[m];
}

void divide(Spectrum& a, double divisor) {
    for (double& value : a) value = divisor > 0 ? value / divisor : 0;
}

}  // namespace

double FieldShape::at(double distance) const {
    return std::exp(-distance / range) + weight * std::exp(-distance);
}

SampleField::SampleField(std::vector<Imath::V3d> places, const std::vector<Spectrum>& values,
                         const FieldShape& shape)
    : shape_(shape),
      places_(std::move(places)),
      factor_(places_.size() * places_.size()),
      coefficients_(values) {
    factorise();
    solveInPlace();
}

/// Cholesky, row by row.
void SampleField::factorise() {
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = shape_.at((places_[i] - places_[j]).length());
            for (std::size_t k = 0; k < j; ++k) sum -= factor(i, k) * factor(j, k);
            if (j < i) {
                factor(i, j) = factor(j, j) > 0 ? sum / factor(j, j) : 0;
            } else {
                factor(i, i) = sum > kLeastPivot ? std::sqrt(sum) : 0;
            }
        }
    }
}

/// L y = b, Lᵀ c = y.
void SampleField::solveInPlace() {
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            subtract(coefficients_[i], factor(i, k), coefficients_[k]);
        divide(coefficients_[i], factor(i, i));
    }
    for (std::size_t i = size(); i-- > 0;) {
        for (std::size_t k = i + 1; k < size(); ++k) {
            subtract(coefficients_[i], factor(k, i), coefficients_[k]);
        }
        divide(coefficients_[i], factor(i, i));
    }
}

Spectrum SampleField::at(const Imath::V3d& place) const {
    Spectrum v{};
    for (std::size_t k = 0; k < size(); ++k) {
        subtract(v, -shape_.at((place - places_[k]).length()), coefficients_[k]);
    }
    return v;
}

/// (Φ⁻¹)_kk = |L⁻¹ e_k|²
double SampleField::inverseDiagonal(std::size_t k) const {
    std::vector<double> column(size(), 0);
    double sum = 0;
    for (std::size_t i = k; i < size(); ++i) {
        double value = i == k ? 1 : 0;
        for (std::size_t j = k; j < i; ++j) value -= factor(i, j) * column[j];
        column[i] = factor(i, i) > 0 ? value / factor(i, i) : 0;
        sum += column[i] * column[i];
    }
    return sum;
}

std::vector<Spectrum> SampleField::leftOut(const std::vector<Spectrum>& values) const {
    std::vector<Spectrum> others = values;
    for (std::size_t k = 0; k < size(); ++k) {
        const double diagonal = inverseDiagonal(k);
        if (diagonal > 0) subtract(others[k], 1 / diagonal, coefficients_[k]);
    }
    return others;
}

}  // namespace specbake::internal
