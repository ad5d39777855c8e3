// SPDX-License-Identifier: Apache-2.0
// MEDIT meshes (.mesh), text: sections of vertices and elements, each row with an integer reference at its end; lists
// of those edges (Ridges) and vertices (Corners) that are infinitely sharp.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/mesh_builder.h>
#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io::Internal {

namespace {

struct MeditSection {
    std::string_view keyword;
    ElementKind kind;
};

constexpr std::array<MeditSection, 8> kSections = {{{"Edges", ElementKind::Edge},
                                                    {"Triangles", ElementKind::Triangle},
                                                    {"Quadrilaterals", ElementKind::Quad},
                                                    {"Tetrahedra", ElementKind::Tet},
                                                    {"Hexahedra", ElementKind::Hex},
                                                    {"Hexaedra", ElementKind::Hex},  // as some programs spell it
                                                    {"Prisms", ElementKind::Wedge},
                                                    {"Pyramids", ElementKind::Pyramid}}};

class MeditReader {
  public:
    MeditReader(std::string_view bytes, const std::string& file) : text_(bytes, file), builder_(file, 1) {}

    Mesh Read() {
        text_.SkipComments('#');
        if (text_.Word() != "MeshVersionFormatted") {
            Fail(text_.file(), "is no MEDIT mesh: it must start with MeshVersionFormatted");
        }
        text_.Integer("the version");
        while (text_.SkipComments('#')) {
            const std::string keyword(text_.Word());
            if (keyword == "End") break;
            ReadSection(keyword);
        }
        if (!have_vertices_) Fail(text_.file(), "has no Vertices; is the file complete?");
        AddLabels("reference", point_labels_, true);
        AddLabels("reference", cell_labels_, false);
        AddSharpness();
        return builder_.Finish();
    }

  private:
    void ReadSection(const std::string& keyword) {
        if (keyword == "Dimension") {
            dimension_ = Integer("2 or 3 dimensions");
            if (dimension_ != 2 && dimension_ != 3) text_.FailHere("Dimension must be 2 or 3");
            return;
        }
        if (keyword == "Vertices") return ReadVertices();
        if (keyword == "Corners") return ReadCorners();
        if (keyword == "Ridges") return ReadRidges();
        const auto found =
            std::find_if(kSections.begin(), kSections.end(), [&](const auto& s) { return s.keyword == keyword; });
        if (found != kSections.end()) return ReadElements(found->kind);
        if (keyword.find_first_of("0123456789+-.") == 0) {
            text_.FailHere("expected a keyword like Tetrahedra, found " + Quoted(keyword));
        }
        if (keyword.size() > 2 && keyword.substr(keyword.size() - 2) >= "P2" &&
            keyword.substr(keyword.size() - 2) <= "P4") {
            text_.FailHere(Quoted(keyword) + " are elements of higher order, which can't be used; save linear ones");
        }
        SkipUnknown(keyword);
    }

    /// Everything up to the next word that starts with a letter.
    void SkipUnknown(const std::string& keyword) {
        builder_.AddNote("section " + Quoted(keyword) + " is left out");
        while (text_.SkipComments('#')) {
            const char first = text_.PeekWord()[0];
            if ((first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z')) return;
            text_.Word();
        }
    }

    void ReadVertices() {
        if (have_vertices_) text_.FailHere("a second section of Vertices");
        have_vertices_ = true;
        text_.SkipComments('#');
        const std::int64_t n = text_.Count("vertices", 2 * dimension_ + 2);
        std::vector<double> positions;
        positions.reserve(static_cast<std::size_t>(3 * n));
        for (std::int64_t i = 0; i < n; ++i) {
            for (std::int64_t k = 0; k < 3; ++k) {
                text_.SkipComments('#');
                positions.push_back(k < dimension_ ? text_.Real("a coordinate") : 0.0);
            }
            point_labels_.push_back(static_cast<double>(Integer("a vertex's reference")));
        }
        builder_.AddPositions(positions);
    }

    void ReadElements(ElementKind kind) {
        text_.SkipComments('#');
        const auto n_vertices = static_cast<std::size_t>(InfoOf(kind).n_vertices);
        const std::int64_t n = text_.Count(InfoOf(kind).plural, 2 * static_cast<std::int64_t>(n_vertices) + 2);
        std::array<std::int64_t, 8> vertices;
        for (std::int64_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n_vertices; ++k) {
                const std::size_t place = kind == ElementKind::Wedge ? kTurnedWedge[k] : k;
                vertices[place] = Integer("a vertex of an element");
                if (vertices[place] < 1)
                    text_.FailHere("an element names vertex " + std::to_string(vertices[place]) +
                                   "; vertices are counted from 1");
                --vertices[place];
            }
            const Offset row = builder_.NextRow();
            if (kind == ElementKind::Edge) edge_rows_.push_back(row);
            builder_.AddElement(kind, {vertices.data(), n_vertices});
            cell_labels_.push_back(static_cast<double>(Integer("an element's reference")));
        }
    }

    void ReadCorners() {
        text_.SkipComments('#');
        const std::int64_t n = text_.Count("corners");
        for (std::int64_t i = 0; i < n; ++i) {
            const std::int64_t vertex = Integer("a corner's vertex") - 1;
            if (vertex < 0)
                text_.FailHere("a corner is vertex " + std::to_string(vertex + 1) + "; vertices are counted from 1");
            sharp_rows_.push_back(builder_.NextRow());
            builder_.AddElement(ElementKind::Vertex, {&vertex, 1});
            cell_labels_.push_back(0);
        }
    }

    /// Numbers of edges, whose section may come later.
    void ReadRidges() {
        text_.SkipComments('#');
        const std::int64_t n = text_.Count("ridges");
        for (std::int64_t i = 0; i < n; ++i) ridges_.push_back(Integer("a ridge's edge"));
    }

    void AddSharpness() {
        for (const std::int64_t edge : ridges_) {
            if (edge < 1 || edge > static_cast<std::int64_t>(edge_rows_.size())) {
                Fail(text_.file(), "a ridge is edge " + std::to_string(edge) + " of " +
                                       std::to_string(edge_rows_.size()) + "; edges are counted from 1");
            }
            sharp_rows_.push_back(edge_rows_[static_cast<std::size_t>(edge) - 1]);
        }
        if (sharp_rows_.empty()) return;
        Attribute sharpness{std::string(kSharpness), 1, {}};
        sharpness.values.assign(static_cast<std::size_t>(builder_.n_rows()), 0.0);
        for (const Offset row : sharp_rows_)
            sharpness.values[static_cast<std::size_t>(row)] = static_cast<double>(kInfinitelySharp);
        builder_.AddCellData(std::move(sharpness));
    }

    std::int64_t Integer(std::string_view what) {
        text_.SkipComments('#');
        return text_.Integer(what);
    }

    void AddLabels(const char* name, std::vector<double>& labels, bool of_points) {
        if (std::all_of(labels.begin(), labels.end(), [](double label) { return label == 0; })) return;
        Attribute attribute{name, 1, std::move(labels)};
        of_points ? builder_.AddPointData(std::move(attribute)) : builder_.AddCellData(std::move(attribute));
    }

    TextCursor text_;
    MeshBuilder builder_;
    std::int64_t dimension_ = 3;
    bool have_vertices_ = false;
    std::vector<double> point_labels_;
    std::vector<double> cell_labels_;
    std::vector<Offset> edge_rows_;
    std::vector<std::int64_t> ridges_;
    std::vector<Offset> sharp_rows_;
};

bool IsInfinite(double sharpness) { return sharpness >= static_cast<double>(kInfinitelySharp); }

/// MEDIT carries one integer a row: the reference, or, for meshes from Gmsh, the physical label.
const Attribute* References(std::span<const Attribute> attributes) {
    const Attribute* reference = FindLabels(attributes, "reference");
    return reference ? reference : FindLabels(attributes, "physical");
}

/// The kinds that have sections of elements; single vertices have one if all of them are corners.
std::vector<ElementKind> KindsOf(const std::vector<double>& sharpness, Offset n_vertices) {
    std::vector<ElementKind> kinds;
    for (const MeditSection& section : kSections) kinds.push_back(section.kind);
    const bool all_corners = std::all_of(sharpness.end() - n_vertices, sharpness.end(), IsInfinite);
    if (all_corners) kinds.push_back(ElementKind::Vertex);
    return kinds;
}

void WriteList(OutputFile& file, std::string_view keyword, const std::vector<Offset>& numbers) {
    if (numbers.empty()) return;
    file << keyword << '\n' << numbers.size() << '\n';
    for (const Offset number : numbers) file << number << '\n';
}

void Write(const std::filesystem::path& path, const Mesh& mesh) {
    const Attribute* const data = FindSharpness(mesh);
    const std::vector<double> sharpness =
        data ? data->values : std::vector<double>(static_cast<std::size_t>(mesh.topology.n_elements()), 0.0);
    RequireKinds(path, mesh, "MEDIT", KindsOf(sharpness, mesh.topology.n_point_elements()));
    const Attribute* point_labels = References(mesh.point_data);
    const Attribute* cell_labels = References(mesh.cell_data);

    OutputFile file(path);
    file << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.topology.n_vertices << '\n';
    for (std::size_t at = 0; at < mesh.positions.size(); at += 3) {
        file << mesh.positions[at] << ' ' << mesh.positions[at + 1] << ' ' << mesh.positions[at + 2] << ' '
             << LabelOf(point_labels, at / 3) << '\n';
    }
    std::size_t row = 0;
    std::vector<Offset> ridges;
    for (const ElementKind kind : kAllElementKinds) {
        const Offset n = CountOf(mesh.topology, kind);
        if (n == 0 || kind == ElementKind::Vertex) continue;
        const auto section =
            std::find_if(kSections.begin(), kSections.end(), [&](const auto& s) { return s.kind == kind; });
        file << section->keyword << '\n' << n << '\n';
        for (Offset element = 0; element < n; ++element, ++row) {
            const std::span<const Index> v = ElementVertices(mesh.topology, kind, element);
            for (std::size_t i = 0; i < v.size(); ++i) {
                file << v[kind == ElementKind::Wedge ? kTurnedWedge[i] : i] + 1 << ' ';
            }
            file << LabelOf(cell_labels, row) << '\n';
            if (kind == ElementKind::Edge && IsInfinite(sharpness[row])) ridges.push_back(element + 1);
        }
    }
    WriteList(file, "Ridges", ridges);
    std::vector<Offset> corners(mesh.topology.vertices.begin(), mesh.topology.vertices.end());
    for (Offset& corner : corners) ++corner;
    WriteList(file, "Corners", corners);
    file << "End\n";
    file.Commit();
}

}  // namespace

Mesh ParseMedit(std::string_view bytes, const std::string& file) { return MeditReader(bytes, file).Read(); }

bool MeditCarries(const Mesh& mesh, const Attribute& attribute) {
    if (&attribute == References(mesh.point_data) || &attribute == References(mesh.cell_data)) return true;
    if (&attribute != FindSharpness(mesh)) return false;
    std::size_t row = 0;
    bool carried = true;
    ForEachElement(mesh.topology, [&](ElementKind kind, Offset) {
        const double sharpness = attribute.values[row++];
        carried = carried && (sharpness == 0 || (IsInfinite(sharpness) && CanBeSharp(kind)));
    });
    return carried;
}

void WriteMedit(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions&) {
    mesh.topology.octs.empty() ? Write(path, mesh) : Write(path, CutOctahedra(mesh));
}

}  // namespace SolidSubdiv::Io::Internal
