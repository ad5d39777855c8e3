// SPDX-License-Identifier: Apache-2.0
// Eigenvectors on the smallest closed set around the middle, carried on to all points that the ring's cells need.
#include <solidsubdiv/kit/analysis/characteristic_map.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <solidsubdiv/kit/analysis/internal/neighborhood.h>

namespace SolidSubdiv::Analysis {

namespace {

using Matrix = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Calls body(vertices) for the control cells of a level, or for its faces; the vertices of a general polyhedron come
/// once a face.
template <class Body>
void ForEachCell(const Far::TopologyRefiner& refiner, int l, int dimension, Body&& body) {
    const auto rows = [&](const Array<Index>& vertices, std::size_t arity) {
        for (std::size_t i = 0; i < vertices.size(); i += arity) {
            body(std::span<const Index>(vertices.data() + i, arity));
        }
    };
    if (!refiner.is_polyhedral()) {
        const Far::Level& level = refiner.level(l);
        if (dimension == 2) return rows(level.boundary_vertices, 3);
        rows(level.tet_vertices, 4);
        return rows(level.oct_vertices, 6);
    }
    const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(l);
    if (dimension == 2) return rows(level.boundary_vertices, 4);
    rows(level.hex_vertices, 8);
    const Vtr::Polyhedra& p = level.polyhedra;
    for (Index c = 0; c < p.size(); ++c) {
        const Offset begin = p.face_vertex_offsets[p.offsets[c]], end = p.face_vertex_offsets[p.offsets[c + 1]];
        body(std::span<const Index>(p.face_vertices.data() + begin, static_cast<std::size_t>(end - begin)));
    }
}

/// Vertices of the cells beyond the n_inner-th ring of cells around vertex 0 up to the n_outer-th.
std::vector<Index> RingVertices(const Far::TopologyRefiner& refiner, int level, int dimension, int n_inner,
                                int n_outer) {
    const auto n = static_cast<std::size_t>(refiner.n_vertices(level));
    constexpr int kFar = 1 << 20;
    std::vector<int> distance(n, kFar);  // in rings of cells
    distance[0] = 0;
    for (int ring = 1; ring <= n_outer; ++ring) {
        ForEachCell(refiner, level, dimension, [&](std::span<const Index> cell) {
            const bool touches = std::any_of(cell.begin(), cell.end(), [&](Index v) { return distance[v] < ring; });
            if (!touches) return;
            for (Index v : cell) distance[v] = std::min(distance[v], ring);
        });
    }
    std::vector<Index> vertices;
    for (std::size_t v = 0; v < n; ++v) {
        if (distance[v] >= n_inner && distance[v] <= n_outer) vertices.push_back(static_cast<Index>(v));
    }
    return vertices;
}

/// What the values at `vertices` are made of, each once.
std::vector<Index> SourcesOf(const std::vector<Index>& vertices, const Far::StencilRows<double>& rows) {
    std::vector<bool> is_source(static_cast<std::size_t>(rows.n_sources), false);
    for (Index v : vertices) {
        for (Index s : rows.Indices(v)) is_source[s] = true;
    }
    std::vector<Index> sources;
    for (Index s = 0; s < rows.n_sources; ++s) {
        if (is_source[s]) sources.push_back(s);
    }
    return sources;
}

/// Eigenvectors of a real eigenvalue, of length 1 and at right angles: fewer columns than its multiplicity where the
/// matrix lacks some.
Matrix Eigenvectors(const RowMajor& m, double value, int multiplicity) {
    Eigen::FullPivLU<Matrix> lu(m - value * Matrix::Identity(m.rows(), m.rows()));
    // Zero up to round-off of eigenvalues, the mean of a cluster included, for other pivots are about as large as
    // distances of eigenvalues, of which 1e-4 and less make a cluster. (BDCSVD of Eigen 3.4 is wrong where many
    // singular values are alike, JacobiSVD takes minutes.)
    lu.setThreshold(1e-9);
    const Eigen::Index n = std::min<Eigen::Index>(lu.dimensionOfKernel(), multiplicity);
    if (n == 0) return Matrix(m.rows(), 0);
    const Eigen::HouseholderQR<Matrix> qr(lu.kernel().leftCols(n));
    return qr.householderQ() * Matrix::Identity(m.rows(), n);
}

/// An eigenvector and its eigenvalue.
struct Function {
    double value;
    Eigen::VectorXd at;
};

/// Those of spectrum[1, end). Fewer where some lack.
std::vector<Function> FirstFunctions(const RowMajor& m, const Spectrum& spectrum, std::size_t end) {
    std::vector<Function> functions;
    for (std::size_t i = 1; i < end; ++i) {
        const Matrix x = Eigenvectors(m, spectrum[i].value.real(), spectrum[i].multiplicity);
        for (Eigen::Index k = 0; k < x.cols(); ++k) functions.push_back({spectrum[i].value.real(), x.col(k)});
    }
    return functions;
}

using Steps = std::vector<std::pair<std::size_t, std::size_t>>;

/// The first two functions after 1 that are constant along an edge, and the first that is not.
std::vector<Function> FunctionsOfEdge(const RowMajor& m, const Spectrum& spectrum, const Steps& steps,
                                      EdgeEigenvalues& edge) {
    std::vector<Function> across, along;
    const auto note = [](std::vector<Function>& chosen, std::size_t wanted, double& last, double& next, double value,
                         const Eigen::VectorXd& x) {
        if (chosen.size() < wanted) {
            chosen.push_back({value, x});
            last = value;
        } else {
            next = std::max(next, std::abs(value));
        }
    };
    for (std::size_t i = 1; i < spectrum.size(); ++i) {
        if (across.size() == 2 && along.size() == 1 && edge.next_across > 0 && edge.next_along > 0) break;
        const double value = spectrum[i].value.real();
        const bool is_complex = std::abs(spectrum[i].value.imag()) > 1e-7;  // means of clusters have round-off
        const Matrix x = is_complex ? Matrix(m.rows(), 0) : Eigenvectors(m, value, spectrum[i].multiplicity);
        if (x.cols() < spectrum[i].multiplicity) {  // complex, or too few: it may be either
            edge.next_across = std::max(edge.next_across, std::abs(spectrum[i].value));
            edge.next_along = std::max(edge.next_along, std::abs(spectrum[i].value));
        }
        const bool some_is_next = edge.next_across > 0 || edge.next_along > 0;
        if ((across.size() < 2 && some_is_next) || (along.empty() && edge.next_along > 0)) break;  // not separated
        if (x.cols() == 0) continue;
        Matrix change(static_cast<Eigen::Index>(steps.size()), x.cols());
        for (std::size_t k = 0; k < steps.size(); ++k) {
            change.row(static_cast<Eigen::Index>(k)) =
                x.row(static_cast<Eigen::Index>(steps[k].second)) - x.row(static_cast<Eigen::Index>(steps[k].first));
        }
        const Eigen::JacobiSVD<Matrix> svd(change, Eigen::ComputeFullV);
        constexpr double kZero = 1e-7;  // eigenvectors of length 1 are known to about 1e-12 by the gap of 1e-4
        for (Eigen::Index k = 0; k < x.cols(); ++k) {
            const bool is_constant = k >= svd.singularValues().size() || svd.singularValues()(k) < kZero;
            const Eigen::VectorXd function = x * svd.matrixV().col(k);
            if (is_constant) {
                note(across, 2, edge.across, edge.next_across, value, function);
            } else {
                note(along, 1, edge.along, edge.next_along, value, function);
            }
        }
    }
    across.insert(across.end(), along.begin(), along.end());
    return across;
}

/// A function on the first points of a closed set continued to all. Empty where an eigenvalue of the outer points alone
/// makes that arbitrary.
Eigen::VectorXd Continued(const RowMajor& m, const Function& function) {
    const Eigen::Index n_core = function.at.size(), n_rest = m.rows() - n_core;
    Eigen::VectorXd x(m.rows());
    x.head(n_core) = function.at;
    if (n_rest > 0) {
        const Matrix rest = function.value * Matrix::Identity(n_rest, n_rest) - m.bottomRightCorner(n_rest, n_rest);
        x.tail(n_rest) = rest.partialPivLu().solve(m.bottomLeftCorner(n_rest, n_core) * function.at);
    }
    const double residual = (m * x - function.value * x).cwiseAbs().maxCoeff();
    if (!(residual < 1e-8 * std::max(1.0, x.cwiseAbs().maxCoeff()))) return {};
    return x;
}

/// The values of some vertices of the next level; the others are no numbers.
std::vector<double> Refined(const std::vector<double>& points, std::size_t width, const Far::StencilRows<double>& rows,
                            const std::vector<Index>& vertices) {
    std::vector<double> next(width * static_cast<std::size_t>(rows.n_rows()), kNan);
    for (Index v : vertices) {
        const auto indices = rows.Indices(v);
        const auto weights = rows.Weights(v);
        for (std::size_t i = 0; i < width; ++i) {
            double sum = 0;
            for (std::size_t s = 0; s < indices.size(); ++s) {
                sum += weights[s] * points[width * static_cast<std::size_t>(indices[s]) + i];
            }
            next[width * static_cast<std::size_t>(v) + i] = sum;
        }
    }
    return next;
}

double Determinant(const std::vector<double>& x, int dimension, Index o, Index a, Index b, Index c) {
    const auto d = static_cast<std::size_t>(dimension);
    const auto at = [&](Index v, std::size_t i) {
        return x[d * static_cast<std::size_t>(v) + i] - x[d * static_cast<std::size_t>(o) + i];
    };
    if (dimension == 2) return at(a, 0) * at(b, 1) - at(a, 1) * at(b, 0);
    return at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) -
           at(a, 1) * (at(b, 0) * at(c, 2) - at(b, 2) * at(c, 0)) +
           at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
}

/// Of the trilinear map at the middle: the means of the four edges of each direction.
double HexCentre(const std::vector<double>& x, std::span<const Index> v) {
    const auto mean = [&](std::array<int, 4> from, std::array<int, 4> to) {
        std::array<double, 3> sum{};
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                sum[i] +=
                    (x[3 * static_cast<std::size_t>(v[to[k]]) + i] - x[3 * static_cast<std::size_t>(v[from[k]]) + i]) /
                    4;
            }
        }
        return sum;
    };
    const auto a = mean({0, 3, 4, 7}, {1, 2, 5, 6}), b = mean({0, 1, 4, 5}, {3, 2, 7, 6}),
               c = mean({0, 1, 2, 3}, {4, 5, 6, 7});
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

CharacteristicMap SampleJacobians(const Far::TopologyRefiner& refiner, int level, const std::vector<double>& points,
                                  int dimension) {
    std::vector<double> samples;
    const auto add = [&](Index o, Index a, Index b, Index c) {
        samples.push_back(Determinant(points, dimension, o, a, b, c));
    };
    ForEachCell(refiner, level, dimension, [&](std::span<const Index> v) {
        const auto is_known = [&](Index i) { return std::isfinite(points[static_cast<std::size_t>(i * dimension)]); };
        if (!std::all_of(v.begin(), v.end(), is_known)) return;
        if (dimension == 2) {
            const std::size_t n = v.size();
            for (std::size_t k = 0; k < (n == 3 ? 1 : n); ++k) add(v[k], v[(k + 1) % n], v[(k + n - 1) % n], 0);
        } else if (v.size() == 4) {
            add(v[0], v[1], v[2], v[3]);
        } else if (v.size() == 6) {
            for (const auto& t : Sdc::Oct::tets) add(v[t[0]], v[t[1]], v[t[2]], v[t[3]]);
        } else if (v.size() == 8) {
            for (int k = 0; k < 4; ++k) {
                add(v[k], v[(k + 1) % 4], v[(k + 3) % 4], v[k + 4]);
                add(v[k + 4], v[(k + 3) % 4 + 4], v[(k + 1) % 4 + 4], v[k]);
            }
            samples.push_back(HexCentre(points, v));
        }  // what is left of other polyhedra is a corner of the ring, surrounded by hexahedra
    });
    CharacteristicMap map;
    if (samples.empty()) return map;
    double sum = 0;
    for (double s : samples) sum += s;
    for (double& s : samples) s = sum < 0 ? -s : s;
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    map.smallest = *low;
    map.largest = *high;
    map.n_samples = static_cast<int>(samples.size());
    return map;
}

bool EdgeEigenvalues::is_separated() const {
    constexpr double kTolerance = 1e-6;  // of eigenvalues that are compared
    return across > std::max(next_across, next_along) + kTolerance && along > next_along + kTolerance;
}

std::optional<CharacteristicMap> MakeCharacteristicMap(const Far::TopologyRefiner& refiner, const Star& star,
                                                       const Sdc::Scheme& scheme, const Spectrum& spectrum,
                                                       const MapLevels& levels, bool sorts_edge) {
    const int last = levels.max_level(), ring_level = levels.ring_level, dimension = star.dimension;
    const Far::StencilTable table = Far::StencilTable::Create(refiner, scheme);
    const Internal::Neighborhood neighborhood(refiner, 0, 0, ring_level, star.is_on_edge);
    const auto core = neighborhood.Close(Internal::RingOf(refiner, ring_level, 0), table.level(ring_level + 1));
    if (!core) return std::nullopt;

    const auto d = static_cast<std::size_t>(dimension);
    CharacteristicMap map;
    const Eigen::Map<const RowMajor> core_matrix(core->weights.data(), core->size(), core->size());
    std::vector<Function> functions;
    if (!sorts_edge) {
        functions = FirstFunctions(core_matrix, spectrum, SeparationOf(spectrum, dimension).end);
    } else {
        map.edge.emplace();
        functions = FunctionsOfEdge(core_matrix, spectrum, neighborhood.StepsAlong(core->ring), *map.edge);
    }
    map.is_defective = functions.size() < d;
    if (map.is_defective || (map.edge && !map.edge->is_separated())) return map;

    // What the ring's cells are made of, level by level back.
    std::vector<std::vector<Index>> needed(static_cast<std::size_t>(levels.n_splits) + 1);
    const int n_outer = 1 << levels.n_splits;
    needed.back() = RingVertices(refiner, last, dimension, n_outer / 2, n_outer);
    for (int k = levels.n_splits; k > 0; --k) {
        needed[static_cast<std::size_t>(k) - 1] =
            SourcesOf(needed[static_cast<std::size_t>(k)], table.level(ring_level + k));
    }
    std::vector<Index> start = core->ring;
    std::vector<bool> is_there(static_cast<std::size_t>(refiner.n_vertices(ring_level)), false);
    for (Index v : start) is_there[v] = true;
    std::copy_if(needed[0].begin(), needed[0].end(), std::back_inserter(start), [&](Index v) { return !is_there[v]; });
    const auto closed = neighborhood.Close(std::move(start), table.level(ring_level + 1));
    if (!closed) return std::nullopt;

    const Eigen::Map<const RowMajor> m(closed->weights.data(), closed->size(), closed->size());
    std::vector<double> points(d * is_there.size(), kNan);
    for (std::size_t i = 0; i < d; ++i) {
        const Eigen::VectorXd x = Continued(m, functions[i]);
        if (x.size() == 0) return std::nullopt;
        for (std::size_t r = 0; r < closed->ring.size(); ++r) {
            points[d * static_cast<std::size_t>(closed->ring[r]) + i] = x(static_cast<Eigen::Index>(r));
        }
    }
    for (int k = 1; k <= levels.n_splits; ++k) {
        points = Refined(points, d, table.level(ring_level + k), needed[static_cast<std::size_t>(k)]);
    }
    const std::optional<EdgeEigenvalues> edge = map.edge;
    map = SampleJacobians(refiner, last, points, dimension);
    map.edge = edge;
    return map;
}

}  // namespace SolidSubdiv::Analysis
