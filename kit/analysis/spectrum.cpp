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

constexpr double kTolerance = 1e-6;  // of eigenvalues that are compared

constexpr const char* kDiverges =
    "diverges or does not settle: an eigenvalue of modulus 1 or more besides the single 1";
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

Verdict VerdictOf(const Spectrum& spectrum, int dimension) {
    Verdict v;
    if (!Settles(spectrum)) {
        v.text = kDiverges;
        return v;
    }
    v.smoothness = Smoothness::C0;
    if (spectrum.size() == 1) {
        v.text = "only the vertex itself";
        return v;
    }
    const double sub = v.subdominant = std::abs(spectrum[1].value);
    char text[200];
    if (std::abs(spectrum[1].value.imag()) > kTolerance || spectrum[1].multiplicity != dimension) {
        std::snprintf(text, sizeof text, "C0: the subdominant eigenvalue %.6g has multiplicity %d, not %d", sub,
                      spectrum[1].multiplicity, dimension);
        v.text = text;
        return v;
    }
    const double next = spectrum.size() > 2 ? std::abs(spectrum[2].value) : 0, square = sub * sub;
    int n_next = 0;
    for (std::size_t i = 2; i < spectrum.size(); ++i) {
        if (std::abs(spectrum[i].value) > square - kTolerance) n_next += spectrum[i].multiplicity;
    }
    const int n_quadratics = dimension * (dimension + 1) / 2;
    if (next > square + kTolerance) {
        v.smoothness = Smoothness::C1;
        std::snprintf(text, sizeof text, "C1 spectrum, not C2: subdominant %.6g, next %.6g is above its square", sub,
                      next);
    } else if (n_next > n_quadratics) {
        v.smoothness = Smoothness::C1;
        std::snprintf(text, sizeof text,
                      "C1 spectrum, not C2: subdominant %.6g, its square has multiplicity %d, quadratics only %d", sub,
                      n_next, n_quadratics);
    } else {
        v.smoothness = Smoothness::C2;
        std::snprintf(text, sizeof text, "C2 spectrum: subdominant %.6g, next %.6g is at most its square", sub, next);
    }
    v.text = text;
    return v;
}

EdgeVerdict EdgeVerdictOf(const Spectrum& spectrum) {
    EdgeVerdict v;
    if (!Settles(spectrum)) {
        v.text = kDiverges;
        return v;
    }
    int n = 0;
    bool is_real = true;
    std::size_t i = 1;
    for (; i < spectrum.size() && n < 3; ++i) {
        n += spectrum[i].multiplicity;
        is_real = is_real && std::abs(spectrum[i].value.imag()) < kTolerance;
    }
    const double next = i < spectrum.size() ? std::abs(spectrum[i].value) : 0, last = std::abs(spectrum[i - 1].value);
    v.is_separated = n == 3 && is_real && last > next + kTolerance;
    char text[200];
    if (v.is_separated) {
        std::snprintf(text, sizeof text, "C1 spectrum: three real eigenvalues, the last %.6g, next %.6g", last, next);
    } else {
        std::snprintf(text, sizeof text,
                      "not decided by eigenvalues alone: the third after 1 is no last of three (%.6g)", last);
    }
    v.text = text;
    return v;
}

std::string SpectrumText(const Spectrum& spectrum) {
    std::string text;
    for (const Eigenvalue& e : spectrum) {
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
