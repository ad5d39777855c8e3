// SPDX-License-Identifier: Apache-2.0
// Cells cut into tets, and tables to the limits of their vertices.
#include <solidsubdiv/kit/geometry/tessellation_inside.h>

#include <algorithm>
#include <utility>

#include <solidsubdiv/kit/geometry/limits_of_vertices.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry {

namespace {

/// Joins an apex to the faces of a cell that do not have it, each cut from its lowest vertex.
class Fan {
  public:
    Fan(Index apex, std::vector<Index>& tets) : apex_(apex), tets_(tets) {}

    /// @param face counterclockwise from outside
    void Add(std::span<const Index> face) {
        if (std::find(face.begin(), face.end(), apex_) != face.end()) return;
        const std::size_t n = face.size();
        const auto low = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
        for (std::size_t k = 1; k + 1 < n; ++k) {
            tets_.insert(tets_.end(), {apex_, face[low], face[(low + k) % n], face[(low + k + 1) % n]});
        }
    }

  private:
    const Index apex_;
    std::vector<Index>& tets_;
};

void CutHex(std::span<const Index> v, std::vector<Index>& tets) {
    Fan fan(*std::min_element(v.begin(), v.end()), tets);
    for (const auto& face : Sdc::Hex::faces)
        fan.Add(std::array<Index, 4>{v[face[0]], v[face[1]], v[face[2]], v[face[3]]});
}

void CutPolyhedron(const Vtr::Polyhedra& cells, Index cell, std::vector<Index>& tets) {
    const auto face = [&](Offset f) {
        const Offset begin = cells.face_vertex_offsets[f], end = cells.face_vertex_offsets[f + 1];
        return std::span<const Index>(cells.face_vertices.data() + begin, static_cast<std::size_t>(end - begin));
    };
    const Offset first = cells.offsets[cell], last = cells.offsets[cell + 1];
    Index apex = face(first)[0];
    for (Offset f = first; f < last; ++f) {
        for (Index v : face(f)) apex = std::min(apex, v);
    }
    Fan fan(apex, tets);
    for (Offset f = first; f < last; ++f) fan.Add(face(f));
}

}  // namespace

std::vector<Index> CutIntoTets(const Far::TopologyRefiner& refiner, int level) {
    std::vector<Index> tets;
    if (refiner.is_polyhedral()) {
        const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
        tets.resize(24 * static_cast<std::size_t>(l.n_hexes));
        Sdc::ParallelFor(l.n_hexes, 1024, [&](Offset begin, Offset end) {
            std::vector<Index> cut;
            for (auto h = static_cast<std::size_t>(begin); h < static_cast<std::size_t>(end); ++h) {
                cut.clear();
                CutHex({l.hex_vertices.data() + 8 * h, 8}, cut);
                std::copy(cut.begin(), cut.end(), tets.begin() + static_cast<std::ptrdiff_t>(24 * h));
            }
        });
        for (Index p = 0; p < l.n_polyhedra(); ++p) CutPolyhedron(l.polyhedra, p, tets);
        return tets;
    }
    const Far::Level& l = refiner.level(level);
    tets.assign(l.tet_vertices.begin(), l.tet_vertices.end());
    tets.reserve(4 * (static_cast<std::size_t>(l.n_tets) + 4 * static_cast<std::size_t>(l.n_octs)));
    for (Index o = 0; o < l.n_octs; ++o) {
        const auto v = l.OctVertices(o);
        for (const auto& tet : Sdc::Oct::tets) {
            for (Sdc::Local k : tet) tets.push_back(v[k]);
        }
    }
    return tets;
}

InnerTessellation TessellateInside(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level,
                                   const Progress& progress) {
    if (level < 0 || level > refiner.max_level()) {
        throw InvalidInput("there is no level " + std::to_string(level) + "; the last is " +
                           std::to_string(refiner.max_level()));
    }
    VertexLimits limits = LimitsOfVertices(refiner, scheme, level);
    const auto cascade = Far::StencilTable::Create(refiner, scheme, {.max_level = level, .progress = progress});
    std::vector<Far::StencilRows<double>> steps;
    for (int l = 1; l <= level; ++l) steps.push_back(cascade.level(l));
    steps.push_back(std::move(limits.rows));
    return {CutIntoTets(refiner, level), Far::StencilTable::FromRows(refiner.n_vertices(0), std::move(steps)),
            std::move(limits.without_limit)};
}

}  // namespace SolidSubdiv::Geometry
