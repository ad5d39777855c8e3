// SPDX-License-Identifier: Apache-2.0
// Validators catmark-surfaces and catmark-boundary: the scheme catmull-clark on surfaces of polygons, linear-surface,
// and the boundary of catmull-clark-solid against OpenSubdiv; surfaces of its own catalogue too where it is present.
#include <algorithm>
#include <set>

#include "catalogue.h"
#include "polygon_compare.h"
#include "polygon_shapes.h"
#include "sharp_features.h"
#include "surface_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

/// Faces as compressed rows.
struct FaceArrays {
    std::vector<Offset> offsets{0};
    std::vector<Index> vertices;

    explicit FaceArrays(const std::vector<Polygon>& faces) {
        for (const Polygon& face : faces) {
            vertices.insert(vertices.end(), face.begin(), face.end());
            offsets.push_back(static_cast<Offset>(vertices.size()));
        }
    }
    Far::TopologyDescriptor Descriptor(std::span<const double> positions) const {
        Far::TopologyDescriptor d{.n_vertices = static_cast<Index>(positions.size() / 3)};
        d.polygon_offsets = offsets;
        d.polygon_vertices = vertices;
        return d;
    }
};

Findings CompareSurface(const std::vector<Polygon>& faces, const std::vector<double>& positions,
                        const SurfaceTags& tags, bool is_quick, bool smooth_triangles = false, bool bilinear = false) {
    PolygonSurfaceOfMesh surface = TakePolygons(faces, positions, tags);
    surface.surface.has_smooth_triangles = smooth_triangles;
    surface.surface.is_bilinear = bilinear;
    Sdc::Scheme scheme = Sdc::LinearSurface{};
    if (!bilinear) {
        scheme = Sdc::CatmullClark{
            .features = tags.has_sharp_corners ? Sdc::Features::Sharp : Sdc::Features::Smooth,
            .creasing = tags.is_chaikin ? Sdc::CreasingMethod::Chaikin : Sdc::CreasingMethod::Uniform,
            .triangles = smooth_triangles ? Sdc::TriangleWeights::Smooth : Sdc::TriangleWeights::CatmullClark};
    }
    const FaceArrays arrays(faces);
    return CompareWithCatmark(arrays.Descriptor(positions), scheme, surface, positions, tags,
                              ComparedLevels{4, 3}.AtMostTwoIf(is_quick));
}

/// Why a shape can't be compared, or an empty text: what is refused, and vertices whose rules differ on purpose.
std::string ReasonToSkip(const std::vector<Polygon>& faces, const std::vector<double>& positions) {
    std::set<std::set<int>> sets;
    for (const Polygon& face : faces) {
        const std::set<int> set(face.begin(), face.end());
        if (set.size() < face.size()) return "a face with a vertex twice, which is refused";
        if (!sets.insert(set).second) return "two faces with the same vertices, which are refused";
    }
    const FaceArrays arrays(faces);
    const auto refiner = Far::TopologyRefiner::Create(arrays.Descriptor(positions), Sdc::Split::Polyhedral);
    const auto& tags = refiner.polyhedral_level(0).vertex_tags;
    for (std::size_t v = 0; v < tags.size(); ++v) {
        if (tags[v].non_manifold() && tags[v].rule() == Vtr::Rule::Curve) {
            return "surfaces meet in vertex " + std::to_string(v) +
                   ", which OpenSubdiv fixes and our rule treats as a crease's";
        }
    }
    return "";
}

}  // namespace

Findings ValidateCatmarkSurfaces(const Context& context) {
    Findings findings;
    std::uint32_t seed = 0;
    int n_shapes = 0;
    for (const PolygonShape& shape : PolygonShapes()) {
        if (const std::string reason = ReasonToSkip(shape.faces, shape.positions); !reason.empty()) {
            findings.skipped.push_back(shape.name + ": " + reason);
            continue;
        }
        ++n_shapes;
        findings.Merge(CompareSurface(shape.faces, shape.positions, {}, context.is_quick), shape.name);
        findings.Merge(CompareSurface(shape.faces, shape.positions, {}, context.is_quick, true),
                       shape.name + ", smooth triangles");
        findings.Merge(CompareSurface(shape.faces, shape.positions, {}, context.is_quick, false, true),
                       shape.name + ", linear");
        ++seed;
        SurfaceTags tags = RandomTags(shape.faces, seed, seed % 3 == 0);
        tags.has_sharp_corners = seed % 2 == 1;
        for (bool is_chaikin : {false, true}) {
            tags.is_chaikin = is_chaikin;
            findings.Merge(CompareSurface(shape.faces, shape.positions, tags, context.is_quick),
                           shape.name + (is_chaikin ? ", tags, Chaikin" : ", tags"));
        }
    }
    findings.notes.push_back(std::to_string(n_shapes) +
                             " surfaces of ours, levels 1-4, plain, with smooth triangles, linear, and with random "
                             "creases and corners under both creasing methods");
    CompareCatalogue(
        context.osd_shapes, {"catmark_", "bilinear_"},
        [](const Io::Mesh& mesh) { return ReasonToSkip(FacesOf(mesh), mesh.positions); },
        [&](const std::string& name, const Io::Mesh& mesh) {
            return CompareSurface(FacesOf(mesh), mesh.positions, TagsOf(mesh), context.is_quick,
                                  name.starts_with("catmark_smoothtris"), name.starts_with("bilinear_"));
        },
        findings);
    return findings;
}

Findings ValidateCatmarkBoundary(const Context&) {
    Findings findings;
    std::uint32_t seed = 100;
    const std::vector<HexShape> shapes = HexShapes();
    for (const HexShape& shape : shapes) {
        std::vector<Index> cells;
        for (const auto& cell : shape.cells) cells.insert(cells.end(), cell.begin(), cell.end());
        Far::TopologyDescriptor mesh{.n_vertices = static_cast<Index>(shape.positions.size() / 3)};
        mesh.hexes = cells;
        const std::vector<Polygon> faces = BoundaryOf(shape);
        const SurfaceTags sharp = SharpFeaturesOf(shape);
        const auto compare = [&](const std::string& name, Sdc::Features features, const SurfaceTags& ours,
                                 const SurfaceTags& theirs) {
            const Sdc::Mlca mlca{.features = features, .surface = Sdc::BoundarySurface::CatmullClark};
            for (const Sdc::Scheme& scheme :
                 {Sdc::Scheme(Sdc::CatmullClarkSolid{.features = features}), Sdc::Scheme(mlca)}) {
                findings.Merge(CompareWithCatmark(mesh, scheme, TakePolygons(faces, shape.positions, theirs),
                                                  shape.positions, ours, {3, 2}),
                               shape.name + ", " + std::string(Sdc::NameOf(scheme)) + ", " + name);
            }
        };
        compare("smooth", Sdc::Features::Smooth, {}, {});
        compare("sharp", Sdc::Features::Sharp, {}, sharp);
        const SurfaceTags tags = RandomTags(faces, ++seed, false);
        compare("smooth, tags", Sdc::Features::Smooth, tags, tags);
        compare("sharp, tags", Sdc::Features::Sharp, tags, Merged(tags, sharp));
    }
    findings.notes.push_back(std::to_string(shapes.size()) +
                             " solids, levels 1-3, both features, with and without tags");
    return findings;
}

}  // namespace SolidSubdiv::Validation
