// SPDX-License-Identifier: Apache-2.0
// Writes the seeds of fuzz_embedding, small embeddings of every kind:
//   build/fuzz/bin/embedding_seeds regression/fuzz/corpus/fuzz_embedding
#include <filesystem>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/embedding.h>

using namespace SolidSubdiv;

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    const std::vector<double> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    const std::vector<Index> hex{0, 1, 2, 3, 4, 5, 6, 7};
    const std::vector<Index> tets{0, 1, 3, 4, 1, 2, 3, 6, 1, 6, 4, 5, 3, 4, 6, 7, 1, 3, 4, 6};
    const std::vector<double> points{.5, .5, .5, .3, .6, .4, .1, .1, .2, 1.2, .5, .5, .5, 3, .5};
    const auto save = [&](const char* name, bool is_hex, const Deform::EmbedOptions& options) {
        Far::TopologyDescriptor lattice{.n_vertices = 8};
        (is_hex ? lattice.hexes : lattice.tets) = is_hex ? hex : tets;
        Deform::Embedding::Create(lattice, corners, points, options).Save(folder / name);
    };
    using Deform::Outside;
    save("hexes", true, {.levels = 1});
    save("hexes_level_0", true, {.levels = 0, .outside = Outside::Leave});
    save("tets", false, {.scheme = Sdc::BoxSpline{}, .levels = 1, .outside = Outside::Clamp});
    save("tets_level_2", false, {.scheme = Sdc::BoxSpline{}, .levels = 2, .notes = {{"by", "seeds"}}});
    save("rows", true, {.levels = 1, .limit = true});
    save("rows_level_0", true, {.levels = 0, .limit = true, .outside = Outside::Leave});
    return 0;
}
