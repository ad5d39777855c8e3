// SPDX-License-Identifier: Apache-2.0
// An OBJ file as text in which vertices and normals are moved and all else stays as it is: texture coordinates,
// materials, groups, comments, tags. For programs that move a model and must not lose what they don't know.
//
//     Io::ObjText text("model.obj");
//     text.Write("moved.obj", moved_positions, turned_normals);
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Io {

class ObjText {
  public:
    /// @throws IoError as ReadMesh, and where a face names a normal that is not there
    explicit ObjText(const std::filesystem::path& path);

    Index n_vertices() const { return n_vertices_; }
    /// Normals of faces' corners: each pair of a vertex and a normal once, in the order of the file. A normal that
    /// several vertices share stands once for each: they may turn differently.
    std::span<const Index> normal_vertices() const { return normal_vertices_; }  ///< (n)
    std::span<const double> normals() const { return normals_; }                 ///< (n, 3)

    /// Writes the file with other positions, (n_vertices, 3), and other normals, (n, 3). Beside and renamed.
    /// @throws InvalidInput where a length does not fit, IoError
    void Write(const std::filesystem::path& path, std::span<const double> positions,
               std::span<const double> normals) const;

  private:
    /// A line that is written anew.
    struct Edit {
        std::size_t begin, end;  ///< in the text
        enum { Vertex, Normal, Element } kind;
        std::string text{};  ///< of a vertex what follows its position; of an element its words, where
                             ///< each '\1' stands for the next of `pairs`
        std::vector<Index> pairs{};
    };

    std::string bytes_;
    std::vector<Edit> edits_;
    Index n_vertices_ = 0;
    std::vector<Index> normal_vertices_;
    std::vector<double> normals_;
};

}  // namespace SolidSubdiv::Io
