// SPDX-License-Identifier: Apache-2.0
// Reads the vertices of a PLY file as points.
#include <solidsubdiv/kit/io/internal/point_readers.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

Geometry::PointCloud ParsePlyPoints(std::string_view bytes, const std::string& file) {
    Mesh mesh = ParsePly(bytes, file);
    Geometry::PointCloud cloud{std::move(mesh.positions), {}, std::move(mesh.notes)};
    const Attribute* const parts[] = {mesh.FindPointData("nx"), mesh.FindPointData("ny"), mesh.FindPointData("nz")};
    if (parts[0] && parts[1] && parts[2]) {
        for (std::size_t i = 0; i < parts[0]->values.size(); ++i) {
            for (const Attribute* part : parts) cloud.normals.push_back(part->values[i]);
        }
    }
    const Offset n_elements = mesh.topology.n_elements();
    if (n_elements > 0) {
        cloud.notes.push_back(Counted(n_elements, "face or edge is", "faces and edges are") + " left out");
    }
    return cloud;
}

}  // namespace SolidSubdiv::Io::Internal
