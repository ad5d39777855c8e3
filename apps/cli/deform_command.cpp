// SPDX-License-Identifier: Apache-2.0
// A model is embedded in a lattice once and moved with each of the lattices it moves to.
#include <solidsubdiv/apps/cli/deform_command.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include <solidsubdiv/apps/cli/drag_targets.h>
#include <solidsubdiv/apps/cli/lattice_mesh.h>
#include <solidsubdiv/apps/cli/model_lattice.h>
#include <solidsubdiv/apps/cli/model_normals.h>
#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/obj_text.h>
#ifdef SOLIDSUBDIV_HAS_PICTURES
#include <solidsubdiv/kit/picture/deformation_picture.h>
#endif

namespace SolidSubdiv::Cli {

namespace {

bool IsObj(const std::string& file) { return !file.empty() && Io::FormatOf(file).extension == ".obj"; }

/// At most ten of many numbers: "1, 2, 3 and 17 more".
std::string FirstOf(const std::vector<Index>& numbers) {
    constexpr std::size_t kMost = 10;
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), kMost); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
    }
    return numbers.size() > kMost ? text + " and " + std::to_string(numbers.size() - kMost) + " more" : text;
}

class DeformCommand {
  public:
    DeformCommand(const DeformOptions& options, Session& session) : options_(options), session_(session) {}

    void Run() {
        RequireUsable();
        session_.Stage("read");
        model_ = Io::ReadMesh(options_.model);
        RequireFormat();
        if (IsObj(options_.model) && IsObj(options_.output)) {
            text_of_model_.emplace(options_.model);
        } else {
            for (const std::string& note : model_.notes) session_.Note(options_.model + ": " + note);
        }
        model_.notes.clear();
        json_["model"] = {{"file", options_.model}, {"vertices", model_.topology.n_vertices}};
        if (options_.embedding.empty()) {
            Embed();
        } else {
            LoadEmbedding();
        }
        TellOutside();
        if (!outputs_.empty()) Deform();
        if (!picture_.empty()) WritePicture();
        json_["bytes"] = {{"embedding", embedding_->tables().Bytes()}};
        json_["seconds"] = session_.Seconds();
        session_.Print(text_ + said_);
        session_.Finish(json_);
    }

  private:
    /// The name of the result of the i-th of several moved lattices.
    std::string OutputName(std::size_t i) const {
        if (options_.to.size() <= 1) return options_.output;
        const std::filesystem::path path(options_.output);
        std::string number = std::to_string(i + 1);
        number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
        std::filesystem::path name = path.parent_path() / path.stem();
        name += "_" + number + path.extension().string();
        return name.string();
    }

    /// All that can be known to be wrong before any work, names of outputs among it.
    void RequireUsable() {
        const DeformOptions& o = options_;
        if (o.lattice.empty() == o.embedding.empty()) {
            throw UsageError("name the lattice that the model lies in: --lattice, or --embedding of an earlier run");
        }
        const bool moves = !o.to.empty() || !o.drag.empty();
        if (moves == o.output.empty()) {
            throw UsageError(moves ? "a deformed model needs a name: -o" : "-o needs moved lattices, --to, or --drag");
        }
        if (!moves && o.save_embedding.empty()) {
            throw UsageError(
                "nothing to do; name moved lattices with --to and the result with -o, or --save-embedding");
        }
        if (!o.embedding.empty() && !(o.scheme.scheme.empty() && o.scheme.values.empty())) {
            throw UsageError("an embedding has its scheme and options; leave them out");
        }
        try {
            if (!o.output.empty()) {
                const Io::Format& format = Io::FormatOf(o.output);
                if (!format.write)
                    throw UsageError(o.output + ": " + std::string(format.name) + " files are only read");
            }
        } catch (const IoError& error) {
            throw UsageError(error.what());
        }
        for (std::size_t i = 0; moves && i < std::max<std::size_t>(o.to.size(), 1); ++i) {
            outputs_.push_back(session_.outputs().Stage(OutputName(i)));
        }
        if (!o.save_lattice.empty()) {
            if (!Io::FormatOf(o.save_lattice).solids) throw UsageError(o.save_lattice + ": can't hold a lattice");
            saved_lattice_ = session_.outputs().Stage(o.save_lattice);
        }
        if (!o.save_embedding.empty()) saved_ = session_.outputs().Stage(o.save_embedding);
        if (!o.picture.empty()) picture_ = session_.outputs().Stage(o.picture);
    }

    /// What can't be written is refused before it is computed.
    void RequireFormat() const {
        if (options_.output.empty()) return;
        const Io::Format& format = Io::FormatOf(options_.output);
        const bool has_cells = model_.topology.n_cells() > 0;
        if (has_cells ? !format.solids : !format.surfaces) {
            throw IoError(options_.output + ": " + std::string(format.name) + " files can't hold " +
                          (has_cells ? "the cells" : "the surface") + " of " + options_.model + "; name a .vtu file");
        }
    }

    void Embed() {
        session_.Stage("read lattice");
        lattice_ = std::make_unique<ModelLattice>(options_.lattice, options_.scheme, session_);
        const std::vector<double>& control = lattice_->mesh().positions;
        if (text_of_model_) {
            const auto vertices = text_of_model_->normal_vertices();
            const auto normals = text_of_model_->normals();
            normals_ = {{vertices.begin(), vertices.end()}, {normals.begin(), normals.end()}};
        } else {
            normals_ = NormalsOf(model_);
        }
        const double step = 1e-5 * Geometry::BoundingBox(control).Diagonal();  // far below cells, far above rounding
        session_.Stage("embed");
        const SolidSubdiv::Deform::EmbedOptions how{.scheme = lattice_->scheme(),
                                                    .levels = options_.levels,
                                                    .limit = options_.limit,
                                                    .outside = SolidSubdiv::Deform::OutsideOf(options_.outside),
                                                    .falloff = options_.falloff,
                                                    .notes = lattice_->option_values(),
                                                    .progress = session_.progress()};
        const auto embed = [&](const std::vector<double>& points) {
            return About(options_.lattice, [&] {
                return SolidSubdiv::Deform::Embedding::Create(lattice_->descriptor(), control, points, how);
            });
        };
        embedding_ = embed(WithTangents(model_.positions, normals_, step));
        if (!saved_.empty()) {
            session_.Stage("save embedding");
            (normals_.empty() ? *embedding_ : embed(model_.positions)).Save(saved_);
            AddOutput("embedding", options_.save_embedding, saved_);
        }
        const std::vector<Index> folded = lattice_->FoldedCells(control);
        TellFolded(options_.lattice, folded);
        json_["lattice"] = {{"file", options_.lattice},
                            {"control_points", lattice_->mesh().topology.n_vertices},
                            {"cells", lattice_->mesh().topology.n_cells()},
                            {"folded", folded}};
        text_ += Counted(model_.topology.n_vertices, "vertex", "vertices") + " in a lattice of " +
                 Counted(lattice_->mesh().topology.n_vertices, "control point", "control points") + " and " +
                 Counted(lattice_->mesh().topology.n_cells(), "cell", "cells");
        TellSettings();
    }

    void TellNormalsThatStay() {
        if (!NormalsOf(model_).empty() || (text_of_model_ && !text_of_model_->normals().empty())) {
            session_.Note(options_.model +
                          ": normals stay as they are: an embedding holds vertices alone; name the "
                          "--lattice to carry them");
        }
    }

    void LoadEmbedding() {
        session_.Stage("load embedding");
        embedding_ = SolidSubdiv::Deform::Embedding::Load(options_.embedding);
        if (embedding_->n_points() != model_.topology.n_vertices) {
            throw InvalidInput(options_.embedding + ": holds " + Counted(embedding_->n_points(), "point", "points") +
                               ", " + options_.model + " has " +
                               Counted(model_.topology.n_vertices, "vertex", "vertices"));
        }
        json_["lattice"] = {{"embedding", options_.embedding}, {"control_points", embedding_->n_control_points()}};
        text_ += Counted(model_.topology.n_vertices, "vertex", "vertices") + " embedded among " +
                 Counted(embedding_->n_control_points(), "control point", "control points");
        TellSettings();
    }

    void TellSettings() {
        Json& json = json_["settings"];
        for (const auto& [name, value] : embedding_->settings()) json[name] = value;
        json["threads"] = Sdc::ThreadCount();
        const std::string levels = json["levels"].get<std::string>();
        text_ += ", " + json["scheme"].get<std::string>() +
                 (json["limit"] == "true" ? " in the limit" : ", level " + levels);
    }

    void TellOutside() {
        std::vector<Index> vertices;
        double farthest = 0;
        Json list = Json::array();
        for (const auto& out : embedding_->outside()) {
            if (out.point >= model_.topology.n_vertices) break;  // points beside vertices
            vertices.push_back(out.point);
            farthest = std::max(farthest, out.distance);
            list.push_back({{"vertex", out.point}, {"distance", out.distance}, {"factor", out.factor}});
        }
        json_["outside"] = {{"count", vertices.size()}, {"farthest", farthest}, {"vertices", list}};
        if (vertices.empty()) return;
        const std::string way = json_["settings"]["outside"].get<std::string>();
        session_.Note(
            options_.model + ": " + Counted(static_cast<Offset>(vertices.size()), "vertex lies", "vertices lie") +
            " outside the lattice, at most " + Text(farthest) + " away (--outside " + way + "): " + FirstOf(vertices));
    }

    void TellFolded(const std::string& file, const std::vector<Index>& folded) {
        if (folded.empty()) return;
        session_.Note(file + ": " + Counted(static_cast<Offset>(folded.size()), "cell is", "cells are") +
                      " folded or inverted: " + FirstOf(folded));
    }

    void Deform() {
        SolidSubdiv::Deform::Deformer deformer(*embedding_);
        std::vector<double> points(3 * static_cast<std::size_t>(embedding_->n_points()));
        for (std::size_t i = 0; i < outputs_.size(); ++i) {
            session_.Stage("deform");
            Report(session_.progress(), "deform", static_cast<double>(i) / static_cast<double>(outputs_.size()));
            Json state = {{"output", OutputName(i)}};
            if (options_.drag.empty()) {
                moved_lattice_ = ReadMoved(options_.to[i]);
                state["to"] = options_.to[i];
            } else {
                Drag(state);
            }
            deformer.Deform(moved_lattice_.positions, points);
            deformed_ = model_;
            deformed_.positions.assign(points.begin(),
                                       points.begin() + static_cast<std::ptrdiff_t>(model_.positions.size()));
            if (lattice_) {
                state["folded"] = lattice_->FoldedCells(moved_lattice_.positions);
                TellFolded(options_.drag.empty() ? options_.to[i] : "the lattice after " + options_.drag,
                           state["folded"].get<std::vector<Index>>());
            }
            TellLargest(state);
            session_.Stage("write");
            const std::vector<double> normals = TurnedNormals(points, normals_);
            if (text_of_model_) {
                const std::span<const double> kept = text_of_model_->normals();
                text_of_model_->Write(outputs_[i], deformed_.positions, normals_.empty() ? kept : normals);
            } else {
                SetNormals(deformed_, normals);
                Io::WriteMesh(outputs_[i], deformed_,
                              {.keep_octahedra = options_.keep_octahedra, .binary = !options_.ascii});
                if (i == 0) TellLeftOut();
            }
            if (i == 0 && !lattice_) TellNormalsThatStay();
            json_["states"].push_back(std::move(state));
            AddOutput("model", OutputName(i), outputs_[i]);
        }
    }

    /// Moves the lattice by the least change that brings dragged vertices to their targets.
    void Drag(Json& state) {
        const auto targets = ReadDragTargets(options_.drag, model_.topology.n_vertices);
        const std::vector<Index> triangles = options_.preserve_volume ? SurfaceTriangles(model_) : std::vector<Index>();
        moved_lattice_ = lattice_->mesh();
        const auto result = About(options_.drag, [&] {
            return SolidSubdiv::Deform::Drag(
                *embedding_, moved_lattice_.positions, targets,
                {.locked = options_.lock, .preserve_volume = options_.preserve_volume, .triangles = triangles});
        });
        moved_lattice_.positions = result.control_points;
        state["drag"] = {{"file", options_.drag},
                         {"targets", targets.size()},
                         {"moved_control_points", result.moved.size()},
                         {"largest_residual", result.largest_residual},
                         {"is_consistent", result.is_consistent},
                         {"immovable", result.immovable},
                         {"iterations", result.iterations}};
        if (options_.preserve_volume) {
            state["drag"]["volume_before"] = result.volume_before;
            state["drag"]["volume_after"] = result.volume_after;
        }
        if (!result.immovable.empty()) {
            session_.Note(options_.drag + ": no control point moves " +
                          Counted(static_cast<Offset>(result.immovable.size()), "vertex", "vertices") + ": " +
                          FirstOf(result.immovable));
        }
        if (!result.is_consistent) {
            session_.Note(options_.drag + ": not all targets are reached: the farthest is missed by " +
                          Text(result.largest_residual));
        }
        if (saved_lattice_.empty()) return;
        Io::WriteMesh(saved_lattice_, moved_lattice_, {.keep_octahedra = true, .binary = !options_.ascii});
        AddOutput("lattice", options_.save_lattice, saved_lattice_);
    }

    Io::Mesh ReadMoved(const std::string& file) const {
        if (lattice_) return lattice_->ReadMoved(file, session_);
        Io::Mesh moved = Io::ReadMesh(file);
        if (moved.topology.n_vertices != embedding_->n_control_points()) {
            throw InvalidInput(file + ": has " + Counted(moved.topology.n_vertices, "control point", "control points") +
                               ", " + options_.embedding + " " + std::to_string(embedding_->n_control_points()));
        }
        return moved;
    }

    void TellLargest(Json& state) const {
        double largest = 0;
        Index vertex = kNoIndex;
        for (std::size_t v = 0; 3 * v < model_.positions.size(); ++v) {
            const double* const a = &model_.positions[3 * v];
            const double* const b = &deformed_.positions[3 * v];
            const double distance = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
            if (distance > largest) {
                largest = distance;
                vertex = static_cast<Index>(v);
            }
        }
        state["largest_move"] = {{"vertex", vertex}, {"distance", largest}};
    }

    void TellLeftOut() {
        std::string names;
        for (const std::string& name : Io::AttributesLeftOut(options_.output, deformed_)) {
            names += (names.empty() ? "" : ", ") + name;
        }
        if (!names.empty()) session_.Note(options_.output + ": the format can't carry " + names + ", left out");
    }

    void AddOutput(const std::string& what, const std::string& file, const std::filesystem::path& written) {
        json_["outputs"].push_back({{"what", what}, {"file", file}, {"bytes", std::filesystem::file_size(written)}});
        said_ += "\nwrote " + file;
    }

    void WritePicture() {
#ifdef SOLIDSUBDIV_HAS_PICTURES
        session_.Stage("picture");
        const Io::Mesh* const lattice = lattice_ ? &lattice_->mesh() : nullptr;
        std::vector<Picture::DeformationState> states{{&model_, lattice, "model in its lattice"}};
        if (!outputs_.empty()) {
            states.push_back({&deformed_, lattice ? &moved_lattice_ : nullptr,
                              outputs_.size() == 1 ? "deformed" : "last of the sequence"});
        }
        Picture::WritePng(picture_, Picture::DeformationPicture(states, {}, session_.progress()));
        AddOutput("picture", options_.picture, picture_);
#endif
        session_.EndStage();
    }

    const DeformOptions& options_;
    Session& session_;
    std::vector<std::filesystem::path> outputs_;
    std::filesystem::path saved_, saved_lattice_, picture_;
    Io::Mesh model_, deformed_, moved_lattice_;
    std::unique_ptr<ModelLattice> lattice_;
    std::optional<Io::ObjText> text_of_model_;  // where an OBJ file becomes another
    ModelNormals normals_;
    std::optional<SolidSubdiv::Deform::Embedding> embedding_;
    Json json_ = {{"command", "deform"}};
    std::string text_, said_;
};

}  // namespace

void RunDeform(const DeformOptions& options, Session& session) { DeformCommand(options, session).Run(); }

}  // namespace SolidSubdiv::Cli
