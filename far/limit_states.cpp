// SPDX-License-Identifier: Apache-2.0
// A state's pocket is split as a mesh of its own; its children's pockets are found in the split.
#include <solidsubdiv/far/internal/limit_states.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/with_rows.h>
#include <solidsubdiv/vtr/base_level.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>
#include <solidsubdiv/vtr/refinement.h>

namespace SolidSubdiv::Far::Internal {

namespace {

using Coordinates = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

/// Where the vertices of an element lie in its own coordinates.
std::vector<Coordinates> CornersOf(RootKind kind, Index n) {
    switch (kind) {
        case RootKind::Tet:
            return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        case RootKind::Oct:
            return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        case RootKind::Hex:
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        default:
            if (n == 3) return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    }
}

/// How far inside an element a place is: at least 0 inside.
double Depth(RootKind kind, Index n, const Coordinates& at) {
    const auto [u, v, w] = at;
    switch (kind) {
        case RootKind::Tet:
            return std::min({u, v, w, 1 - u - v - w});
        case RootKind::Oct:
            return 1 - std::abs(u) - std::abs(v) - std::abs(w);
        case RootKind::Hex:
            return std::min({u, v, w, 1 - u, 1 - v, 1 - w});
        default:
            return n == 3 ? std::min({u, v, 1 - u - v}) : std::min({u, v, 1 - u, 1 - v});
    }
}

/// Origin and axes of an element's coordinates, given where its vertices lie.
std::array<Coordinates, 4> FrameOf(RootKind kind, std::span<const Coordinates> p) {
    const auto minus = [](const Coordinates& a, const Coordinates& b) {
        return Coordinates{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    };
    const Coordinates zero{}, up{0, 0, 1};
    switch (kind) {
        case RootKind::Tet:
            return {p[0], minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])};
        case RootKind::Oct: {
            Coordinates c;
            for (std::size_t i = 0; i < 3; ++i) c[i] = (p[0][i] + p[1][i]) / 2;
            return {c, minus(p[0], c), minus(p[2], c), minus(p[4], c)};
        }
        case RootKind::Hex:
            return {p[0], minus(p[1], p[0]), minus(p[3], p[0]), minus(p[4], p[0])};
        default:
            return {p[0], minus(p[1], p[0]), minus(p[p.size() == 3 ? 2 : 3], p[0]), up};
    }
    return {zero, zero, zero, zero};
}

Matrix Inverse(const Matrix& m) {
    Matrix inverse;
    const auto minor = [&](std::size_t r, std::size_t c) {
        const std::size_t a = (r + 1) % 3, b = (r + 2) % 3, d = (c + 1) % 3, e = (c + 2) % 3;
        return m[a][d] * m[b][e] - m[a][e] * m[b][d];
    };
    const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) inverse[r][c] = minor(c, r) / det;
    }
    return inverse;
}

/// Weights of an element's corners at a place, linear as place.h says.
struct CornerWeights {
    std::array<double, 8> weights{};
    std::size_t n = 0;
    CornerWeights(std::initializer_list<double> list) : n(list.size()) {
        std::copy(list.begin(), list.end(), weights.begin());
    }
};
CornerWeights WeightsOfCorners(RootKind kind, Index n, const Coordinates& at) {
    const auto [u, v, w] = at;
    switch (kind) {
        case RootKind::Tet:
            return {1 - u - v - w, u, v, w};
        case RootKind::Oct: {
            const double rest = 1 - std::abs(v) - std::abs(w);
            return {(rest + u) / 2,    (rest - u) / 2,   std::max(v, 0.0),
                    std::max(-v, 0.0), std::max(w, 0.0), std::max(-w, 0.0)};
        }
        case RootKind::Hex:
            return {(1 - u) * (1 - v) * (1 - w), u * (1 - v) * (1 - w), u * v * (1 - w), (1 - u) * v * (1 - w),
                    (1 - u) * (1 - v) * w,       u * (1 - v) * w,       u * v * w,       (1 - u) * v * w};
        default:
            if (n == 3) return {1 - u - v, u, v};
            return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    }
}

/// Ends of the root's edges at one of its corners.
std::vector<Index> NeighborsOf(RootKind root, Index n_root_vertices, Index corner) {
    std::vector<Index> neighbors;
    const auto add = [&](const auto& edges) {
        for (const auto& e : edges) {
            if (e[0] == corner) neighbors.push_back(e[1]);
            if (e[1] == corner) neighbors.push_back(e[0]);
        }
    };
    switch (root) {
        case RootKind::Tet:
            add(Sdc::Tet::edges);
            break;
        case RootKind::Oct:
            add(Sdc::Oct::edges);
            // Three that are independent first.
            std::swap(neighbors[1], neighbors[2]);
            break;
        case RootKind::Hex:
            add(Sdc::Hex::edges);
            break;
        default:
            neighbors = {(corner + 1) % n_root_vertices, (corner + n_root_vertices - 1) % n_root_vertices};
    }
    return neighbors;
}

}  // namespace

struct LimitState {
    explicit LimitState(const Pocket& p)
        : root(p.root), n_root_vertices(p.n_root_vertices), n_vertices(p.n_vertices()), pocket(p) {}

    const RootKind root;
    const Index n_root_vertices, n_vertices;
    Pocket pocket;  // until it is expanded
    std::optional<RegularPatch> patch;
    std::once_flag expansion, corner_flags[8];
    std::vector<Transition> children;
    RowsOfChildren rows;
    std::vector<std::array<PartHalf, 2>> parts;  // of a polyhedron
    std::vector<CornerLimit> corners;
};

/// Splits a pocket and finds what its root's children need.
class LimitStates::Expander {
  public:
    Expander(LimitStates& states, const Pocket& pocket, RowsOfChildren& rows)
        : states_(states), pocket_(pocket), table_(rows) {}

    std::vector<Transition> Run() { return pocket_.is_tet_oct ? RunTetOct() : RunPolyhedral(); }

  private:
    std::vector<Transition> RunTetOct() {
        Vtr::BaseElements elements{.n_vertices = pocket_.n_vertices()};
        elements.tets = pocket_.tets;
        elements.octs = pocket_.octs;
        elements.triangles = pocket_.faces.vertices;
        elements.edges = pocket_.edges;
        Vtr::BaseFindings findings;
        const Level parent = Vtr::MakeBaseLevel(elements, findings);
        assert(findings.IsUsable());
        const Level child = Vtr::Refine(parent, true);
        std::vector<Index> children;
        if (pocket_.root == RootKind::Tet) {
            children = {0, 1, 2, 3, child.n_tets};
        } else if (pocket_.root == RootKind::Oct) {
            for (Index i = 0; i < 8; ++i) children.push_back(4 * parent.n_tets + i);
            for (Index i = 0; i < 6; ++i) children.push_back(child.n_tets + parent.n_tets + i);
        } else {
            for (Index i = 0; i < 4; ++i) children.push_back(BoundaryFace(child, i));
        }
        return Follow(parent, child, children);
    }

    std::vector<Transition> RunPolyhedral() {
        Vtr::PolyhedralElements elements{.n_vertices = pocket_.n_vertices()};
        elements.hexes = pocket_.hexes;
        elements.cell_offsets = pocket_.cell_offsets;
        elements.face_offsets = pocket_.cell_faces.offsets;
        elements.face_vertices = pocket_.cell_faces.vertices;
        elements.polygon_offsets = pocket_.faces.offsets;
        elements.polygon_vertices = pocket_.faces.vertices;
        elements.edges = pocket_.edges;
        Vtr::PolyhedralFindings findings;
        const Vtr::PolyhedralLevel parent = Vtr::MakePolyhedralBaseLevel(elements, findings);
        assert(findings.IsUsable());
        const Vtr::PolyhedralLevel child = Vtr::Refine(parent, true);
        std::vector<Index> children;
        if (pocket_.root == RootKind::Hex) {
            for (Index i = 0; i < 8; ++i) children.push_back(i);
        } else {
            for (Index i = 0; i < pocket_.n_root_vertices; ++i) children.push_back(BoundaryFace(child, i));
        }
        return Follow(parent, child, children);
    }

    /// Faces are numbered by their vertices: the root's children come first.
    template <class AnyLevel>
    static Index BoundaryFace(const AnyLevel& level, Index face) {
        const auto found = std::lower_bound(level.boundary_faces.begin(), level.boundary_faces.end(), face);
        return static_cast<Index>(found - level.boundary_faces.begin());
    }

    template <class AnyLevel>
    std::vector<Transition> Follow(const AnyLevel& parent, const AnyLevel& child, const std::vector<Index>& children) {
        const Sharpness sharpness = SharpnessOf(parent);
        const Sdc::CreasingMethod method =
            std::visit([](const auto& s) { return CreaseOptionsOf(s).method; }, states_.scheme_);
        const Sharpness child_sharpness =
            ChildrenSharpness(Vtr::EdgeGraph(parent), child.n_edges, child.n_vertices, sharpness, method);
        PocketMaker maker(child, child_sharpness, states_.reach_, states_.elements_);
        std::vector<Transition> transitions;
        std::vector<Pocket> pockets;
        for (Index c : children) {
            pockets.push_back(maker.Make(c));
            Transition& t = transitions.emplace_back();
            SetCoordinates(parent, pockets.back(), t);
            t.state = &states_.Find(pockets.back());
        }
        std::vector<Index> number(static_cast<std::size_t>(child.n_vertices), kNoIndex);
        const auto fill = [&](const auto& rows) {
            for (std::size_t i = 0; i < transitions.size(); ++i) {
                for (Index v : pockets[i].vertices) {
                    Index& row = number[static_cast<std::size_t>(v)];
                    if (row == kNoIndex && IsKnown(parent, v)) row = AddRow(rows, v);
                    transitions[i].rows.push_back(row);
                }
            }
        };
        if constexpr (std::is_same_v<AnyLevel, Level>) {
            WithTetOctScheme(states_.scheme_, [&]<class S>(const S& s) { fill(Rows<S>(parent, sharpness, s)); });
        } else {
            WithPolyhedralScheme(states_.scheme_, [&](const auto& s) {
                fill(PolyhedralRows(parent, sharpness, s.polyhedral(), CreaseOptionsOf(s).method));
            });
        }
        return transitions;
    }

    template <class AnyLevel>
    Sharpness SharpnessOf(const AnyLevel& level) const {
        Sharpness sharpness;
        if (pocket_.crease_sharpness.empty() && pocket_.corner_sharpness.empty()) return sharpness;
        sharpness.edges.assign(static_cast<std::size_t>(level.n_edges), 0.0f);
        sharpness.vertices.assign(static_cast<std::size_t>(level.n_vertices), 0.0f);
        for (std::size_t i = 0; i < pocket_.crease_sharpness.size(); ++i) {
            const Index e = level.FindEdge(pocket_.crease_edges[2 * i], pocket_.crease_edges[2 * i + 1]);
            if (e != kNoIndex) sharpness.edges[e] = pocket_.crease_sharpness[i];
        }
        for (std::size_t i = 0; i < pocket_.corner_sharpness.size(); ++i) {
            sharpness.vertices[pocket_.corner_vertices[i]] = pocket_.corner_sharpness[i];
        }
        return sharpness;
    }

    /// Calls body(kind, vertices of the parent component that the point of a child vertex comes from).
    enum class Feature { Vertex, Edge, Face, Cell };
    template <class Body>
    static void WithFeature(const Level& parent, Index child, Body&& body) {
        if (child < parent.n_vertices) return body(Feature::Vertex, std::span<const Index>(&child, 1));
        child -= parent.n_vertices;
        if (child < parent.n_edges) return body(Feature::Edge, std::span<const Index>(parent.EdgeVertices(child)));
        // The centre lies in the middle of the major diagonal, and of all vertices as well.
        body(Feature::Cell, std::span<const Index>(parent.OctVertices(child - parent.n_edges)).first(2));
    }
    template <class Body>
    static void WithFeature(const Vtr::PolyhedralLevel& parent, Index child, Body&& body) {
        if (child < parent.n_vertices) return body(Feature::Vertex, std::span<const Index>(&child, 1));
        child -= parent.n_vertices;
        if (child < parent.n_edges) return body(Feature::Edge, std::span<const Index>(parent.EdgeVertices(child)));
        child -= parent.n_edges;
        if (child < parent.n_faces) return body(Feature::Face, parent.FaceVertices(child));
        body(Feature::Cell, parent.CellVertices(child - parent.n_faces));
    }

    /// Where the child lies in the root's coordinates, which its own come from.
    template <class AnyLevel>
    void SetCoordinates(const AnyLevel& parent, const Pocket& child, Transition& t) const {
        const std::vector<Coordinates> corners = CornersOf(pocket_.root, pocket_.n_root_vertices);
        std::vector<Coordinates> places;
        for (Index i = 0; i < child.n_root_vertices; ++i) {
            const Index v = child.vertices[static_cast<std::size_t>(i)];
            t.children.push_back(v < pocket_.n_root_vertices ? v : kNoIndex);
            WithFeature(parent, v, [&](Feature, std::span<const Index> from) {
                Coordinates mean{};
                for (Index w : from) {
                    for (std::size_t a = 0; a < 3; ++a) {
                        mean[a] += corners[static_cast<std::size_t>(w)][a] / static_cast<double>(from.size());
                    }
                }
                places.push_back(mean);
            });
        }
        const auto frame = FrameOf(child.root, places);
        Matrix axes;
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) axes[r][c] = frame[c + 1][r];
        }
        t.matrix = Inverse(axes);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) t.shift[r] -= t.matrix[r][c] * frame[0][c];
        }
    }

    bool IsKnown(Feature feature, std::span<const Index> from) const {
        const auto is_complete = [&](Index v) { return pocket_.is_complete[static_cast<std::size_t>(v)] != 0; };
        const Reach& reach = states_.reach_;
        switch (feature) {
            case Feature::Vertex:
                return reach.interpolates || is_complete(from[0]);
            case Feature::Edge:
                if (reach.edges_need_both_ends) return is_complete(from[0]) && is_complete(from[1]);
                return is_complete(from[0]) || is_complete(from[1]) || pocket_.HasCompleteEdge(from[0], from[1]);
            case Feature::Face:
                return std::any_of(from.begin(), from.end(), is_complete);
            default:
                return !reach.interpolates || std::all_of(from.begin(), from.end(), is_complete);
        }
    }

    template <class AnyLevel>
    bool IsKnown(const AnyLevel& parent, Index child) const {
        bool is_known = false;
        WithFeature(parent, child, [&](Feature f, std::span<const Index> from) { is_known = IsKnown(f, from); });
        return is_known;
    }
    template <class AnyRows>
    Index AddRow(const AnyRows& rows, Index child) {
        row_.Read(rows, child);
        table_.indices.insert(table_.indices.end(), row_.Indices().begin(), row_.Indices().end());
        table_.weights.insert(table_.weights.end(), row_.Weights().begin(), row_.Weights().end());
        table_.offsets.push_back(static_cast<std::uint32_t>(table_.indices.size()));
        return static_cast<Index>(table_.offsets.size()) - 2;
    }

    LimitStates& states_;
    const Pocket& pocket_;
    RowsOfChildren& table_;
    RowBuffer<double> row_;
};

namespace {

template <int kColumns>
bool PullColumns(const RowsOfChildren& table, const Transition& t, const LimitBlock& child, LimitBlock& parent) {
    const double* from = child.weights.data();
    for (const Index row : t.rows) {
        bool is_zero = true;
        for (int c = 0; c < kColumns; ++c) is_zero = is_zero && from[c] == 0;
        if (!is_zero) {
            if (row == kNoIndex) return false;
            for (std::uint32_t k = table.offsets[row]; k < table.offsets[row + 1]; ++k) {
                double* to = parent.weights.data() + kColumns * static_cast<std::size_t>(table.indices[k]);
                for (int c = 0; c < kColumns; ++c) to[c] += table.weights[k] * from[c];
            }
        }
        from += kColumns;
    }
    return true;
}

/// Rows of a child's vertices made rows of its parent's. False where a row that counts is not known.
bool Pull(const LimitState& state, const Transition& t, const LimitBlock& child, LimitBlock& parent) {
    parent.Reset(state.n_vertices, child.n_columns);
    switch (child.n_columns) {
        case 1:
            return PullColumns<1>(state.rows, t, child, parent);
        case 2:
            return PullColumns<2>(state.rows, t, child, parent);
        case 3:
            return PullColumns<3>(state.rows, t, child, parent);
        case 4:
            return PullColumns<4>(state.rows, t, child, parent);
        case 6:
            return PullColumns<6>(state.rows, t, child, parent);
        default:
            assert(child.n_columns == 10);
            return PullColumns<10>(state.rows, t, child, parent);
    }
}

/// The product of two changes of coordinates, the first applied first.
Matrix Multiply(const Matrix& second, const Matrix& first) {
    Matrix product{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) product[r][c] += second[r][k] * first[k][c];
        }
    }
    return product;
}

void ChangeRows(const Matrix& by, int dimension, int order, LimitBlock& block) {
    if (order == 0) return;
    const std::size_t n = block.weights.size() / static_cast<std::size_t>(block.n_columns);
    for (std::size_t p = 0; p < n; ++p) {
        ChangeCoordinates(by, dimension, order, 1,
                          block.weights.data() + p * static_cast<std::size_t>(block.n_columns));
    }
}

}  // namespace

LimitStates::LimitStates(const Sdc::Scheme& scheme, Elements elements, const Reach& reach)
    : scheme_(scheme), elements_(elements), reach_(reach), regular_(RegularRuleOf(scheme, elements)) {}

LimitStates::~LimitStates() = default;

std::size_t LimitStates::KeyHash::operator()(const std::vector<std::int32_t>& key) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15u;
    for (std::int32_t x : key) {
        hash = (hash ^ static_cast<std::uint32_t>(x)) * 0xBF58476D1CE4E5B9u;
        hash ^= hash >> 31;
    }
    return hash;
}

LimitState& LimitStates::Find(const Pocket& pocket) {
    std::vector<std::int32_t> key = pocket.Key();
    {
        std::shared_lock lock(mutex_);
        if (const auto found = states_.find(key); found != states_.end()) return *found->second;
    }
    auto state = std::make_unique<LimitState>(pocket);
    state->patch = RegularPatch::Find(pocket, regular_);
    state->corners.resize(static_cast<std::size_t>(pocket.n_root_vertices));
    bytes_ += static_cast<Offset>(key.size() * 2 * sizeof(std::int32_t) + sizeof(LimitState));
    std::unique_lock lock(mutex_);
    return *states_.emplace(std::move(key), std::move(state)).first->second;
}

std::size_t LimitStates::n_states() const {
    std::shared_lock lock(mutex_);
    return states_.size();
}

void LimitStates::Expand(LimitState& state) {
    std::call_once(state.expansion, [&] {
        state.children = Expander(*this, state.pocket, state.rows).Run();
        state.pocket = {};
        Offset bytes = state.rows.Bytes();
        for (const Transition& t : state.children) bytes += static_cast<Offset>(t.rows.size() * sizeof(Index));
        bytes_ += bytes;
    });
}

const CornerLimit& LimitStates::Corner(LimitState& state, std::size_t corner) {
    std::call_once(state.corner_flags[corner], [&] { state.corners[corner] = MakeCorner(state, corner); });
    return state.corners[corner];
}

/// The child at a corner, its child there, and so on, until one comes again: powers of what leads around say the limit.
CornerLimit LimitStates::MakeCorner(LimitState& asked, std::size_t corner) {
    struct Step {
        LimitState* state;
        std::size_t corner;
        const Transition* next;
    };
    std::vector<Step> steps;
    std::size_t first = 0;  // of the steps that come again
    for (LimitState* s = &asked;;) {
        const auto met = std::find_if(steps.begin(), steps.end(),
                                      [&](const Step& step) { return step.state == s && step.corner == corner; });
        if (met != steps.end()) {
            first = static_cast<std::size_t>(met - steps.begin());
            break;
        }
        Expand(*s);
        const Transition* next = nullptr;
        std::size_t there = 0;
        for (const Transition& t : s->children) {
            const auto found = std::find(t.children.begin(), t.children.end(), static_cast<Index>(corner));
            if (found == t.children.end()) continue;
            next = &t;
            there = static_cast<std::size_t>(found - t.children.begin());
        }
        steps.push_back({s, corner, next});
        s = next->state;
        corner = there;
    }

    const int d = elements_ == Elements::Cells ? 3 : 2;
    const Step& start = steps[first];
    const RootKind root = start.state->root;
    const Index n_root_vertices = start.state->n_root_vertices;
    const Index n = start.state->n_vertices;
    const auto around = [&](const LimitBlock& from, LimitBlock& to) {  // once around the cycle
        LimitBlock here = from;
        for (std::size_t i = steps.size(); i-- > first;) {
            if (!Pull(*steps[i].state, *steps[i].next, here, to)) return false;
            std::swap(here, to);
        }
        std::swap(here, to);
        return true;
    };
    const auto largest_change = [](const LimitBlock& a, const LimitBlock& b) {
        double largest = 0;
        for (std::size_t i = 0; i < a.weights.size(); ++i) {
            largest = std::max(largest, std::abs(a.weights[i] - b.weights[i]));
        }
        return largest;
    };
    /// Goes around until nothing changes but by round-off. None: it does not settle.
    const auto settle = [&](LimitBlock& block, auto&& after) {
        constexpr int kMaxSteps = 2000;
        LimitBlock next;
        double before = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kMaxSteps; ++i) {
            if (!around(block, next)) return LimitOutcome::Unknown;
            after(next);
            const double change = largest_change(block, next);
            std::swap(block, next);
            if (change == 0 || (change < 1e-14 && change >= before)) return LimitOutcome::Known;
            if (!(change < 1e6)) return LimitOutcome::None;
            before = change;
        }
        return LimitOutcome::None;
    };

    CornerLimit result;
    LimitBlock limit;
    limit.Reset(n, 1);
    limit.Row(static_cast<Index>(start.corner))[0] = 1;
    result.outcome = settle(limit, [](LimitBlock& block) {
        double sum = 0;
        for (double w : block.weights) sum += w;
        for (double& w : block.weights) w /= sum;
    });
    if (result.outcome != LimitOutcome::Known) return result;

    // Differences along the root's edges at the corner, scaled up as they shrink. Round-off along the limit is taken
    // out, or it would grow.
    const std::vector<Coordinates> corners = CornersOf(root, n_root_vertices);
    const std::vector<Index> neighbors = NeighborsOf(root, n_root_vertices, static_cast<Index>(start.corner));
    const int n_neighbors = static_cast<int>(neighbors.size());
    LimitBlock slopes;
    slopes.Reset(n, n_neighbors);
    for (int k = 0; k < n_neighbors; ++k) {
        slopes.Row(neighbors[static_cast<std::size_t>(k)])[k] += 1;
        slopes.Row(static_cast<Index>(start.corner))[k] -= 1;
    }
    const double scale = std::ldexp(1.0, static_cast<int>(steps.size() - first));
    const LimitOutcome slopes_settle = settle(slopes, [&](LimitBlock& block) {
        for (int k = 0; k < n_neighbors; ++k) {
            double sum = 0;
            for (Index v = 0; v < n; ++v) sum += block.Row(v)[k];
            for (Index v = 0; v < n; ++v) block.Row(v)[k] = scale * (block.Row(v)[k] - sum * limit.Row(v)[0]);
        }
    });
    if (slopes_settle == LimitOutcome::Unknown) return {};
    result.has_derivatives = slopes_settle == LimitOutcome::Known;
    result.block.Reset(n, result.has_derivatives ? 1 + d : 1);
    for (Index v = 0; v < n; ++v) result.block.Row(v)[0] = limit.Row(v)[0];
    if (result.has_derivatives) {
        // slope_k = step_k . gradient, of the first d of the edges; further ones must agree.
        Matrix steps_to{};
        for (std::size_t k = 0; k < 3; ++k) steps_to[k][k] = 1;
        const auto step_to = [&](std::size_t k, std::size_t a) {
            return corners[static_cast<std::size_t>(neighbors[k])][a] - corners[start.corner][a];
        };
        for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
            for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) steps_to[k][a] = step_to(k, a);
        }
        const Matrix inverse = Inverse(steps_to);
        for (Index v = 0; v < n; ++v) {
            double* row = result.block.Row(v);
            for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) {
                for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
                    row[1 + a] += inverse[a][k] * slopes.Row(v)[k];
                }
            }
            for (std::size_t k = static_cast<std::size_t>(d); k < neighbors.size(); ++k) {
                double slope = -slopes.Row(v)[k];
                for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) slope += step_to(k, a) * row[1 + a];
                if (std::abs(slope) > 1e-11) result.has_derivatives = false;  // linear around the corner it is not
            }
        }
    }
    // Back to the state asked for.
    LimitBlock pulled;
    for (std::size_t i = first; i-- > 0;) {
        if (!Pull(*steps[i].state, *steps[i].next, result.block, pulled)) return {};
        if (result.block.n_columns > 1) ChangeRows(steps[i].next->matrix, d, 1, pulled);
        std::swap(result.block, pulled);
    }
    return result;
}

void LimitStates::Evaluate(LimitState& start, const Place& place, int order, Scratch& scratch, LimitResult& result) {
    // Deep enough for linear interpolation between limits of corners to be exact to round-off where these are smooth,
    // and where they are not, as deep as coordinates of doubles go.
    constexpr std::size_t kSmoothDepth = 26, kMaxDepth = 60;
    const int d = elements_ == Elements::Cells ? 3 : 2;
    scratch.path.clear();
    Matrix by{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    result.outcome = LimitOutcome::Unknown;
    result.order = 0;
    LimitState* s = &start;
    Coordinates at = place.at;
    LimitBlock& block = scratch.block;
    const auto columns_of = [&](int up_to) { return 1 + NDerivatives(elements_, up_to); };
    while (true) {
        LimitState& state = *s;
        const Index n = state.n_vertices;
        if (state.patch) {
            block.Reset(n, columns_of(order));
            state.patch->Evaluate(at, order, block);
            result.outcome = LimitOutcome::Known;
            result.order = order;
            break;
        }
        const CornerWeights corners = WeightsOfCorners(state.root, state.n_root_vertices, at);
        const std::span<const double> weights(corners.weights.data(), corners.n);
        const bool is_corner = std::find(weights.begin(), weights.end(), 1.0) != weights.end();
        if (is_corner || scratch.path.size() >= kSmoothDepth) {
            result.outcome = LimitOutcome::Known;
            bool has_derivatives = true;
            for (std::size_t i = 0; i < weights.size(); ++i) {
                if (weights[i] == 0) continue;
                const CornerLimit& limit = Corner(*s, i);
                result.outcome = std::max(result.outcome, limit.outcome);
                has_derivatives = has_derivatives && limit.has_derivatives;
            }
            if (result.outcome != LimitOutcome::Known) return;
            if (is_corner || has_derivatives || scratch.path.size() >= kMaxDepth) {
                result.order = std::min(order, has_derivatives ? 1 : 0);
                block.Reset(n, columns_of(result.order));
                for (std::size_t i = 0; i < weights.size(); ++i) {
                    if (weights[i] == 0) continue;
                    const CornerLimit& limit = Corner(*s, i);
                    for (Index v = 0; v < n; ++v) {
                        for (int c = 0; c < block.n_columns; ++c) block.Row(v)[c] += weights[i] * limit.block.Row(v)[c];
                    }
                }
                break;
            }
        }
        Expand(state);
        const Transition* next = nullptr;
        double deepest = -std::numeric_limits<double>::infinity();
        Coordinates next_at{};
        for (const Transition& t : state.children) {
            Coordinates x = t.shift;
            for (std::size_t r = 0; r < 3; ++r) {
                for (std::size_t c = 0; c < 3; ++c) x[r] += t.matrix[r][c] * at[c];
            }
            const double depth = Depth(t.state->root, t.state->n_root_vertices, x);
            if (depth <= deepest) continue;
            deepest = depth;
            next = &t;
            next_at = x;
            if (depth >= 0) break;
        }
        scratch.path.push_back(next);
        by = Multiply(next->matrix, by);
        at = next_at;
        s = next->state;
    }
    ChangeRows(by, d, result.order, block);
    for (std::size_t i = scratch.path.size(); i-- > 0;) {
        const LimitState& parent = i == 0 ? start : *scratch.path[i - 1]->state;
        if (!Pull(parent, *scratch.path[i], block, result.block)) {
            result.outcome = LimitOutcome::Unknown;
            return;
        }
        std::swap(block, result.block);
    }
    std::swap(block, result.block);
}

}  // namespace SolidSubdiv::Far::Internal
