// SPDX-License-Identifier: Apache-2.0
// Targets of `fit` from files.
#include <solidsubdiv/apps/cli/fit_target.h>

#include <utility>

#include <solidsubdiv/apps/cli/lattice_mesh.h>
#include <solidsubdiv/apps/cli/target_report.h>
#include <solidsubdiv/apps/fit/cloud.h>
#include <solidsubdiv/apps/fit/open_surface.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/apps/voxel/volume_surface.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/points.h>
#include <solidsubdiv/kit/io/volumes.h>

namespace SolidSubdiv::Cli {

namespace {

/// Whole numbers of more kinds than this are taken for grey values: no map of labels, to name one of, is that long.
constexpr std::size_t kMostLabels = 150;

/// The label or the level that is meant. @throws InvalidInput where several may be
FitTargetOptions Chosen(const FitTargetOptions& asked, const Geometry::Volume& volume) {
    FitTargetOptions chosen = asked;
    if (asked.label || asked.iso) return chosen;
    const std::vector<double> labels = Geometry::LabelsOf(volume);
    if (labels.size() == 1) {
        throw InvalidInput("each voxel is " + Text(labels[0]) + ": there is no surface to fit to");
    }
    if (labels.size() == 2) {
        chosen.label = labels[1];  // a mask
    } else if (labels.empty() || labels.size() > kMostLabels) {
        chosen.iso = Voxel::OtsuThreshold(volume.values);
    } else {
        constexpr std::size_t kListed = 20;
        std::string list;
        for (std::size_t i = 0; i < std::min(labels.size(), kListed); ++i)
            list += (i > 0 ? ", " : "") + Text(labels[i]);
        throw InvalidInput("has " + std::to_string(labels.size()) + " labels (" + list +
                           (labels.size() > kListed ? ", ..." : "") +
                           "): name one with --label, or a level of grey values with --iso");
    }
    return chosen;
}

/// Words about a surface that a user should know.
void NoteSurface(const std::string& file, const Voxel::VolumeSurface& surface, Session& session) {
    if (surface.touches_border) session.Note(file + ": reaches the border of the volume; closed there");
    if (surface.n_dropped_pieces + surface.n_filled_cavities > 0) {
        session.Note(file + ": " + Counted(surface.n_dropped_pieces, "piece", "pieces") + " left out and " +
                     Counted(surface.n_filled_cavities, "cavity", "cavities") +
                     " filled, each of less than a hundredth of the largest piece's voxels");
    }
}

void ReadVolumeTarget(const std::string& file, const FitTargetOptions& asked, Session& session, FitTarget& target) {
    const Geometry::Volume volume = Io::ReadVolume(file);
    for (const std::string& note : volume.notes) session.Note(file + ": " + note);
    session.Stage("surface");
    About(file, [&] {
        const FitTargetOptions chosen = Chosen(asked, volume);
        const bool is_label = chosen.label.has_value();
        const double smooth = chosen.smooth.value_or(is_label ? 1 : 0);
        Voxel::VolumeSurface surface = is_label ? Voxel::SurfaceOfLabel(volume, *chosen.label, {.smooth = smooth})
                                                : Voxel::SurfaceOfLevel(volume, *chosen.iso, {.smooth = smooth});
        if (!is_label && !asked.iso) {
            session.Note(file + ": grey values are cut at " + Text(*chosen.iso) +
                         " (Otsu's threshold); another level: --iso");
        }
        NoteSurface(file, surface, session);
        target.json = {{"kind", "volume"},
                       {is_label ? "label" : "iso", is_label ? *chosen.label : *chosen.iso},
                       {"smooth", smooth},
                       {"pieces", surface.n_pieces},
                       {"dropped_pieces", surface.n_dropped_pieces},
                       {"filled_cavities", surface.n_filled_cavities},
                       {"touches_border", surface.touches_border}};
        target.positions = std::move(surface.positions);
        target.triangles = std::move(surface.triangles);
    });
}

void TurnTriangles(std::vector<Index>& triangles) {
    for (std::size_t t = 0; t < triangles.size(); t += 3) std::swap(triangles[t + 1], triangles[t + 2]);
}

void ReadMeshTarget(const std::string& file, Session& session, FitTarget& target) {
    const Io::Mesh mesh = Io::ReadMesh(file);
    for (const std::string& note : mesh.notes) session.Note(file + ": " + note);
    target.positions = mesh.positions;
    target.triangles = SurfaceTriangles(mesh);
    if (target.triangles.empty()) throw InvalidInput(file + ": has no faces: there is no surface to fit to");
    if (About(file, [&] { return Fit::LooksInwards(target.Surface()); })) {
        TurnTriangles(target.triangles);
        session.Note(file + ": its faces look inwards; turned around");
    }
    target.json = {{"kind", "mesh"}};
}

void ReadCloudTarget(const std::string& file, Session& session, FitTarget& target) {
    Geometry::PointCloud cloud = Io::ReadPoints(file);
    for (const std::string& note : cloud.notes) session.Note(file + ": " + note);
    session.Stage("surface");
    Fit::CloudShape shape =
        About(file, [&] { return Fit::ShapeOfCloud(cloud.positions, cloud.normals, session.progress()); });
    if (shape.has_turned_normals) session.Note(file + ": its normals look inwards; turned around");
    if (shape.triangles.empty()) {
        session.Note(file + ": its points enclose nothing that can be told; the fit starts from an ellipsoid");
    }
    target.json = {
        {"kind", "points"},
        {"spacing", shape.spacing},
        {"normals", shape.has_estimated_normals ? "estimated" : "given"},
        {"closing_radius", shape.radius},
        // Between points a target has no surface: the way from the limit ends at the nearest point.
        {"measured", "target_to_surface; surface_to_target is to the nearest point, half the spacing or more"}};
    target.positions = std::move(cloud.positions);
    target.normals = std::move(shape.normals);
    target.closing_positions = std::move(shape.positions);
    target.closing_triangles = std::move(shape.triangles);
}

}  // namespace

Fit::TargetSurface FitTarget::Surface() const {
    return {.positions = positions, .triangles = triangles, .normals = normals};
}

Fit::TargetSurface FitTarget::Start() const {
    if (closing_triangles.empty()) return Surface();
    return {.positions = closing_positions, .triangles = closing_triangles};
}

FitTarget ReadFitTarget(const std::string& file, const FitTargetOptions& options, Session& session) {
    session.Stage("read");
    FitTarget target;
    const bool is_volume = Io::FindVolumeFormat(file) != nullptr;
    if (options.label && options.iso) throw UsageError("--label and --iso: name one of them");
    if (!is_volume && (options.label || options.iso || options.smooth)) {
        throw UsageError(file + ": --label, --iso and --smooth are of volumes");
    }
    if (is_volume) {
        ReadVolumeTarget(file, options, session, target);
    } else if (HoldsPointsAlone(file)) {
        ReadCloudTarget(file, session, target);
    } else {
        ReadMeshTarget(file, session, target);
    }
    target.diagonal = Geometry::BoundingBox(target.positions).Diagonal();
    if (!(target.diagonal > 0)) throw InvalidInput(file + ": is a single point; there is nothing to fit to");
    Offset euler = 0;
    const auto n_vertices = static_cast<Index>(target.positions.size() / 3);
    const auto components = Geometry::SurfaceComponents(target.triangles, n_vertices);
    for (const auto& c : components) {
        target.n_border_edges += c.n_border_edges;
        euler += c.EulerCharacteristic();
    }
    Json json = {{"file", file}};
    json.update(target.json);
    json.update({{"vertices", n_vertices}, {"triangles", target.triangles.size() / 3}, {"diagonal", target.diagonal}});
    if (!target.is_cloud()) {
        json.update({{"components", components.size()},
                     {"border_edges", target.n_border_edges},
                     {"euler_characteristic", euler}});
    }
    target.json = std::move(json);
    return target;
}

void CloseFitTarget(const std::string& file, FitTarget& target, Session& session) {
    session.Stage("surface");
    Fit::CloudShape shape =
        About(file, [&] { return Fit::CloseSurface(target.positions, target.triangles, session.progress()); });
    if (shape.triangles.empty()) {
        throw InvalidInput(file + ": the target is open: " + std::to_string(target.n_border_edges) +
                           " border edges, and encloses nothing that can be told; fit a cage (--model surface)");
    }
    if (shape.has_turned_normals) {
        TurnTriangles(target.triangles);
        session.Note(file + ": its faces look inwards; turned around");
    }
    session.Note(file + ": has " + Counted(target.n_border_edges, "border edge", "border edges") +
                 ": the solid starts from a surface that bridges the holes, where nothing draws it");
    target.json["closing_radius"] = shape.radius;
    target.closing_positions = std::move(shape.positions);
    target.closing_triangles = std::move(shape.triangles);
}

}  // namespace SolidSubdiv::Cli
