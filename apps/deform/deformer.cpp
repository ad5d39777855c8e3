// SPDX-License-Identifier: Apache-2.0
// The cascade, then cells and rows; and who touches whom, for updates.
#include <solidsubdiv/apps/deform/deformer.h>

#include <solidsubdiv/apps/deform/internal/grouped_rows.h>
#include <solidsubdiv/apps/deform/internal/kernels.h>
#include <solidsubdiv/apps/deform/internal/touch.h>
#include <solidsubdiv/apps/deform/internal/used_columns.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace SolidSubdiv::Deform {

using namespace Internal;

namespace {

template <class Real>
Far::StencilRows<Real> ConvertedRows(const Far::StencilRows<double>& rows) {
    Far::StencilRows<Real> result;
    result.n_sources = rows.n_sources;
    result.offsets = rows.offsets;
    result.indices = rows.indices;
    result.weights = Converted<Real>(rows.weights);
    return result;
}

/// Numbers the patch points of the tables anew.
template <class Real>
std::vector<GroupedRows<Real>> GroupedCascade(EmbeddingTables& t) {
    std::vector<GroupedRows<Real>> cascade;
    std::vector<Index> numbers;
    for (const auto& level : t.cascade) cascade.emplace_back(level, numbers);
    if (numbers.empty()) return cascade;
    for (Array<Index>* indices : {&t.hexes.corners, &t.tets.corners, &t.rows.indices}) {
        for (Index& i : *indices) i = numbers[static_cast<std::size_t>(i)];
    }
    return cascade;
}

}  // namespace

template <class Real>
struct DeformerReal<Real>::State {
    explicit State(EmbeddingTables t)
        : n_points(t.n_points),
          n_control_points(t.n_control_points),
          used(KeepUsedControlPoints(t)),
          cascade(GroupedCascade<Real>(t)),
          hexes(t.hexes),
          tets(t.tets),
          rows(ConvertedRows<Real>(t.rows)),
          row_points(t.row_points),
          outside(t.outside) {
        values.emplace_back(4 * static_cast<std::size_t>(used.size()));
        for (const auto& level : cascade) values.emplace_back(4 * static_cast<std::size_t>(level.n_rows()));
    }

    static constexpr Offset kGrain = 2048;  // points

    const Real* patch() const { return values.back().data(); }

    void CopyControl(std::span<const Real> control) {
        for (Index place = 0; place < used.size(); ++place) CopyControl(control, place);
    }
    void CopyControl(std::span<const Real> control, Index place) {
        const Real* const from = &control[3 * static_cast<std::size_t>(used[place])];
        Real* const to = &values[0][4 * static_cast<std::size_t>(place)];
        std::copy_n(from, 3, to);
        to[3] = 0;
    }

    void Refine() {
        for (std::size_t l = 0; l < cascade.size(); ++l) cascade[l].Eval(values[l], values[l + 1]);
    }

    template <int kCorners>
    void MoveCells(const Cells<Real, kCorners>& cells, Real* points) const {
        // A few cells may hold all points: work is shared by points. Some ten microseconds each.
        Sdc::ParallelFor(static_cast<Offset>(cells.points.size()), kGrain, [&](Offset first, Offset last) {
            const Index begin = static_cast<Index>(first), end = static_cast<Index>(last);
            Index cell = static_cast<Index>(std::upper_bound(cells.offsets.begin(), cells.offsets.end(), begin) -
                                            cells.offsets.begin()) -
                         1;
            for (Index i = begin; i < end; ++cell) {
                const Index cell_end = std::min(end, cells.offsets[cell + 1]);
                MoveCell(cells, cell, patch(), i, cell_end, points);
                i = cell_end;
            }
        });
    }

    void MoveRow(Index row, Real* points) const {
        typename Four<Real>::Type sum;
        SumRow(rows, row, patch(), sum);
        Store<Real>(sum, row_points[row], points);
    }

    void MoveOutside(const OutsidePoint& out, Real* points) const {
        Real* const x = points + 3 * static_cast<Offset>(out.point);
        const Real factor = static_cast<Real>(out.factor);
        for (std::size_t c = 0; c < 3; ++c) {
            const Real constant = static_cast<Real>(out.constant[c]);
            x[c] = factor == 0 ? constant : factor * x[c] + constant;
        }
    }

    void Move(Real* points) const {
        MoveCells(hexes, points);
        MoveCells(tets, points);
        Sdc::ParallelFor(rows.n_rows(), kGrain, [&](Offset begin, Offset end) {
            for (Offset row = begin; row < end; ++row) MoveRow(static_cast<Index>(row), points);
        });
        for (const OutsidePoint& out : outside) MoveOutside(out, points);
    }

    /// Who touches whom.
    struct Relations {
        std::vector<Users> rows_of;  ///< of each level's sources: rows that use them
        Users hexes_of, tets_of, rows_of_patch;
        std::vector<TouchSet> touched;  ///< of each level's rows
        TouchSet hexes, tets, rows;
        std::vector<Index> outside_of;  ///< of each point: its place in `outside`, or kNoIndex; empty: none is
    };

    static Users UsersOfRows(const GroupedRows<Real>& rows) {
        return MakeUsers(rows.n_sources(), [&](auto&& add) {
            for (Index row = 0; row < rows.n_rows(); ++row) {
                rows.ForEachTerm(row, [&](Index source, Real) { add(source, row); });
            }
        });
    }
    static Users UsersOfRows(const Far::StencilRows<Real>& rows) {
        return MakeUsers(rows.n_sources, [&](auto&& add) {
            for (Index row = 0; row < rows.n_rows(); ++row) {
                for (Index source : rows.Indices(row)) add(source, row);
            }
        });
    }
    template <int kCorners>
    Users UsersOfCells(const Cells<Real, kCorners>& cells) const {
        return MakeUsers(static_cast<Index>(values.back().size() / 4), [&](auto&& add) {
            for (Index i = 0; i < static_cast<Index>(cells.corners.size()); ++i) add(cells.corners[i], i / kCorners);
        });
    }

    Relations& GetRelations() {
        if (relations) return *relations;
        relations = std::make_unique<Relations>();
        Relations& r = *relations;
        for (const auto& level : cascade) {
            r.rows_of.push_back(UsersOfRows(level));
            r.touched.emplace_back(level.n_rows());
        }
        r.hexes_of = UsersOfCells(hexes);
        r.tets_of = UsersOfCells(tets);
        r.hexes = TouchSet(hexes.n_cells());
        r.tets = TouchSet(tets.n_cells());
        if (rows.n_rows() > 0) r.rows_of_patch = UsersOfRows(rows);
        r.rows = TouchSet(rows.n_rows());
        if (!outside.empty()) {
            r.outside_of.assign(static_cast<std::size_t>(n_points), kNoIndex);
            for (std::size_t i = 0; i < outside.size(); ++i) {
                r.outside_of[static_cast<std::size_t>(outside[i].point)] = static_cast<Index>(i);
            }
        }
        return r;
    }

    /// Follows moved control points up. change(level, row) is called for every row touched, then cell or row of the
    /// last stage by the others.
    template <class OnRow, class OnHex, class OnTet, class OnLastRow>
    void Follow(std::span<const Index> moved, OnRow&& on_row, OnHex&& on_hex, OnTet&& on_tet, OnLastRow&& on_last_row) {
        Relations& r = GetRelations();
        const auto to_next = [&](std::size_t level, Index source) {
            if (level < cascade.size()) {
                for (Index row : r.rows_of[level][source]) r.touched[level].Add(row);
                return;
            }
            for (Index hex : r.hexes_of[source]) r.hexes.Add(hex);
            for (Index tet : r.tets_of[source]) r.tets.Add(tet);
            if (rows.n_rows() == 0) return;
            for (Index row : r.rows_of_patch[source]) r.rows.Add(row);
        };
        for (Index i : moved) {
            const Index place = used.PlaceOf(i);
            if (place != kNoIndex) to_next(0, place);
        }
        for (std::size_t l = 0; l < cascade.size(); ++l) {
            r.touched[l].Drain([&](Index row) {
                on_row(l, row);
                to_next(l + 1, row);
            });
        }
        r.hexes.Drain(on_hex);
        r.tets.Drain(on_tet);
        r.rows.Drain(on_last_row);
    }

    void RequireIndices(std::span<const Index> control_points) const {
        for (Index i : control_points) {
            if (i < 0 || i >= n_control_points) {
                throw InvalidInput("control point " + std::to_string(i) + " is not among the " +
                                   std::to_string(n_control_points));
            }
        }
    }
    void RequireFit(std::size_t n_control_numbers, std::size_t n_point_numbers) const {
        const auto require = [](std::size_t n, Index expected, const char* what) {
            if (n != 3 * static_cast<std::size_t>(expected)) {
                throw InvalidInput(std::to_string(n) + " coordinates are given for " + std::to_string(expected) + what);
            }
        };
        require(n_control_numbers, n_control_points, " control points");
        require(n_point_numbers, n_points, " points");
    }

    Index n_points, n_control_points;
    UsedColumns used;  ///< the control points that something reads
    std::vector<GroupedRows<Real>> cascade;
    Cells<Real, 8> hexes;
    Cells<Real, 4> tets;
    Far::StencilRows<Real> rows;
    Array<Index> row_points;
    std::vector<OutsidePoint> outside;
    std::vector<Array<Real>> values;  ///< of those, and rows of each level: (n, 4), the last of four unused
    bool has_values = false;
    std::unique_ptr<Relations> relations;
    std::vector<Index> changed;
};

template <class Real>
DeformerReal<Real>::DeformerReal(const Embedding& embedding) : state_(std::make_unique<State>(embedding.tables())) {}
template <class Real>
DeformerReal<Real>::~DeformerReal() = default;
template <class Real>
DeformerReal<Real>::DeformerReal(DeformerReal&&) noexcept = default;
template <class Real>
DeformerReal<Real>& DeformerReal<Real>::operator=(DeformerReal&&) noexcept = default;

template <class Real>
Index DeformerReal<Real>::n_points() const {
    return state_->n_points;
}
template <class Real>
Index DeformerReal<Real>::n_control_points() const {
    return state_->n_control_points;
}

template <class Real>
void DeformerReal<Real>::Deform(std::span<const Real> control_points, std::span<Real> points) {
    State& s = *state_;
    s.RequireFit(control_points.size(), points.size());
    s.CopyControl(control_points);
    s.Refine();
    s.Move(points.data());
    s.has_values = true;
}

template <class Real>
std::span<const Index> DeformerReal<Real>::Update(std::span<const Index> moved, std::span<const Real> control_points,
                                                  std::span<Real> points) {
    State& s = *state_;
    s.RequireFit(control_points.size(), points.size());
    s.RequireIndices(moved);
    if (!s.has_values) throw InvalidInput("an update needs a Deform before it");
    for (Index i : moved) {
        const Index place = s.used.PlaceOf(i);
        if (place != kNoIndex) s.CopyControl(control_points, place);
    }
    s.changed.clear();
    const auto take_cell = [&](const auto& cells, Index cell) {
        MoveCell(cells, cell, s.patch(), cells.offsets[cell], cells.offsets[cell + 1], points.data());
        s.changed.insert(s.changed.end(), cells.points.begin() + cells.offsets[cell],
                         cells.points.begin() + cells.offsets[cell + 1]);
    };
    s.Follow(
        moved,
        [&](std::size_t l, Index row) {
            typename Four<Real>::Type sum;
            SumRow(s.cascade[l], row, s.values[l].data(), sum);
            std::memcpy(&s.values[l + 1][4 * static_cast<std::size_t>(row)], &sum, sizeof sum);
        },
        [&](Index hex) { take_cell(s.hexes, hex); }, [&](Index tet) { take_cell(s.tets, tet); },
        [&](Index row) {
            s.MoveRow(row, points.data());
            s.changed.push_back(s.row_points[row]);
        });
    const std::vector<Index>& outside_of = s.relations->outside_of;
    if (!outside_of.empty()) {
        for (Index point : s.changed) {
            const Index out = outside_of[static_cast<std::size_t>(point)];
            if (out != kNoIndex) s.MoveOutside(s.outside[static_cast<std::size_t>(out)], points.data());
        }
    }
    return s.changed;
}

template <class Real>
std::vector<Index> DeformerReal<Real>::Affected(std::span<const Index> control_points) {
    State& s = *state_;
    s.RequireIndices(control_points);
    std::vector<Index> points;
    const auto take_cell = [&](const auto& cells, Index cell) {
        points.insert(points.end(), cells.points.begin() + cells.offsets[cell],
                      cells.points.begin() + cells.offsets[cell + 1]);
    };
    s.Follow(
        control_points, [](std::size_t, Index) {}, [&](Index hex) { take_cell(s.hexes, hex); },
        [&](Index tet) { take_cell(s.tets, tet); }, [&](Index row) { points.push_back(s.row_points[row]); });
    std::sort(points.begin(), points.end());
    return points;
}

template <class Real>
Offset DeformerReal<Real>::Bytes() const {
    const State& s = *state_;
    Offset bytes = PointBytes();
    for (const auto& level : s.cascade) bytes += level.Bytes();
    for (const auto& values : s.values) bytes += static_cast<Offset>(values.size() * sizeof(Real));
    return bytes;
}

template <class Real>
Offset DeformerReal<Real>::PointBytes() const {
    const State& s = *state_;
    return s.hexes.Bytes() + s.tets.Bytes() + s.rows.Bytes() +
           static_cast<Offset>(s.row_points.size() * sizeof(Index) + s.outside.size() * sizeof(OutsidePoint));
}

template class DeformerReal<double>;
template class DeformerReal<float>;

}  // namespace SolidSubdiv::Deform
