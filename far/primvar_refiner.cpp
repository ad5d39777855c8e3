// SPDX-License-Identifier: Apache-2.0
// Rows made, applied and forgotten.
#include <solidsubdiv/far/primvar_refiner.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/scheme_check.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far {

namespace {

constexpr Offset kGrain = 2048;

/// Elements of three values at distances of four, which are loaded at once.
template <class Real>
Array<Real> PadToFour(const Real* source, Index n) {
    Array<Real> padded(4 * static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            std::copy(source + 3 * i, source + 3 * i + 3, padded.data() + 4 * i);
            padded[4 * i + 3] = 0;
        }
    });
    return padded;
}

/// Sums rows of values of which three are wanted.
///
/// Vectors are the compilers' own (GCC, clang): left to themselves they handle two of three values at once. They are of
/// 16 bytes, which every processor has: longer ones go through memory where there are none.
template <class Real>
class SumThree {
  public:
    explicit SumThree(const Array<Real>& padded) : padded_(padded.data()) {}
    /// Sums the entries that visit(add) adds, unless it returns false.
    template <class Visit>
    bool operator()(Real* destination, Visit&& visit) const {
        Vector sums[kVectors] = {};
        const auto add = [&](Index i, Real weight) {
            const Real* const from = padded_ + 4 * static_cast<Offset>(i);
            for (int k = 0; k < kVectors; ++k) {
                Vector values;
                std::memcpy(&values, from + k * kLanes, sizeof values);
                sums[k] += weight * values;
            }
        };
        if (!visit(add)) return false;
        for (int c = 0; c < 3; ++c) destination[c] = sums[c / kLanes][c % kLanes];
        return true;
    }

  private:
    static constexpr int kBytes = 16, kLanes = kBytes / sizeof(Real), kVectors = 4 / kLanes;
    typedef Real Vector __attribute__((vector_size(kBytes)));
    const Real* padded_;
};

/// The same for any width.
template <class Real>
class Sum {
  public:
    Sum(const Real* source, int width) : source_(source), sum_(static_cast<std::size_t>(width)) {}
    template <class Visit>
    bool operator()(Real* destination, Visit&& visit) {
        std::fill(sum_.begin(), sum_.end(), Real{0});
        const auto add = [&](Index i, Real weight) {
            const Real* const from = source_ + static_cast<std::size_t>(i) * sum_.size();
            for (std::size_t c = 0; c < sum_.size(); ++c) sum_[c] += weight * from[c];
        };
        if (!visit(add)) return false;
        std::copy(sum_.begin(), sum_.end(), destination);
        return true;
    }

  private:
    const Real* source_;
    std::vector<Real> sum_;
};

/// One kind of rows, summed one by one as they are visited, or if they aren't, as they are filled.
template <class Real, class Visit, class MaxLength, class Fill, class SumFunction>
void InterpolateRows(Index n, const Visit& visit, const MaxLength& max_length, const Fill& fill,
                     const SumFunction& sum_function, Real* destination, int width) {
    Sdc::ParallelFor(n, kGrain, [=](Offset begin, Offset end) {
        std::vector<Index> indices;
        std::vector<Real> weights;
        Internal::RowScratch scratch;
        SumFunction sum = sum_function;
        for (Offset i = begin; i < end; ++i) {
            const Index row = static_cast<Index>(i);
            Real* const to = destination + i * width;
            if (sum(to, [&](auto& add) { return visit(row, add); })) continue;
            if (const std::size_t room = max_length(row); room > indices.size()) {
                indices.resize(2 * room);
                weights.resize(2 * room);
            }
            const int length = fill(row, indices.data(), weights.data(), scratch);
            sum(to, [&](auto& add) {
                for (int k = 0; k < length; ++k) add(indices[k], weights[k]);
                return true;
            });
        }
    });
}

template <class Real, class Scheme, class SumFunction>
void InterpolateChildren(const Level& parent, const Internal::Rows<Scheme>& of_level, const SumFunction& sum,
                         const Real* source, Real* destination, int width) {
    const Internal::Rows<Scheme>* const rows = &of_level;
    if constexpr (Internal::Rows<Scheme>::kVerticesStay) {
        Sdc::ParallelFor(static_cast<Offset>(parent.n_vertices) * width, kGrain, [&](Offset begin, Offset end) {
            std::copy(source + begin, source + end, destination + begin);
        });
    } else {
        InterpolateRows(
            parent.n_vertices, [rows](Index v, auto& add) { return rows->template VisitVertex<Real>(v, add); },
            [rows](Index v) { return rows->MaxVertexLength(v); },
            [rows](Index v, Index* indices, Real* weights, auto&) { return rows->FillVertex(v, indices, weights); },
            sum, destination, width);
    }
    destination += static_cast<Offset>(rows->ChildOfEdge(0)) * width;
    InterpolateRows(
        parent.n_edges, [rows](Index e, auto& add) { return rows->template VisitEdge<Real>(e, add); },
        [rows](Index e) { return rows->MaxEdgeLength(e); },
        [rows](Index e, Index* indices, Real* weights, auto& scratch) {
            return rows->FillEdge(e, indices, weights, scratch);
        },
        sum, destination, width);
    destination += static_cast<Offset>(parent.n_edges) * width;
    InterpolateRows(
        parent.n_octs, [rows](Index o, auto& add) { return rows->template VisitOct<Real>(o, add); },
        [rows](Index) { return rows->MaxOctLength(); },
        [rows](Index o, Index* indices, Real* weights, auto& scratch) {
            return rows->FillOct(o, indices, weights, scratch);
        },
        sum, destination, width);
}

/// Values at the vertices of a level, then at the centroids of its faces, then of its cells: elements of `width`
/// numbers, or of kPadded where that is not 0, the last of them 0.
template <int kPadded, class Real>
Array<Real> WithCentroids(const Vtr::PolyhedralLevel& level, const Real* source, int width) {
    const int stride = kPadded > 0 ? kPadded : width;
    const Offset first_face = level.n_vertices, first_cell = first_face + level.n_faces;
    Array<Real> values(static_cast<std::size_t>((first_cell + level.n_cells()) * stride));
    const auto at = [&](Offset i) { return values.data() + i * stride; };
    Sdc::ParallelFor(level.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) {
            std::copy(source + v * width, source + (v + 1) * width, at(v));
            std::fill(at(v) + width, at(v) + stride, Real{0});
        }
    });
    const auto set_mean = [&](Offset i, std::span<const Index> vertices) {
        Real* const mean = at(i);
        const Real share = Real{1} / static_cast<Real>(vertices.size());
        for (int c = 0; c < stride; ++c) mean[c] = share * at(vertices[0])[c];
        for (Index v : vertices.subspan(1)) {
            const Real* const from = at(v);
            for (int c = 0; c < stride; ++c) mean[c] += share * from[c];
        }
    };
    Sdc::ParallelFor(level.n_faces, kGrain, [&](Offset begin, Offset end) {
        for (Offset f = begin; f < end; ++f) set_mean(first_face + f, level.FaceVertices(static_cast<Index>(f)));
    });
    Sdc::ParallelFor(level.n_cells(), kGrain, [&](Offset begin, Offset end) {
        for (Offset c = begin; c < end; ++c) set_mean(first_cell + c, level.CellVertices(static_cast<Index>(c)));
    });
    return values;
}

/// Adds what makes a new point (centroid_rules.h) up from the numbers of WithCentroids.
template <class Real, class AddFunction>
struct ValueRow {
    AddFunction& add;
    Index first_face, first_cell;

    void Add(Index v, double weight) { add(v, static_cast<Real>(weight)); }
    void AddFace(Index f, double weight) { add(first_face + f, static_cast<Real>(weight)); }
    void AddCell(Index c, double weight) { add(first_cell + c, static_cast<Real>(weight)); }
};

template <class Real, class SumFunction>
void SumFromCentroids(const Internal::PolyhedralRows& rows, const SumFunction& sum_function, Real* destination,
                      int width) {
    const Internal::CentroidRules& rules = rows.rules();
    const Vtr::PolyhedralLevel& level = rules.level();
    const bool is_averaged = rules.rules().solid == Sdc::PolyhedralRule::Averaged;
    Sdc::ParallelFor(rows.n_children(), kGrain, [&](Offset begin, Offset end) {
        SumFunction sum = sum_function;
        for (Offset i = begin; i < end; ++i) {
            const Index child = static_cast<Index>(i);
            sum(destination + i * width, [&]<class Add>(Add& add) {
                ValueRow<Real, Add> row{add, level.n_vertices, level.n_vertices + level.n_faces};
                // Averages over new cells take less among hexahedra than their centroids do.
                if (is_averaged && rows.Visit(child, [&](Index v, double weight) { row.Add(v, weight); })) return true;
                rules.Add(child, row);
                return true;
            });
        }
    });
}

template <class Real, class Scheme>
void InterpolateLevel(const Level& parent, const Internal::Rows<Scheme>& rows, const Real* source, Real* destination,
                      int width) {
    if (width == 3) {
        const Array<Real> padded = PadToFour(source, parent.n_vertices);
        InterpolateChildren(parent, rows, SumThree<Real>(padded), source, destination, width);
    } else {
        InterpolateChildren(parent, rows, Sum<Real>(source, width), source, destination, width);
    }
}

template <class Real>
void InterpolateLevel(const Vtr::PolyhedralLevel& parent, const Internal::PolyhedralRows& rows, const Real* source,
                      Real* destination, int width) {
    if (width == 3) {
        const Array<Real> values = WithCentroids<4>(parent, source, width);
        SumFromCentroids(rows, SumThree<Real>(values), destination, width);
    } else {
        const Array<Real> values = WithCentroids<0>(parent, source, width);
        SumFromCentroids(rows, Sum<Real>(values.data(), width), destination, width);
    }
}

}  // namespace

PrimvarRefiner::PrimvarRefiner(const TopologyRefiner& refiner, const Sdc::Scheme& scheme)
    : refiner_(refiner), scheme_(scheme) {
    Internal::CheckScheme(refiner, scheme);
}

template <class Real>
void PrimvarRefiner::Interpolate(int level, std::span<const Real> source, std::span<Real> destination,
                                 int width) const {
    if (level < 1 || level > refiner_.max_level()) {
        throw InvalidInput("values of level " + std::to_string(level) + " are asked for; levels are 1 to " +
                           std::to_string(refiner_.max_level()));
    }
    const auto require = [&](std::size_t size, Index n, const char* name) {
        if (width < 1 || size != static_cast<std::size_t>(n) * static_cast<std::size_t>(width)) {
            throw InvalidInput(std::string(name) + " has " + std::to_string(size) + " numbers; " + std::to_string(n) +
                               " vertices of width " + std::to_string(width) + " are needed");
        }
    };
    require(source.size(), refiner_.n_vertices(level - 1), "the source");
    require(destination.size(), refiner_.n_vertices(level), "the destination");
    const Sharpness sharpness = Internal::SharpnessOfLevels(refiner_, scheme_, level).back();
    Internal::WithRows(refiner_, level - 1, sharpness, scheme_, [&]<class AnyRows>(const AnyRows& rows) {
        if constexpr (std::is_same_v<AnyRows, Internal::PolyhedralRows>) {
            InterpolateLevel(refiner_.polyhedral_level(level - 1), rows, source.data(), destination.data(), width);
        } else {
            InterpolateLevel(refiner_.level(level - 1), rows, source.data(), destination.data(), width);
        }
    });
}

template void PrimvarRefiner::Interpolate(int, std::span<const double>, std::span<double>, int) const;
template void PrimvarRefiner::Interpolate(int, std::span<const float>, std::span<float>, int) const;

}  // namespace SolidSubdiv::Far
