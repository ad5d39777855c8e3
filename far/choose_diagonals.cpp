// SPDX-License-Identifier: Apache-2.0
// Diagonals by a search that makes as many faces as possible agree, by length, or as given.
#include <solidsubdiv/far/choose_diagonals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Far {

namespace {

using Vtr::Level;

constexpr int kPairs = 3;

/// Vertex orders that bring pair p to the front and keep orientation.
constexpr std::array<std::array<Sdc::Local, 4>, kPairs> kTetOrders{{{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}}};
constexpr std::array<std::array<Sdc::Local, 6>, kPairs> kOctOrders{
    {{0, 1, 2, 3, 4, 5}, {2, 3, 4, 5, 0, 1}, {4, 5, 0, 1, 2, 3}}};

/// The pair of a tet that edge (a, b) belongs to.
constexpr int PairOfTetEdge(int a, int b) { return a == 0 || b == 0 ? a + b - 1 : 5 - a - b; }

/// Cells with their neighbours across inner faces. A choice names one edge of each of the cell's faces:
/// edge_of[c][f][p] is which (by the rank of the vertex that it lies opposite to). Tets come first, then octs.
class MatchGraph {
  public:
    explicit MatchGraph(const Level& level) : level_(level) {
        const Offset n_cells = level.n_cells();
        std::vector<std::array<Offset, 2>> sides(level.n_faces, {kNone, kNone});
        first_side_.resize(static_cast<std::size_t>(n_cells) + 1);
        for (Offset c = 0; c <= n_cells; ++c) {
            first_side_[c] = c <= level.n_tets ? 4 * c : 4 * static_cast<Offset>(level.n_tets) + 8 * (c - level.n_tets);
        }
        edge_of_.resize(first_side_.back());
        neighbor_.assign(first_side_.back(), kNone);
        cell_of_.resize(first_side_.back());
        for (Offset c = 0; c < n_cells; ++c) {
            for (Offset s = first_side_[c]; s < first_side_[c + 1]; ++s) {
                const int f = static_cast<int>(s - first_side_[c]);
                const Index face = IsTet(c) ? level.TetFaces(Tet(c))[f] : level.OctFaces(Oct(c))[f];
                edge_of_[s] = IsTet(c) ? TetEdgeOf(Tet(c), f, face) : OctEdgeOf(Oct(c), f, face);
                cell_of_[s] = static_cast<Index>(c);
                auto& pair = sides[face];
                (pair[0] == kNone ? pair[0] : pair[1]) = s;
            }
        }
        for (const auto& pair : sides) {
            if (pair[1] == kNone) continue;
            neighbor_[pair[0]] = pair[1];
            neighbor_[pair[1]] = pair[0];
            ++n_inner_faces_;
        }
    }

    Offset n_cells() const { return level_.n_cells(); }
    Offset n_inner_faces() const { return n_inner_faces_; }

    /// For each pair, with how many neighbours (of those chosen already: choice < kPairs) cell c would agree.
    std::array<int, kPairs> Agreements(Offset c, const std::vector<std::uint8_t>& choice) const {
        std::array<int, kPairs> count{};
        for (Offset s = first_side_[c]; s < first_side_[c + 1]; ++s) {
            const Offset t = neighbor_[s];
            if (t == kNone || choice[cell_of_[t]] >= kPairs) continue;
            const std::uint8_t wanted = edge_of_[t][choice[cell_of_[t]]];
            for (int p = 0; p < kPairs; ++p) count[p] += edge_of_[s][p] == wanted;
        }
        return count;
    }

    Offset CountMatched(const std::vector<std::uint8_t>& choice) const {
        Offset twice = 0;
        for (Offset c = 0; c < n_cells(); ++c) twice += Agreements(c, choice)[choice[c]];
        return twice / 2;
    }

    template <class Function>
    void ForEachNeighbor(Offset c, Function&& function) const {
        for (Offset s = first_side_[c]; s < first_side_[c + 1]; ++s) {
            if (neighbor_[s] != kNone) function(static_cast<Offset>(cell_of_[neighbor_[s]]));
        }
    }

  private:
    static constexpr Offset kNone = -1;
    using Ranks = std::array<std::uint8_t, kPairs>;

    bool IsTet(Offset c) const { return c < level_.n_tets; }
    static Index Tet(Offset c) { return static_cast<Index>(c); }
    Index Oct(Offset c) const { return static_cast<Index>(c - level_.n_tets); }

    std::uint8_t RankIn(Index face, Index vertex) const {
        const auto v = level_.FaceVertices(face);
        return static_cast<std::uint8_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
    }
    /// A tet's face has one edge of each pair.
    Ranks TetEdgeOf(Index t, int f, Index face) const {
        const auto& corners = Sdc::Tet::faces[f];
        Ranks ranks{};
        for (int k = 0; k < 3; ++k) {
            ranks[PairOfTetEdge(corners[(k + 1) % 3], corners[(k + 2) % 3])] =
                RankIn(face, level_.TetVertices(t)[corners[k]]);
        }
        return ranks;
    }
    /// The edge of an oct's face that does not touch the diagonal.
    Ranks OctEdgeOf(Index o, int f, Index face) const {
        Ranks ranks{};
        for (Sdc::Local corner : Sdc::Oct::faces[f]) ranks[corner / 2] = RankIn(face, level_.OctVertices(o)[corner]);
        return ranks;
    }

    const Level& level_;
    std::vector<Offset> first_side_;
    std::vector<Ranks> edge_of_;
    std::vector<Offset> neighbor_;
    std::vector<Index> cell_of_;
    Offset n_inner_faces_ = 0;
};

/// A fixed pseudo-random sequence (SplitMix64), the same everywhere.
class Sequence {
  public:
    std::uint64_t Next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

  private:
    std::uint64_t state_ = 20020617;
};

/// Follows agreements outwards from cell `start` with its choice fixed, breadth first, over its component.
void Spread(const MatchGraph& graph, Offset start, std::uint8_t first, std::vector<std::uint8_t>& choice,
            std::vector<Offset>& component) {
    component.assign(1, start);
    choice[start] = first;
    for (std::size_t i = 0; i < component.size(); ++i) {
        graph.ForEachNeighbor(component[i], [&](Offset n) {
            if (choice[n] < kPairs) return;
            const auto count = graph.Agreements(n, choice);
            choice[n] = static_cast<std::uint8_t>(std::max_element(count.begin(), count.end()) - count.begin());
            component.push_back(n);
        });
    }
}

std::vector<std::uint8_t> Match(const MatchGraph& graph) {
    constexpr std::uint8_t kUnset = kPairs;
    std::vector<std::uint8_t> choice(graph.n_cells(), kUnset);
    std::vector<Offset> component;
    // Each component from its first cell with each of the three choices: a lattice is matched everywhere by one of
    // them.
    for (Offset c = 0; c < graph.n_cells(); ++c) {
        if (choice[c] != kUnset) continue;
        Offset best_score = -1;
        std::vector<std::uint8_t> best;
        for (std::uint8_t first = 0; first < kPairs; ++first) {
            Spread(graph, c, first, choice, component);
            Offset score = 0;
            for (Offset member : component) score += graph.Agreements(member, choice)[choice[member]];
            if (score > best_score) {
                best_score = score;
                best.clear();
                for (Offset member : component) best.push_back(choice[member]);
            }
            for (Offset member : component) choice[member] = kUnset;
        }
        for (std::size_t i = 0; i < component.size(); ++i) choice[component[i]] = best[i];
    }

    // Annealing. A worse choice by d faces is taken with probability 2^-(d * steepness), steepness rising sweep by
    // sweep; equal ones always: strict improvement alone gets stuck early. Integers only, so that every machine does
    // the same. More sweeps find a little more (500 instead of 200: under 1 % of the faces); large meshes get fewer, to
    // take seconds.
    constexpr int kSteepest = 8;
    const int n_sweeps =
        static_cast<int>(std::clamp<Offset>(20'000'000 / std::max<Offset>(1, graph.n_cells()), 20, 200));
    Sequence random;
    Offset matched = graph.CountMatched(choice), best_matched = matched;
    std::vector<std::uint8_t> best = choice;
    for (int sweep = 0; sweep < n_sweeps && best_matched < graph.n_inner_faces(); ++sweep) {
        // Steepness in 1/256ths: 2^-(d * steepness) = 2^-whole * (1 - rest / 2), about.
        const std::uint64_t steepness =
            256 + 256 * (kSteepest - 1) * static_cast<std::uint64_t>(sweep) / static_cast<std::uint64_t>(n_sweeps);
        for (Offset i = 0; i < graph.n_cells(); ++i) {
            const std::uint64_t bits = random.Next();
            const Offset c = static_cast<Offset>((bits >> 32) % static_cast<std::uint64_t>(graph.n_cells()));
            const auto count = graph.Agreements(c, choice);
            const std::uint8_t other = static_cast<std::uint8_t>((choice[c] + 1 + (bits & 1)) % kPairs);
            const int loss = count[choice[c]] - count[other];
            if (loss > 0) {
                const std::uint64_t exponent = static_cast<std::uint64_t>(loss) * steepness;
                const std::uint64_t threshold =
                    ((std::uint64_t{1} << 30) - ((exponent & 255) << 21)) >> (exponent >> 8);
                if (((bits >> 1) & ((std::uint64_t{1} << 30) - 1)) >= threshold) continue;
            }
            choice[c] = other;
            matched -= loss;
        }
        if (matched > best_matched) {
            best_matched = matched;
            best = choice;
        }
    }
    return best;
}

std::vector<std::uint8_t> ShortestPairs(const TopologyDescriptor& d, std::span<const double> positions) {
    const auto choose = [](const std::array<double, kPairs>& lengths) {
        const double bound = *std::min_element(lengths.begin(), lengths.end()) * (1 + 1e-9);
        int p = 0;
        while (lengths[p] > bound) ++p;
        return static_cast<std::uint8_t>(p);
    };
    const auto distance = [&](std::array<Index, 2> from, std::array<Index, 2> to) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) {
            const auto at = [&](Index v) {
                return positions[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(k)];
            };
            const double step = 0.5 * (at(from[0]) + at(from[1]) - at(to[0]) - at(to[1]));
            sum += step * step;
        }
        return std::sqrt(sum);
    };
    std::vector<std::uint8_t> choice;
    for (std::size_t i = 0; i < d.tets.size(); i += 4) {
        std::array<double, kPairs> lengths;
        for (int p = 0; p < kPairs; ++p) {
            const auto& order = kTetOrders[p];
            lengths[p] =
                distance({d.tets[i + order[0]], d.tets[i + order[1]]}, {d.tets[i + order[2]], d.tets[i + order[3]]});
        }
        choice.push_back(choose(lengths));
    }
    for (std::size_t i = 0; i < d.octs.size(); i += 6) {
        std::array<double, kPairs> lengths;
        for (int p = 0; p < kPairs; ++p) {
            const Index a = d.octs[i + 2 * p], b = d.octs[i + 2 * p + 1];
            lengths[p] = distance({a, a}, {b, b});
        }
        choice.push_back(choose(lengths));
    }
    return choice;
}

template <std::size_t N>
void Reorder(std::span<const Index> cells, const std::array<std::array<Sdc::Local, N>, kPairs>& orders,
             const std::uint8_t* choice, std::vector<Index>& out) {
    out.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); i += N) {
        for (Sdc::Local local : orders[choice[i / N]]) out.push_back(cells[i + local]);
    }
}

}  // namespace

DiagonalChoice ChooseDiagonals(const TopologyDescriptor& descriptor, DiagonalPolicy policy,
                               std::span<const double> positions, std::span<const std::uint8_t> given) {
    Internal::DefectList defects(1);
    Internal::CheckElements(descriptor, defects);
    Level level;
    if (!defects.has_fatal()) {
        Vtr::BaseFindings findings;
        level = Vtr::MakeBaseLevel(Internal::ElementsOf(descriptor), findings);
        Internal::AddFindings(descriptor, level, findings, defects);
    }
    if (defects.has_fatal()) throw InvalidInput(defects.TakeFatalFirst().front().text);

    const MatchGraph graph(level);
    const std::size_t n_cells = static_cast<std::size_t>(graph.n_cells());
    DiagonalChoice choice;
    switch (policy) {
        case DiagonalPolicy::Matched:
            choice.diagonals = Match(graph);
            break;
        case DiagonalPolicy::Shortest:
            if (positions.size() != 3 * static_cast<std::size_t>(descriptor.n_vertices)) {
                throw InvalidInput("shortest diagonals need the positions of all vertices");
            }
            choice.diagonals = ShortestPairs(descriptor, positions);
            break;
        case DiagonalPolicy::First:
            choice.diagonals.assign(n_cells, 0);
            break;
        case DiagonalPolicy::Given:
            if (given.size() != n_cells) {
                throw InvalidInput("given diagonals: " + std::to_string(given.size()) + " values for " +
                                   std::to_string(n_cells) + " cells");
            }
            for (std::size_t c = 0; c < n_cells; ++c) {
                if (given[c] >= kPairs) {
                    throw InvalidInput("given diagonal of cell " + std::to_string(c) + " is " +
                                       std::to_string(given[c]) + "; it must be 0, 1 or 2");
                }
            }
            choice.diagonals.assign(given.begin(), given.end());
            break;
    }
    choice.n_inner_faces = graph.n_inner_faces();
    choice.n_matched_faces = graph.CountMatched(choice.diagonals);
    Reorder(descriptor.tets, kTetOrders, choice.diagonals.data(), choice.tets);
    Reorder(descriptor.octs, kOctOrders, choice.diagonals.data() + level.n_tets, choice.octs);
    return choice;
}

DiagonalPolicy DiagonalPolicyOf(std::string_view name) {
    if (name == "matched") return DiagonalPolicy::Matched;
    if (name == "shortest") return DiagonalPolicy::Shortest;
    if (name == "first") return DiagonalPolicy::First;
    if (name == "given") return DiagonalPolicy::Given;
    throw InvalidInput("diagonals can't be '" + std::string(name) + "'; one of matched|shortest|first|given");
}

}  // namespace SolidSubdiv::Far
