// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's tags in OBJ files: creases, corners, holes and settings of the scheme, as lines that start with `t`.
//
//     t crease 2/1/0 0 1 2.5         an edge of sharpness 2.5
//     t crease 4/2/0 0 1 1 2 3 4.5   two edges, a sharpness each
//     t corner 2/1/0 0 7 10          two vertices of one sharpness
//     t hole 2/0/0 0 5               two faces that are holes
//     t interpolateboundary 1/0/0 1  borders: 0 smooth, 1 sharp with sharp corners, 2 sharp
//     t creasemethod 0/0/1 chaikin   or normal
//
// Behind the name stands how many integers, numbers and words follow, in this order. Vertices and faces count from 0,
// not from 1 as in the rest of the file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/io/internal/element_map.h>
#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

/// Values of the tag `interpolateboundary`, as names of the scheme option `boundary`.
inline constexpr std::array<std::string_view, 3> kBoundaryNames = {"none", "edge-and-corner", "edge-only"};

/// The scheme option `creasing` and the word of the tag `creasemethod` for it.
struct CreasingName {
    std::string_view option, tag;
};
inline constexpr std::array<CreasingName, 2> kCreasingNames = {{{"uniform", "normal"}, {"chaikin", "chaikin"}}};

/// Collects what the tags say. Creases and corners become elements of the mesh where they stand in the file; one that
/// coincides with an earlier line, point or tag is the same element, with the larger sharpness.
class ObjTags {
  public:
    explicit ObjTags(MeshBuilder& builder) : builder_(builder) {}

    /// Is told of each face of the file before the builder gets its row.
    void NoteFace();
    /// Adds a line (two vertices) or a point of the file to the mesh, if it is not the element of a tag already.
    void AddElement(std::span<const std::int64_t> vertices);
    /// Reads what follows the `t`.
    void ReadTag(TextCursor& line);
    /// To be called when all vertices are there, before the builder finishes.
    void Finish();

    const std::vector<std::pair<std::string, std::string>>& scheme_options() const { return scheme_options_; }

  private:
    struct Tag {
        std::string_view name;
        std::array<std::int64_t, 3> counts;  ///< integers, numbers, words
    };

    static Tag ReadHead(TextCursor& line);
    [[noreturn]] static void FailCounts(const TextCursor& line, const Tag& tag, const std::string& needed);
    static void RequireEnd(TextCursor& line, const Tag& tag);
    void ReadSharp(TextCursor& line, std::size_t n_vertices, const char* needed);
    void ReadHoles(TextCursor& line);
    void ReadBoundary(TextCursor& line);
    void ReadCreasing(TextCursor& line);
    void Sharpen(std::span<const std::int64_t> vertices, double sharpness);
    void SetOption(const char* name, std::string_view value);
    void CountUnused(std::string_view name);

    void BeginMerging();

    MeshBuilder& builder_;
    /// Elements before the first sharp one, for the map: files without tags, which may have many lines, need none.
    struct EarlyElement {
        std::array<std::int64_t, 2> vertices;
        std::size_t n_vertices;
        std::int64_t row;
    };
    std::vector<EarlyElement> early_;
    bool merging_ = false;
    ElementMap rows_;
    std::vector<double> sharpness_;  ///< by row; ends with the last sharp one
    std::int64_t n_repeated_ = 0;

    std::int64_t largest_hole_ = -1;
    std::int64_t largest_vertex_ = -1;
    std::optional<TextCursor> largest_line_;  ///< of that vertex

    /// Faces one after another in the file, which are one after another among its rows too.
    struct FaceRun {
        std::int64_t first_face, first_row;
    };
    std::int64_t RowOfFace(std::int64_t face) const;
    std::vector<FaceRun> face_runs_;
    std::int64_t n_faces_ = 0;
    std::vector<std::int64_t> holes_;
    std::optional<TextCursor> hole_line_;  ///< of the largest

    std::vector<std::pair<std::string, std::string>> scheme_options_;
    std::vector<std::pair<std::string_view, std::int64_t>> unused_;
    std::string first_unknown_;
    std::int64_t n_unknown_ = 0;
};

}  // namespace SolidSubdiv::Io::Internal
