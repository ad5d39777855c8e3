// SPDX-License-Identifier: Apache-2.0
// Deforms a model in real time: one control point of its lattice moves through 240 frames, then all of them do.
//
//     deform_loop MODEL LATTICE CONTROL_POINT OUT
//     deform_loop bunny.obj bunny_lattice.vtu 500 last_frame.obj
#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/io/formats.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

using namespace SolidSubdiv;

constexpr int kFrames = 240;

/// Calls draw(frame) for every frame and says how fast that went.
template <class Draw>
void Animate(const char* what, Draw&& draw) {
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 1; frame <= kFrames; ++frame) draw(frame);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%s: %.0f frames per second\n", what, kFrames / seconds.count());
}

int Run(char** arguments) {
    Io::Mesh model = Io::ReadMesh(arguments[1]);
    const Io::Mesh lattice = Io::ReadSolid(arguments[2]);
    const auto moved = static_cast<Index>(std::atoi(arguments[3]));

    // Once: each vertex of the model finds its cell in the lattice, refined twice. Catmull-Clark takes cells of every
    // kind. An embedding can be saved, and loaded next time.
    const auto embedding = Deform::Embedding::Create(lattice.topology, lattice.positions, model.positions,
                                                     {.scheme = Sdc::CatmullClarkSolid{}, .levels = 2});
    std::printf("%d vertices, %zu of them outside the lattice; %d control points\n", embedding.n_points(),
                embedding.outside().size(), embedding.n_control_points());

    // As often as you like: new control points, new positions of the model.
    Deform::Deformer deformer(embedding);
    std::printf("control point %d touches %zu vertices\n", moved, deformer.Affected({&moved, 1}).size());
    std::vector<double> control = lattice.positions;
    const double reach = 0.1 * Geometry::BoundingBox(control).Diagonal();
    deformer.Deform(control, model.positions);

    // One moves: Update writes what it touches, nothing else.
    double& y = control[3 * static_cast<std::size_t>(moved) + 1];
    const double rest = y;
    Animate("one control point", [&](int frame) {
        y = rest + reach * std::sin(0.1 * frame);
        deformer.Update({&moved, 1}, control, model.positions);
    });

    // All move: a wave runs through the lattice.
    Animate("all control points", [&](int frame) {
        for (std::size_t i = 0; i < control.size(); i += 3) {
            const double x = lattice.positions[i];
            control[i + 1] = lattice.positions[i + 1] + 0.3 * reach * std::sin(0.1 * frame + x / reach);
        }
        deformer.Deform(control, model.positions);
    });
    Io::WriteMesh(arguments[4], model);
    return 0;
}

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: deform_loop MODEL LATTICE CONTROL_POINT OUT\n");
        return 2;
    }
    try {
        return Run(argv);
    } catch (const std::exception& error) {  // a bad file or control point: one line that says which and why
        std::fprintf(stderr, "deform_loop: %s\n", error.what());
        return 1;
    }
}
