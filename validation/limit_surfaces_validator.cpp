// SPDX-License-Identifier: Apache-2.0
// Validator limit-surfaces: limits of surfaces and of boundaries of solids against OpenSubdiv, on shapes of ours and on
// its catalogue where it is present.
#include <algorithm>
#include <random>
#include <string_view>

#include "catalogue.h"
#include "limit_surfaces.h"
#include "meshes.h"
#include "polygon_shapes.h"
#include "sharp_features.h"
#include "solid_shapes.h"
#include "surface_compare.h"
#include "surface_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

std::vector<SurfacePlace> RandomPlaces(const BoundarySurface& surface, int n) {
    std::mt19937 random(5);
    const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    std::vector<SurfacePlace> places;
    for (int i = 0; i < n; ++i) {
        SurfacePlace p{.face = static_cast<int>(random() % surface.faces().size())};
        const std::size_t n_corners = surface.faces()[static_cast<std::size_t>(p.face)].size();
        if (!surface.is_triangular && n_corners != 4) p.corner = static_cast<int>(random() % n_corners);
        p.s = uniform();
        p.t = uniform();
        if (surface.is_triangular && p.s + p.t > 1) {
            p.s = 1 - p.s;
            p.t = 1 - p.t;
        }
        places.push_back(p);
    }
    return places;
}

/// A mesh under a scheme, and what OpenSubdiv is told of its boundary.
struct Compared {
    Far::TopologyDescriptor mesh;
    Sdc::Split split;
    Sdc::Scheme scheme;
    SurfaceTags ours{}, theirs{};  ///< by vertices of the mesh
    bool has_smooth_triangles = false;
};

Findings CompareLimits(const Compared& c, const std::vector<double>& positions) {
    Findings findings;
    const TaggedMesh tagged(c.mesh, c.ours);
    const auto refiner = Far::TopologyRefiner::Create(tagged.descriptor, c.split);
    BoundarySurface surface(refiner, positions, c.theirs);
    surface.polygons.has_smooth_triangles = c.has_smooth_triangles;
    const std::vector<SurfacePlace> places = RandomPlaces(surface, 40);
    CompareAtPlaces(MakeLimitRows(refiner, c.scheme, surface.OurPlaces(places),
                                  {.elements = Far::Elements::BoundaryFaces, .order = 2}),
                    surface, places, positions, findings);
    const auto is_fading = [](float s) { return s > 0 && s < 10; };
    const auto is_any_fading = [&](const std::vector<float>& s) { return std::any_of(s.begin(), s.end(), is_fading); };
    if (!is_any_fading(c.theirs.crease_sharpness) && !is_any_fading(c.theirs.corner_sharpness)) {
        CompareAtVertices(MakeLimitRows(refiner, c.scheme, surface.CornerPlaces(),
                                        {.elements = Far::Elements::BoundaryFaces, .order = 1, .tangents = true}),
                          surface, positions, findings);
    }
    return findings;
}

/// Why a surface can't be compared, or an empty text.
std::string ReasonToSkip(const Far::TopologyDescriptor& mesh, Sdc::Split split) {
    try {
        const auto refiner = Far::TopologyRefiner::Create(mesh, split);
        const auto graph = refiner.graph(0);
        for (std::size_t v = 0; v < graph.vertex_tags.size(); ++v) {
            if (const std::size_t n = graph.vertex_edges[static_cast<Index>(v)].size(); n > 100) {
                return "vertex " + std::to_string(v) + " has " + std::to_string(n) +
                       " edges, for whose patches OpenSubdiv takes half a minute";
            }
            if (graph.vertex_edges[static_cast<Index>(v)].size() == 2 &&
                graph.vertex_tags[v].rule() != Vtr::Rule::Curve) {
                const auto edges = graph.vertex_edges[static_cast<Index>(v)];
                if (graph.edge_faces[edges[0]].size() == 2 && graph.edge_faces[edges[1]].size() == 2) {
                    return "two faces are all around vertex " + std::to_string(v) +
                           ": OpenSubdiv's limit masks take it for a corner";
                }
            }
            if (graph.vertex_tags[v].non_manifold() && graph.vertex_tags[v].rule() == Vtr::Rule::Curve) {
                return "surfaces meet in vertex " + std::to_string(v) +
                       ", which OpenSubdiv fixes and our rule treats as a crease's";
            }
        }
    } catch (const InvalidInput& refused) {
        return std::string("refused: ") + refused.what();
    }
    return {};
}

Sdc::Loop LoopOf(const SurfaceTags& tags) {
    return {.features = tags.has_sharp_corners ? Sdc::Features::Sharp : Sdc::Features::Smooth,
            .creasing = tags.is_chaikin ? Sdc::CreasingMethod::Chaikin : Sdc::CreasingMethod::Uniform};
}
Sdc::CatmullClark CatmullClarkOf(const SurfaceTags& tags, bool smooth_triangles) {
    return {.features = tags.has_sharp_corners ? Sdc::Features::Sharp : Sdc::Features::Smooth,
            .creasing = tags.is_chaikin ? Sdc::CreasingMethod::Chaikin : Sdc::CreasingMethod::Uniform,
            .triangles = smooth_triangles ? Sdc::TriangleWeights::Smooth : Sdc::TriangleWeights::CatmullClark};
}

/// A surface of polygons, of triangles for Loop.
class OwnedSurface {
  public:
    OwnedSurface(const std::vector<Polygon>& faces, const std::vector<double>& positions, bool is_loop)
        : is_loop_(is_loop), positions_(positions) {
        mesh_.n_vertices = static_cast<Index>(positions.size() / 3);
        for (const Polygon& face : faces) {
            auto& list = is_loop ? mesh_.triangles : mesh_.polygon_vertices;
            list.insert(list.end(), face.begin(), face.end());
            if (!is_loop) mesh_.polygon_offsets.push_back(static_cast<Offset>(list.size()));
        }
    }
    Sdc::Split split() const { return is_loop_ ? Sdc::Split::TetOct : Sdc::Split::Polyhedral; }
    std::string Reason() const { return ReasonToSkip(mesh_.Descriptor(), split()); }
    Findings Compare(const SurfaceTags& tags, bool smooth_triangles = false) const {
        Compared c{mesh_.Descriptor(), split(), LoopOf(tags), tags, tags, smooth_triangles};
        if (!is_loop_) c.scheme = CatmullClarkOf(tags, smooth_triangles);
        return CompareLimits(c, positions_);
    }

  private:
    bool is_loop_;
    OwnedMesh mesh_;
    std::vector<double> positions_;
};

/// Plain, and with tags that last and such that fade.
void CompareSurface(const std::string& name, const std::vector<Polygon>& faces, const std::vector<double>& positions,
                    bool is_loop, std::uint32_t seed, Findings& findings) {
    const OwnedSurface surface(faces, positions, is_loop);
    if (const std::string reason = surface.Reason(); !reason.empty()) {
        findings.skipped.push_back(name + ": " + reason);
        return;
    }
    findings.Merge(surface.Compare({}), name);
    for (bool infinite : {true, false}) {
        SurfaceTags tags = RandomTags(faces, seed, infinite);
        tags.has_sharp_corners = seed % 2 == 1;
        tags.is_chaikin = !infinite && seed % 3 == 0;
        findings.Merge(surface.Compare(tags), name + (infinite ? ", infinite tags" : ", tags"));
    }
}

/// The boundary of a solid under smooth and sharp features. @param set_features makes the scheme
template <class MakeScheme>
void CompareBoundary(const std::string& name, const Far::TopologyDescriptor& mesh, Sdc::Split split,
                     const std::vector<double>& positions, const SurfaceTags& sharp, MakeScheme&& make_scheme,
                     Findings& findings) {
    if (const std::string reason = ReasonToSkip(mesh, split); !reason.empty()) {
        findings.skipped.push_back(name + ": " + reason);
        return;
    }
    findings.Merge(CompareLimits({mesh, split, make_scheme(Sdc::Features::Smooth)}, positions), name + ", smooth");
    findings.Merge(CompareLimits({mesh, split, make_scheme(Sdc::Features::Sharp), {}, sharp}, positions),
                   name + ", sharp");
}

void CompareOurShapes(Findings& findings) {
    std::uint32_t seed = 0;
    for (const SurfaceShape& shape : AllSurfaces()) {
        std::vector<Polygon> faces;
        for (const Triangle& t : shape.triangles) faces.emplace_back(t.begin(), t.end());
        CompareSurface("loop, " + shape.name, faces, shape.positions, true, seed++, findings);
    }
    for (const PolygonShape& shape : PolygonShapes()) {
        CompareSurface("catmull-clark, " + shape.name, shape.faces, shape.positions, false, seed++, findings);
    }
    for (const SolidShape& shape : ManifoldShapes()) {
        const CellArrays cells(shape.complex);
        const auto mesh = cells.Descriptor(shape.n_vertices());
        const SurfaceTags sharp = SharpFeaturesOf(shape.complex);
        const auto compare = [&](auto scheme) {
            CompareBoundary(
                std::string(scheme.kName) + ", " + shape.name, mesh, Sdc::Split::TetOct, shape.positions, sharp,
                [&](Sdc::Features features) {
                    scheme.features = features;
                    return Sdc::Scheme(scheme);
                },
                findings);
        };
        compare(Sdc::BoxSpline{});
        compare(Sdc::SmoothTet{});
    }
    for (const HexShape& shape : HexShapes()) {
        OwnedMesh hexes;
        hexes.n_vertices = static_cast<Index>(shape.positions.size() / 3);
        for (const auto& cell : shape.cells) hexes.hexes.insert(hexes.hexes.end(), cell.begin(), cell.end());
        const auto compare = [&](auto scheme) {
            CompareBoundary(
                std::string(scheme.kName) + ", " + shape.name, hexes.Descriptor(), Sdc::Split::Polyhedral,
                shape.positions, SharpFeaturesOf(shape),
                [&](Sdc::Features features) {
                    scheme.features = features;
                    return Sdc::Scheme(scheme);
                },
                findings);
        };
        compare(Sdc::CatmullClarkSolid{});
        compare(Sdc::Mlca{.surface = Sdc::BoundarySurface::CatmullClark});
    }
}

}  // namespace

Findings ValidateLimitSurfaces(const Context& context) {
    Findings findings;
    CompareOurShapes(findings);
    findings.notes.push_back("our surfaces and solids: " + std::to_string(findings.n_compared) +
                             " points, derivatives and normals");
    for (const char* prefix : {"loop_", "catmark_"}) {
        const bool is_loop = std::string_view(prefix) == "loop_";
        const auto take = [&](const Io::Mesh& mesh) { return OwnedSurface(FacesOf(mesh), mesh.positions, is_loop); };
        CompareCatalogue(
            context.osd_shapes, {prefix}, [&](const Io::Mesh& mesh) { return take(mesh).Reason(); },
            [&](const std::string& name, const Io::Mesh& mesh) {
                return take(mesh).Compare(TagsOf(mesh), name.starts_with("catmark_smoothtris"));
            },
            findings);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
