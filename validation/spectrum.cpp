// SPDX-License-Identifier: Apache-2.0
// Spectra by Eigen's QR iteration for real nonsymmetric matrices.
#include "spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace SolidSubdiv::Validation {
namespace {

using Complex = std::complex<double>;

// Takes the values that a chain of neighbours nearer than the tolerance connects with `seed` out of `values`.
std::vector<Complex> TakeGroup(std::vector<Complex>& values, Complex seed, double tolerance) {
    std::vector<Complex> group = {seed};
    for (std::size_t done = 0; done < group.size(); ++done) {
        const Complex centre = group[done];
        const auto far = [&](const Complex& v) { return std::abs(v - centre) > tolerance; };
        const auto near_ones = std::stable_partition(values.begin(), values.end(), far);
        group.insert(group.end(), near_ones, values.end());
        values.erase(near_ones, values.end());
    }
    return group;
}

// Moduli within the tolerance are equal: -1/4 and 1/4, or the two of a conjugate pair, must not swap places by
// round-off.
void Sort(std::vector<Eigenvalue>& spectrum, double tolerance) {
    std::stable_sort(spectrum.begin(), spectrum.end(),
                     [](const Eigenvalue& a, const Eigenvalue& b) { return std::abs(a.value) > std::abs(b.value); });
    for (auto first = spectrum.begin(); first != spectrum.end();) {
        const double modulus = std::abs(first->value);
        const auto last = std::find_if(first, spectrum.end(),
                                       [&](const Eigenvalue& e) { return modulus - std::abs(e.value) > tolerance; });
        std::stable_sort(first, last, [&](const Eigenvalue& a, const Eigenvalue& b) {
            return a.value.real() != b.value.real() ? a.value.real() > b.value.real() : a.value.imag() > b.value.imag();
        });
        first = last;
    }
}

}  // namespace

std::vector<Eigenvalue> Spectrum(const std::vector<double>& matrix, int n, double tolerance) {
    if (n < 1 || matrix.size() != static_cast<std::size_t>(n) * n)
        throw std::invalid_argument("spectrum: " + std::to_string(matrix.size()) +
                                    " entries given for a square matrix of size " + std::to_string(n));
    if (!std::all_of(matrix.begin(), matrix.end(), [](double entry) { return std::isfinite(entry); }))
        throw std::invalid_argument("spectrum: the matrix has an entry that is not finite");
    if (!(tolerance >= 0)) throw std::invalid_argument("spectrum: the tolerance must not be negative");

    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::MatrixXd dense = Eigen::Map<const RowMajor>(matrix.data(), n, n);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(dense, false);
    if (solver.info() != Eigen::Success) throw std::runtime_error("spectrum: the QR iteration did not converge");

    std::vector<Complex> values(solver.eigenvalues().data(), solver.eigenvalues().data() + n);
    std::vector<Eigenvalue> spectrum;
    while (!values.empty()) {
        const Complex seed = values.back();
        values.pop_back();
        const std::vector<Complex> group = TakeGroup(values, seed, tolerance);
        Complex sum = 0;
        for (const Complex& v : group) sum += v;
        const int multiplicity = static_cast<int>(group.size());
        spectrum.push_back({sum / static_cast<double>(multiplicity), multiplicity});
    }
    Sort(spectrum, tolerance);
    return spectrum;
}

}  // namespace SolidSubdiv::Validation
