// SPDX-License-Identifier: Apache-2.0
// Checks of elements before any level is built, shared by both splits.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/vtr/edge_graph.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Far::Internal {

inline std::string Name(const char* kind, Offset i) { return std::string(kind) + " " + std::to_string(i); }

template <class Vertices>
std::string List(const Vertices& vertices) {
    std::string text = "(";
    for (Index v : vertices) text += (text.size() > 1 ? " " : "") + std::to_string(v);
    return text + ")";
}

/// One kind of element with a fixed number of vertices.
class KindCheck {
  public:
    KindCheck(const char* name, std::span<const Index> vertices, int arity, Index n_vertices, DefectList& defects)
        : name_(name), vertices_(vertices), arity_(arity), n_vertices_(n_vertices), defects_(defects) {}

    void Indices() const {
        if (vertices_.size() % arity_ != 0) {
            defects_.Add(DefectCode::BadOffsets, kNoIndex, static_cast<double>(vertices_.size()),
                         std::string(name_) + ": " + std::to_string(vertices_.size()) + " indices are no multiple of " +
                             std::to_string(arity_));
            return;
        }
        const Offset n = static_cast<Offset>(vertices_.size()) / arity_;
        for (Offset i = 0; i < n; ++i) {
            Vertices(name_, i, vertices_.subspan(i * arity_, arity_), n_vertices_, defects_);
        }
    }
    /// Whether an element's vertices are there, each once.
    static void Vertices(const char* name, Offset i, std::span<const Index> row, Index n_vertices,
                         DefectList& defects) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            const auto here = row.begin() + static_cast<std::ptrdiff_t>(k);
            if (row[k] < 0 || row[k] >= n_vertices) {
                defects.Add(DefectCode::IndexOutOfRange, i, row[k],
                            Name(name, i) + " names vertex " + std::to_string(row[k]) + ", but vertices are 0 to " +
                                std::to_string(n_vertices - 1));
            } else if (std::find(row.begin(), here, row[k]) != here) {
                defects.Add(DefectCode::RepeatedVertex, i, row[k],
                            Name(name, i) + " " + List(row) + " names vertex " + std::to_string(row[k]) + " twice");
            }
        }
    }

    /// @pre Indices() found nothing
    template <std::size_t N>
    void Duplicates() const {
        const Offset n = static_cast<Offset>(vertices_.size() / N);
        const auto tuple = [&](Offset i) {
            std::array<Index, N> t;
            std::copy_n(vertices_.begin() + i * static_cast<Offset>(N), N, t.begin());
            return t;
        };
        const Vtr::UniqueTuples<N> unique(n_vertices_, n, tuple);
        if (unique.size() == n) return;
        std::vector<Index> first(unique.size(), kNoIndex);
        for (Offset i = 0; i < n; ++i) {
            Index& f = first[unique.ids[i]];
            if (f != kNoIndex) {
                defects_.Add(DefectCode::DuplicateElement, i, f,
                             Name(name_, i) + " has the same vertices as " + Name(name_, f) + " " + List(tuple(i)));
            } else {
                f = static_cast<Index>(i);
            }
        }
    }

  private:
    const char* name_;
    std::span<const Index> vertices_;
    int arity_;
    Index n_vertices_;
    DefectList& defects_;
};

/// Creases and corners: indices, lengths, values.
void CheckCreases(const TopologyDescriptor& descriptor, DefectList& defects);

/// Edges that lie on edges of faces, but for creases.
void AddCoincidentEdges(const TopologyDescriptor& descriptor, const std::vector<Index>& edges, DefectList& defects);

/// Edges and vertices that are not manifold, vertices in no element.
void AddManifoldDefects(const Vtr::EdgeGraph& graph, DefectList& defects);

}  // namespace SolidSubdiv::Far::Internal
