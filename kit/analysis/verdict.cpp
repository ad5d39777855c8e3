// SPDX-License-Identifier: Apache-2.0
// The rules in their order: settled, separated, complete, regular, even, C2.
#include <solidsubdiv/kit/analysis/verdict.h>

#include <cmath>
#include <cstdio>

namespace SolidSubdiv::Analysis {

namespace {

constexpr double kTolerance = 1e-6;  // of eigenvalues that are compared; QR finds simple ones to 1e-12

template <class... Numbers>
std::string Format(const char* format, Numbers... numbers) {
    char text[200];
    std::snprintf(text, sizeof text, format, numbers...);
    return text;
}

/// Eigenvalues after 1 that are above or about the square of the subdominant one, with multiplicity.
int CountAbout(const Spectrum& spectrum, std::size_t first, double size) {
    int n = 0;
    for (std::size_t i = first; i < spectrum.size(); ++i) {
        if (std::abs(spectrum[i].value) > size - kTolerance) n += spectrum[i].multiplicity;
    }
    return n;
}

/// Of a separated, even spectrum.
Verdict EvenVerdict(const Spectrum& spectrum, int dimension, const Separation& s, const std::string& c1) {
    const double square = s.largest * s.largest;
    const int n_about = CountAbout(spectrum, s.end, square), n_quadratics = dimension * (dimension + 1) / 2;
    Verdict v{Smoothness::C1, s.largest, {}};
    if (s.next > square + kTolerance) {
        v.text = c1 + Format(": subdominant %.6g, next %.6g is above its square", s.largest, s.next);
    } else if (n_about > n_quadratics) {
        v.text = c1 + Format(": subdominant %.6g, its square has multiplicity %d, quadratics only %d", s.largest,
                             n_about, n_quadratics);
    } else if (std::abs(s.largest - 0.5) > kTolerance) {
        v.text = c1 + Format(": subdominant %.6g is not 1/2, next %.6g is at most its square", s.largest, s.next);
    } else {
        v.smoothness = Smoothness::C2;
        v.text = Format("C2 spectrum: subdominant %.6g, next %.6g is at most its square", s.largest, s.next);
    }
    return v;
}

}  // namespace

Verdict VerdictOf(const Spectrum& spectrum, int dimension, const std::optional<CharacteristicMap>& map) {
    const Separation s = SeparationOf(spectrum, dimension);
    if (!s.settles) {
        return {Smoothness::Diverges, 0, "diverges or does not settle: an eigenvalue of modulus 1 or more besides 1"};
    }
    const std::string count = dimension == 3 ? "three" : "two";
    const bool is_sorted = map && map->edge && map->edge->is_separated();
    Verdict v{Smoothness::C0, s.largest, {}};
    if (!s.is_positive) {
        v.text = "C0: of the " + count + " eigenvalues after 1 not all are real and positive";
    } else if (!s.is_separated && !is_sorted) {
        v.text = "C0: no " + count +
                 Format(" eigenvalues after 1 stand above the others: %.6g, next %.6g", s.smallest, s.next);
    } else if (map && map->is_defective) {
        v.text = "C0: the " + count + " eigenvalues after 1 have fewer eigenvectors";
    } else if (map && !map->is_regular()) {
        v.text = Format("C0: the characteristic map folds, its Jacobian goes from %.3g to %.3g", map->smallest,
                        map->largest);
    } else if (is_sorted) {
        const EdgeEigenvalues& e = *map->edge;
        v.smoothness = Smoothness::Uneven;
        v.text = Format("C1 uneven: shrinks by %.6g across the edge, next %.6g; by %.6g along it, next %.6g", e.across,
                        e.next_across, e.along, e.next_along);
    } else if (!s.is_even) {
        v.smoothness = Smoothness::Uneven;
        v.text = std::string(map ? "C1 uneven" : "C1 uneven by eigenvalues") +
                 Format(": shrinks by %.6g to %.6g, next %.6g", s.smallest, s.largest, s.next);
    } else {
        v = EvenVerdict(spectrum, dimension, s, map ? "C1" : "C1 spectrum");
    }
    return v;
}

std::string NameOf(Smoothness smoothness) {
    switch (smoothness) {
        case Smoothness::Diverges:
            return "diverges";
        case Smoothness::C0:
            return "C0";
        case Smoothness::Uneven:
            return "C1 uneven";
        case Smoothness::C1:
            return "C1";
        case Smoothness::C2:
            return "C2 spectrum";
    }
    return {};
}

}  // namespace SolidSubdiv::Analysis
