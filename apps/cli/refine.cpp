// SPDX-License-Identifier: Apache-2.0
// solidsubdiv refine IN -o OUT: refines a solid, a surface or a curve.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include <solidsubdiv/apps/cli/commands.h>
#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/files_help.h>
#include <solidsubdiv/apps/cli/kind_check.h>
#include <solidsubdiv/apps/cli/matrix_market.h>
#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/apps/cli/mesh_report.h>
#include <solidsubdiv/apps/cli/refinement.h>
#include <solidsubdiv/kit/io/formats.h>
#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/refinement_picture.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

struct RefineOptions {
    std::string input, output, boundary, stencils, picture;
    SchemeOptions scheme;
    int levels = 1;
    std::string orient = "repair";
    bool drop_border = false;
    bool limit = false, keep_octahedra = false, ascii = false;
};

class RefineCommand {
  public:
    RefineCommand(const RefineOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        Announce();
        session_.Stage("read");
        Io::Mesh mesh = Io::ReadMesh(options_.input);
        for (const std::string& note : mesh.notes) session_.Note(options_.input + ": " + note);
        json_["input"] = {{"file", options_.input}, {"vertices", mesh.topology.n_vertices}};
        for (const KindCount& kind : KindCounts(mesh.topology)) {
            if (kind.count > 0) json_["input"][std::string(kind.plural)] = kind.count;
        }
        RefinementSettings settings = Settings(mesh);
        RequireFormats(mesh);
        About(options_.input, [&] {
            const Refinement refinement(std::move(mesh), settings, session_);
            Warn(refinement);
            Write(refinement, settings);
            Describe(refinement);
        });
        json_["seconds"] = session_.Seconds();
        session_.Finish(json_);
    }

  private:
    /// All names of outputs are tried before any work.
    void Announce() {
        const auto stage = [&](const std::string& file, bool is_mesh) {
            if (file.empty()) return std::filesystem::path();
            if (is_mesh && !FormatFor(file).write) {
                throw UsageError(file + ": " + std::string(FormatFor(file).name) + " files are only read");
            }
            return session_.outputs().Stage(file);
        };
        output_ = stage(options_.output, true);
        boundary_ = stage(options_.boundary, true);
        stencils_ = stage(options_.stencils, false);
        picture_ = stage(options_.picture, false);
        if (!options_.boundary.empty() && !FormatFor(options_.boundary).surfaces) {
            throw UsageError(options_.boundary + ": " + std::string(FormatFor(options_.boundary).name) +
                             " files can't hold a surface");
        }
        if (options_.limit && !options_.stencils.empty()) {
            throw UsageError("--stencils writes the weights of refined vertices; leave out --limit");
        }
    }

    static const Io::Format& FormatFor(const std::string& file) {
        try {
            return Io::FormatOf(file);
        } catch (const IoError& error) {
            throw UsageError(error.what());
        }
    }

    RefinementSettings Settings(const Io::Mesh& mesh) {
        const Io::Topology& topology = mesh.topology;
        RefinementSettings settings;
        const MeshKind kind{topology.n_cells() > 0, IsTetOct(topology)};
        const SchemeOptions scheme = WithFileOptions(options_.scheme, mesh.scheme_options, kind);
        const auto asks_to_drop = [](const auto& option) {
            return option.first == "boundary" && option.second == "none";
        };
        settings.choice = MakeScheme(scheme, kind);
        settings.split = About(options_.input, [&] { return SplitFor(topology, settings.choice.scheme); });
        settings.drop_border =
            options_.drop_border || std::any_of(mesh.scheme_options.begin(), mesh.scheme_options.end(), asks_to_drop);
        settings.keep_creases = FormatFor(options_.output).creases;
        settings.levels = options_.levels;
        settings.orient = Geometry::OrientationPolicyOf(options_.orient);
        settings.limit = options_.limit;
        settings.keep_levels = !options_.picture.empty();
        Json& json = json_["settings"];
        json = {{"scheme", Sdc::NameOf(settings.choice.scheme)}};
        for (const auto& [name, value] : OptionValues(scheme, settings.choice.scheme)) json[name] = value;
        json["levels"] = options_.levels;
        json["diagonals"] = options_.scheme.diagonals;
        json["orient"] = options_.orient;
        json["limit"] = options_.limit;
        json["keep_octahedra"] = options_.keep_octahedra;
        json["drop_border"] = settings.drop_border;
        json["threads"] = Sdc::ThreadCount();
        return settings;
    }

    /// What can't be written is refused before it is computed.
    void RequireFormats(const Io::Mesh& mesh) const {
        const Io::Format& format = FormatFor(options_.output);
        if (mesh.topology.n_cells() > 0 && !format.solids) {
            throw IoError(options_.output + ": " + std::string(format.name) +
                          " files can't hold cells; name a .vtu file, and the boundary with --boundary");
        }
        if (mesh.topology.n_cells() == 0 && !format.surfaces) {
            throw IoError(options_.output + ": " + std::string(format.name) +
                          " files hold cells only, and there are none; name a .vtu or .obj file");
        }
        const Io::Topology& t = mesh.topology;
        if (t.n_cells() + t.n_triangles() + t.n_quads() + t.n_polygons() == 0 && !options_.boundary.empty()) {
            throw InvalidInput(options_.input + ": has no faces for --boundary; leave it out");
        }
    }

    void Warn(const Refinement& refinement) {
        const auto& orientation = refinement.orientation();
        if (orientation.n_inverted() > 0) {
            session_.Note(options_.input + ": " + Counted(orientation.n_inverted(), "inverted cell", "inverted cells") +
                          (options_.orient == "repair" ? " turned (--orient)" : " kept"));
        }
        if (orientation.n_flat() > 0) {
            session_.Note(options_.input + ": " + Counted(orientation.n_flat(), "cell", "cells") + " of no volume");
        }
        if (refinement.n_tags() > 0) {
            session_.Note(options_.input + ": " + Counted(refinement.n_tags(), "element lies", "elements lie") +
                          " on a part of higher dimension and without sharpness; they are not written");
        }
        if (!options_.output.empty() && !FormatFor(options_.output).creases &&
            refinement.result_creases().edges.size() + refinement.result_creases().vertices.size() > 0) {
            session_.Note(options_.output + ": the format can't carry what is still sharp, left out");
        }
        NoteWithoutLimit(session_, options_.input, refinement);
        for (const Json& code : DescribeDefects(refinement.refiner().defects(), 100, 1)) {
            const std::string name = code["code"].get<std::string>();
            if (name == "coincident element") continue;
            session_.Note(options_.input + ": " + name + ": " +
                          (code["count_is_complete"].get<bool>() ? "" : "at least ") + code["count"].dump() +
                          "; the first: " + code["first"][0]["text"].get<std::string>());
        }
    }

    void Write(const Refinement& refinement, const RefinementSettings& settings) {
        session_.Stage("write");
        const Io::WriteOptions how{.keep_octahedra = options_.keep_octahedra, .binary = !options_.ascii};
        WriteOne(options_.output, output_, refinement.result(), how);
        AddOutput("mesh", options_.output, output_);
        if (!boundary_.empty()) {
            WriteOne(options_.boundary, boundary_, refinement.Boundary(), how);
            AddOutput("boundary", options_.boundary, boundary_);
        }
        if (!stencils_.empty()) WriteStencils(refinement, settings);
#ifdef SOLIDSUBDIV_HAS_PICTURES
        if (!picture_.empty()) {
            session_.Stage("picture");
            std::vector<const Io::Mesh*> levels;
            for (const Io::Mesh& mesh : refinement.earlier()) levels.push_back(&mesh);
            levels.push_back(&refinement.result());
            Picture::WritePng(picture_, Picture::RefinementPicture(levels, {}, session_.progress()));
            AddOutput("picture", options_.picture, picture_);
        }
#endif
        session_.EndStage();
    }

    void WriteOne(const std::string& file, const std::filesystem::path& written, const Io::Mesh& mesh,
                  const Io::WriteOptions& how) {
        Io::WriteMesh(written, mesh, how);
        std::string names;
        for (const std::string& name : Io::AttributesLeftOut(written, mesh))
            names += (names.empty() ? "" : ", ") + name;
        if (!names.empty()) session_.Note(file + ": the format can't carry " + names + ", left out");
    }

    void WriteStencils(const Refinement& refinement, const RefinementSettings& settings) {
        session_.Note(
            options_.stencils + ": " + Counted(refinement.result().topology.n_vertices, "row", "rows") + " over " +
            Counted(refinement.control().topology.n_vertices, "control vertex", "control vertices") + " are composed");
        session_.Stage("compose");
        const auto table = Far::StencilTable::CreateComposite(
            refinement.refiner(), settings.choice.scheme,
            {{.level = options_.levels, .vertices = refinement.kept_vertices()}}, session_.progress());
        const auto& rows = table.level(1);
        session_.Note(options_.stencils + ": " + Counted(rows.n_weights(), "weight", "weights") + ", " +
                      Far::BytesText(rows.Bytes()) + " in memory, about " +
                      Far::BytesText(kTextBytesOfWeight * rows.n_weights()) + " as text");
        session_.Stage("write stencils");
        WriteMatrixMarket(stencils_, rows, session_.progress());
        AddOutput("stencils", options_.stencils, stencils_);
        Json& output = json_["outputs"].back();
        output["rows"] = rows.n_rows();
        output["columns"] = rows.n_sources;
        output["weights"] = rows.n_weights();
    }

    void AddOutput(const std::string& what, const std::string& file, const std::filesystem::path& written) {
        std::error_code error;
        const auto size = static_cast<Offset>(std::filesystem::file_size(written, error));
        json_["outputs"].push_back({{"what", what}, {"file", file}, {"bytes", error ? 0 : size}});
        said_ += "\nwrote " + file + " (" + Far::BytesText(size) + ")";
    }

    void Describe(const Refinement& refinement) {
        const Far::TopologyRefiner& refiner = refinement.refiner();
        std::string text;
        for (int i = 0; i <= options_.levels; ++i) {
            if (refiner.is_polyhedral()) {
                text += DescribePolyhedra(i, refiner.PolyhedralCountsAt(i));
                continue;
            }
            const Vtr::Counts c = refiner.CountsAt(i);
            json_["levels"].push_back({{"vertices", c.n_vertices},
                                       {"edges", c.n_edges},
                                       {"faces", c.n_faces},
                                       {"tetrahedra", c.n_tets},
                                       {"octahedra", c.n_octs},
                                       {"cells", c.n_cells()},
                                       {"boundary_faces", c.n_boundary_faces}});
            text += "level " + std::to_string(i) + ": " + Counted(c.n_vertices, "vertex", "vertices");
            if (c.n_cells() > 0) {
                text += ", " + Counted(c.n_cells(), "cell", "cells") + " (" + Counted(c.n_tets, "tet", "tets") + ", " +
                        Counted(c.n_octs, "oct", "octs") + ")";
            }
            if (c.n_boundary_faces > 0) {
                text += ", " + Counted(c.n_boundary_faces, "boundary face", "boundary faces");
            }
            text += "\n";
        }
        json_["bytes"] = {{"topology", refiner.Bytes()}, {"stencils", refinement.stencil_bytes()}};
        json_["orientation"] = {{"inverted", refinement.orientation().n_inverted()},
                                {"zero_volume", refinement.orientation().n_flat()}};
        const Io::Creases& given = refinement.creases();
        const Far::Creases& kept = refinement.result_creases();
        json_["creases"] = {{"edges", given.edge_sharpness.size()},
                            {"corners", given.vertices.size()},
                            {"edges_still_sharp", kept.edge_sharpness.size()},
                            {"corners_still_sharp", kept.vertices.size()}};
        if (!given.empty()) {
            const auto counted = [](std::size_t edges, std::size_t corners) {
                return Counted(static_cast<Offset>(edges), "sharp edge", "sharp edges") + " and " +
                       Counted(static_cast<Offset>(corners), "sharp vertex", "sharp vertices");
            };
            text += "creases: " + counted(given.edge_sharpness.size(), given.vertices.size()) + "; at level " +
                    std::to_string(options_.levels) + " " + counted(kept.edge_sharpness.size(), kept.vertices.size()) +
                    "\n";
        }
        if (refinement.n_faces_left_out() > 0) {
            const Offset n_vertices = refiner.n_vertices(options_.levels) - refinement.result().topology.n_vertices;
            json_["left_out"] = {{"faces", refinement.n_faces_left_out()}, {"vertices", n_vertices}};
            text += "left out: what comes of " + Counted(refinement.n_faces_left_out(), "face", "faces") + " (" +
                    Counted(n_vertices, "vertex", "vertices") + " of their own)\n";
        }
        json_["defects"] = DescribeDefects(refiner.defects(), 100, 100);
        const Far::DiagonalChoice& diagonals = refinement.diagonals();
        if (refinement.control().topology.n_cells() > 0 && !refiner.is_polyhedral()) {
            json_["matched_faces"] = {{"inner_faces", diagonals.n_inner_faces},
                                      {"matched", diagonals.n_matched_faces},
                                      {"share", diagonals.MatchedShare()}};
            char share[32];
            std::snprintf(share, sizeof share, "%.1f %%", 100 * diagonals.MatchedShare());
            if (options_.scheme.diagonals != "averaged") {
                text += std::string("diagonals: ") + options_.scheme.diagonals + ", " + share + " of " +
                        Counted(diagonals.n_inner_faces, "inner face", "inner faces") + " matched\n";
            }
        }
        session_.Print(text + said_.substr(1));
    }

    /// Notes a level of the polyhedral split; the line of text on it.
    std::string DescribePolyhedra(int level, const Vtr::PolyhedralCounts& c) {
        json_["levels"].push_back({{"vertices", c.n_vertices},
                                   {"edges", c.n_edges},
                                   {"faces", c.n_faces},
                                   {"hexahedra", c.n_hexes},
                                   {"other_cells", c.n_polyhedra},
                                   {"cells", c.n_cells()},
                                   {"boundary_faces", c.n_boundary_faces}});
        std::string text = "level " + std::to_string(level) + ": " + Counted(c.n_vertices, "vertex", "vertices");
        if (c.n_cells() > 0) text += ", " + Counted(c.n_cells(), "cell", "cells");
        if (c.n_polyhedra > 0) {
            text += " (" + Counted(c.n_hexes, "hexahedron", "hexahedra") + ", " + std::to_string(c.n_polyhedra) +
                    " of other kinds)";
        }
        if (c.n_boundary_faces > 0) text += ", " + Counted(c.n_boundary_faces, "boundary face", "boundary faces");
        return text + "\n";
    }

    /// A usual line of the file: row, column, weight.
    static constexpr Offset kTextBytesOfWeight = 27;

    const RefineOptions& options_;
    Session& session_;
    std::filesystem::path output_, boundary_, stencils_, picture_;
    Json json_ = {{"command", "refine"}};
    std::string said_;
};

void AddOutputOptions(CLI::App& command, RefineOptions& o) {
    command.add_flag("--keep-octahedra", o.keep_octahedra,
                     "write octahedra as polyhedra (.vtu, .vtk);\nelse as four tets around the major diagonal");
    command.add_flag("--ascii", o.ascii, "write text where the format has a binary form too");
    command.add_option("--boundary", o.boundary, "write the boundary surface too")->option_text("FILE");
    command
        .add_option("--stencils", o.stencils,
                    "write the weights of each refined vertex (row) over the\n"
                    "control vertices (columns) as a Matrix Market file")
        ->option_text("FILE");
#ifdef SOLIDSUBDIV_HAS_PICTURES
    command
        .add_option("--picture", o.picture,
                    "draw levels as a PNG; of solids a cut and a slice too,\nof surfaces reflection lines")
        ->option_text("FILE");
#endif
}

}  // namespace

Work AddRefine(CLI::App& command) {
    const auto options = std::make_shared<RefineOptions>();
    RefineOptions& o = *options;
    command.add_option("IN", o.input, "the control mesh: cells, faces and edges of any kind, or a mix")
        ->required()
        ->option_text(" ");
    command.add_option("-o,--output", o.output, "the refined mesh; the extension chooses the format")
        ->required()
        ->option_text("OUT (required)");
    command.add_option("--levels", o.levels, "how many times every element is split; default 1")
        ->option_text("N")
        ->check(CLI::Range(0, 20));
    AddSchemeOptions(command, o.scheme);
    AddOrientOption(command, o.orient);
    command.add_flag("--drop-border", o.drop_border,
                     "leave out the faces at the border of open surfaces: they\nonly support the others "
                     "(OpenSubdiv's VTX_BOUNDARY_NONE)");
    command.add_flag("--limit", o.limit, "move the vertices of the last level to their limits");
    AddOutputOptions(command, o);
    command.footer(
        "Points come in this order, level by level: the control vertices' children, then points on edges, in faces "
        "and\n"
        "in cells (where tets and octs are cut into such: octahedra's centres alone). Point data are refined like\n"
        "positions; cells inherit the data of their control cells, and tets and octs carry their diagonals as cell "
        "data\n"
        "'diagonal'. Creases and corners are edges and single vertices with cell data 'sharpness', or OpenSubdiv's t "
        "tags\n"
        "in OBJ files; what is still sharp is written with the result. Faces with cell data 'hole', or such a tag, "
        "are\n"
        "refined and left out, with the vertices that they have alone.\n\n" +
        SchemesHelp() + "\n\n" + ReadableFilesHelp() + "\n" + WritableFilesHelp() +
        "\n\nExamples:\n"
        "  solidsubdiv refine lattice.vtu -o solid.vtu --levels 2 --boundary solid.obj\n"
        "  solidsubdiv refine lattice.vtu -o solid.vtu --scheme linear-solid --diagonals shortest --json -\n"
        "  solidsubdiv refine lattice.vtu -o solid.vtu --scheme interpolatory --tension 0.05\n"
        "  solidsubdiv refine solid.obj -o smooth.obj --scheme modified-butterfly");
    return [options](Session& session) { RefineCommand(*options, session).Run(); };
}

}  // namespace SolidSubdiv::Cli
