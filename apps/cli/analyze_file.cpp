// SPDX-License-Identifier: Apache-2.0
// analyze FILE: from the mesh to the stars of its kinds of places.
#include <solidsubdiv/apps/cli/analyze_file.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include <solidsubdiv/apps/cli/kind_check.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/kit/io/formats.h>

namespace SolidSubdiv::Cli {

namespace {

using Analysis::PlaceType;

/// How a group of places is headed, and what one is called.
std::pair<const char*, const char*> NamesOf(PlaceType type) {
    switch (type) {
        case PlaceType::InnerVertex:
            return {"vertices inside", "vertex"};
        case PlaceType::InnerEdge:
            return {"edges inside", "edge"};
        case PlaceType::InnerFace:
            return {"faces inside", "face"};
        case PlaceType::InnerCell:
            return {"cells", "cell"};
        case PlaceType::Surface:
            return {"vertices of the surface", "vertex"};
        case PlaceType::Border:
            return {"vertices of the border", "vertex"};
        case PlaceType::SurfaceFace:
            return {"faces of the surface", "face"};
    }
    return {};
}

template <class Vertices>
std::string Joined(const Vertices& vertices) {
    std::string text;
    for (Index v : vertices) text += " " + std::to_string(v);
    return text;
}

/// "edge 3 17": by its vertices, which files number.
std::string ExampleOf(const Far::TopologyRefiner& refiner, const Analysis::PlaceKind& kind) {
    const std::string name = NamesOf(kind.type).second;
    if (name == "edge") return name + Joined(refiner.graph(0).EdgeVertices(kind.example));
    if (name == "face") {
        return name + (refiner.is_polyhedral() ? Joined(refiner.polyhedral_level(0).FaceVertices(kind.example))
                                               : Joined(refiner.level(0).FaceVertices(kind.example)));
    }
    if (name == "cell") return name + Joined(refiner.polyhedral_level(0).CellVertices(kind.example));
    return name + " " + std::to_string(kind.example);
}

RefinementSettings Settings(const Io::Mesh& mesh, const SchemeOptions& options) {
    const MeshKind kind{mesh.topology.n_cells() > 0, IsTetOct(mesh.topology)};
    RefinementSettings settings;
    settings.choice = MakeScheme(WithFileOptions(options, mesh.scheme_options, kind), kind);
    settings.split = SplitFor(mesh.topology, settings.choice.scheme);
    settings.levels = 0;
    return settings;
}

}  // namespace

FilePlaces AnalyzeFile(const std::string& file, const SchemeOptions& options, bool wants_all, Session& session) {
    session.Stage("read");
    Io::Mesh mesh = Io::ReadMesh(file);
    for (const std::string& note : mesh.notes) session.Note(file + ": " + note);
    return About(file, [&] {
        FilePlaces found;
        const RefinementSettings settings = Settings(mesh, options);
        found.scheme = settings.choice.scheme;
        const Refinement control(std::move(mesh), settings, session);
        const Far::TopologyRefiner& refiner = control.refiner();
        session.Stage("classify");
        const Analysis::MeshPlaces all = Analysis::PlacesOf(refiner, found.scheme, session.progress());
        if (all.kinds.empty()) {
            throw InvalidInput("no place to analyze: no vertices inside a solid or a surface, no edges inside");
        }
        std::vector<Analysis::Star> stars;
        std::map<PlaceType, std::pair<Index, Index>> taken, left;  // kinds and places
        for (const Analysis::PlaceKind& kind : all.kinds) {
            auto& [n_kinds, n_places] =
                taken[kind.type].first < kMostKinds || wants_all ? taken[kind.type] : left[kind.type];
            ++n_kinds;
            n_places += kind.count;
            if (left.contains(kind.type)) continue;
            found.places.push_back(
                {NamesOf(kind.type).first, kind.what, kind.count, ExampleOf(refiner, kind), Analysis::PlaceReport{}});
            stars.push_back(StarOf(refiner, kind));
        }
        session.Stage("analyze");
        AnalyzeAll(found.places, stars, found.scheme, session.progress());
        session.EndStage();
        found.json = {{"file", file},
                      {"vertices", refiner.n_vertices(0)},
                      {"not_analyzed", {{"on_creases", all.n_creased}, {"others", all.n_others}}}};
        for (const auto& [type, n] : left) {
            found.json["not_analyzed"][NamesOf(type).first] = n.second;
            found.left_out += "\n\nnot analyzed: " + std::to_string(n.second) + " " + NamesOf(type).first + " of " +
                              Counted(n.first, "rarer kind", "rarer kinds") + "; --top 0 analyzes all";
        }
        if (all.n_creased > 0) {
            found.left_out += "\n\nnot analyzed: " + Counted(all.n_creased, "vertex", "vertices") +
                              " on creases and corners, which follow the curve rule or stay";
        }
        if (all.n_others > 0) {
            found.left_out += "\n\nnot analyzed: " + Counted(all.n_others, "vertex", "vertices") +
                              " on curves, where parts of several dimensions meet, or in no element";
        }
        return found;
    });
}

}  // namespace SolidSubdiv::Cli
