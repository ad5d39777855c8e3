// SPDX-License-Identifier: Apache-2.0
// Eigenvalues by Eigen's dense solver.
#include <solidsubdiv/kit/analysis/spectrum.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace SolidSubdiv::Analysis {

namespace {

/// Takes a value and all that a chain of neighbours within the tolerance joins to it; their mean is the eigenvalue.
Eigenvalue TakeCluster(std::vector<std::complex<double>>& values, double tolerance) {
    std::vector<std::complex<double>> cluster{values.back()};
    values.pop_back();
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
        const std::complex<double> centre = cluster[i];
        sum += centre;
        const auto is_far = [&](const auto& v) { return std::abs(v - centre) > tolerance; };
        const auto near_ones = std::stable_partition(values.begin(), values.end(), is_far);
        cluster.insert(cluster.end(), near_ones, values.end());
        values.erase(near_ones, values.end());
    }
    return {sum / static_cast<double>(cluster.size()), static_cast<int>(cluster.size())};
}

constexpr double kTolerance = 1e-6;  // of eigenvalues that are compared; QR finds simple ones to 1e-12

bool Settles(const Spectrum& spectrum) {
    return !spectrum.empty() && std::abs(spectrum[0].value - 1.0) <= kTolerance && spectrum[0].multiplicity == 1 &&
           (spectrum.size() == 1 || std::abs(spectrum[1].value) <= 1 - kTolerance);
}

}  // namespace

Spectrum SpectrumOf(const Far::LocalMatrix& matrix, double tolerance) {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor> m(matrix.weights.data(), matrix.size(), matrix.size());
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(m, false);
    if (solver.info() != Eigen::Success) throw SolverError("the eigenvalues of a local matrix did not converge");
    const auto& found = solver.eigenvalues();
    std::vector<std::complex<double>> values(found.data(), found.data() + found.size());
    Spectrum spectrum;
    while (!values.empty()) spectrum.push_back(TakeCluster(values, tolerance));
    std::sort(spectrum.begin(), spectrum.end(), [](const Eigenvalue& a, const Eigenvalue& b) {
        // Rounded: conjugate pairs, and 1/4 beside -1/4, must not swap by round-off.
        const auto key = [](auto z) { return std::make_tuple(-std::round(std::abs(z) * 1e9), -z.real(), -z.imag()); };
        return key(a.value) < key(b.value);
    });
    return spectrum;
}

Separation SeparationOf(const Spectrum& spectrum, int dimension) {
    Separation s;
    s.settles = Settles(spectrum);
    if (!s.settles) return s;
    int n = 0;
    s.is_positive = true;
    for (s.end = 1; s.end < spectrum.size() && n < dimension; ++s.end) {
        const Eigenvalue& e = spectrum[s.end];
        n += e.multiplicity;
        s.is_positive = s.is_positive && std::abs(e.value.imag()) < kTolerance && e.value.real() > kTolerance;
        s.smallest = std::abs(e.value);
    }
    s.largest = spectrum.size() > 1 ? std::abs(spectrum[1].value) : 0;
    s.next = n > dimension ? s.smallest : s.end < spectrum.size() ? std::abs(spectrum[s.end].value) : 0;
    s.is_separated = n == dimension && s.is_positive && s.smallest > s.next + kTolerance;
    s.is_even = s.is_separated && s.end == 2;
    return s;
}

std::string SpectrumText(const Spectrum& spectrum, std::size_t n_shown) {
    std::string text;
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
        if (i == n_shown) return text + " ...";
        const Eigenvalue& e = spectrum[i];
        char number[64];
        const double x = e.value.real(), scaled = std::round(x * 64);
        if (std::abs(e.value.imag()) > 1e-7) {
            std::snprintf(number, sizeof number, "%.5g%+.5gi", x, e.value.imag());
        } else if (std::abs(x - scaled / 64) < 1e-7 && scaled != 0) {
            int top = static_cast<int>(scaled), bottom = 64;
            while (top % 2 == 0 && bottom > 1) top /= 2, bottom /= 2;
            if (bottom == 1) {
                std::snprintf(number, sizeof number, "%d", top);
            } else {
                std::snprintf(number, sizeof number, "%d/%d", top, bottom);
            }
        } else {
            std::snprintf(number, sizeof number, "%.5g", std::abs(x) < 1e-7 ? 0.0 : x);
        }
        text += (text.empty() ? "" : ", ") + std::string(number);
        if (e.multiplicity > 1) text += " x " + std::to_string(e.multiplicity);
    }
    return text;
}

}  // namespace SolidSubdiv::Analysis
