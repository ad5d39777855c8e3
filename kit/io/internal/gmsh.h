// SPDX-License-Identifier: Apache-2.0
// What all versions of Gmsh's .msh have in common: numbered nodes and elements, labels, data by number.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/tag_map.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

/// Numbers of a .msh file, text or binary.
class GmshNumbers {
  public:
    GmshNumbers(std::string_view bytes, const std::string& file) : text(bytes, file) {}

    std::int64_t Int(std::string_view what) { return binary ? BinaryInteger(4, what) : text.Integer(what); }
    /// A size_t of the file (version 4).
    std::int64_t Size(std::string_view what) { return binary ? BinaryInteger(size_bytes, what) : text.Integer(what); }
    double Real(std::string_view what);
    /// A Size that the rest of the file can hold if each item takes at least min_bytes.
    std::int64_t Count(std::string_view what, std::int64_t min_bytes);

    /// Skips the line's end in front of binary numbers.
    void BeginBinary() {
        if (binary) text.SkipPastNewline();
    }

    TextCursor text;
    bool binary = false;
    bool swap_bytes = false;
    int size_bytes = 8;

  private:
    std::int64_t BinaryInteger(int n_bytes, std::string_view what);
};

/// Collects nodes, then elements, then data.
class GmshMesh {
  public:
    explicit GmshMesh(const std::string& file) : builder_(file) {}

    void AddNode(std::int64_t tag, double x, double y, double z);
    void EndNodes();
    /// Number of nodes of an element type. @throws IoError for those of higher order and unknown ones, by name
    int NodesOfType(std::int64_t type) const;
    void AddElement(std::int64_t type, std::int64_t tag, std::int64_t physical, std::int64_t elementary,
                    std::span<const std::int64_t> nodes);
    /// NodeData or ElementData: `values` has `width` numbers for each tag. Missing ones are 0.
    void AddData(bool of_nodes, std::string name, int width, std::span<const std::int64_t> tags,
                 std::span<const double> values);
    void AddNote(std::string note) { builder_.AddNote(std::move(note)); }
    Mesh Finish();

  private:
    MeshBuilder builder_;
    std::vector<double> positions_;
    TagMap nodes_;
    TagMap elements_;
    bool elements_sorted_ = false;
    std::vector<double> physical_;
    std::vector<double> elementary_;
};

/// $Nodes and $Elements of version 2 (text and binary), $NOD and $ELM of version 1; the cursor is behind these words.
void ReadGmsh2Nodes(GmshNumbers& numbers, GmshMesh& mesh);
void ReadGmsh2Elements(GmshNumbers& numbers, GmshMesh& mesh);
void ReadGmsh1Elements(GmshNumbers& numbers, GmshMesh& mesh);

/// Version 4.1: physical labels belong to the model's entities, (dimension, tag).
struct GmshEntity {
    std::int64_t dimension, tag, physical;

    bool operator<(const GmshEntity& other) const {
        return std::pair(dimension, tag) < std::pair(other.dimension, other.tag);
    }
};
/// Sorted.
std::vector<GmshEntity> ReadGmsh4Entities(GmshNumbers& numbers);
void ReadGmsh4Nodes(GmshNumbers& numbers, GmshMesh& mesh);
void ReadGmsh4Elements(GmshNumbers& numbers, const std::vector<GmshEntity>& entities, GmshMesh& mesh);

}  // namespace SolidSubdiv::Io::Internal
