// SPDX-License-Identifier: Apache-2.0
// Reads Gmsh meshes (.msh) of versions 1, 2 and 4.1, text and binary: the sections, and data on nodes and elements.
#include <solidsubdiv/kit/io/internal/gmsh.h>
#include <solidsubdiv/kit/io/internal/numbers.h>
#include <solidsubdiv/kit/io/internal/readers.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// Gmsh itself knows 1, 3 and 9. Elements without data get zeros, so that the file's size alone does not bound the
/// memory.
constexpr std::int64_t kMostComponents = 64;

enum class Version { One, Two, FourOne };

class GmshReader {
  public:
    GmshReader(std::string_view bytes, const std::string& file) : numbers_(bytes, file), mesh_(file) {}

    Mesh Read() {
        std::string section(text().Word());
        if (section == "$NOD") {
            version_ = Version::One;
        } else if (section == "$MeshFormat") {
            ReadFormat();
            End(section);
            section = text().Word();
        } else {
            Fail(text().file(), "is no Gmsh mesh: it must start with $MeshFormat or $NOD");
        }
        for (; !section.empty(); section = text().Word()) {
            if (section[0] != '$') text().FailHere("expected a section like $Nodes, found " + Quoted(section));
            ReadSection(section);
        }
        if (!have_nodes_ || !have_elements_) {
            Fail(text().file(),
                 std::string("has no section of ") + (have_nodes_ ? "elements" : "nodes") + "; is the file complete?");
        }
        return mesh_.Finish();
    }

  private:
    TextCursor& text() { return numbers_.text; }

    void ReadFormat() {
        const std::string version(text().Word());
        if (version == "4.1") {
            version_ = Version::FourOne;
        } else if (version == "2" || version.substr(0, 2) == "2.") {
            version_ = Version::Two;
        } else {
            text().FailHere("version " + Quoted(version) + " can't be read; save the mesh as version 4.1 or 2.2");
        }
        const std::int64_t binary = text().Integer("0 for text or 1 for binary");
        const std::int64_t size_bytes = text().Integer("the size of a number");
        if (binary != 0 && binary != 1) text().FailHere("the file's type must be 0 (text) or 1 (binary)");
        if (size_bytes != 8 && (version_ == Version::Two || size_bytes != 4)) {
            text().FailHere("numbers of " + std::to_string(size_bytes) + " bytes can't be read");
        }
        numbers_.size_bytes = static_cast<int>(size_bytes);
        if (binary == 0) return;
        numbers_.binary = true;
        numbers_.BeginBinary();
        const std::string_view one = text().Bytes(4, "the number that tells the byte order");
        numbers_.swap_bytes = LoadNumber<std::int32_t>(one.data(), false) != 1;
        if (LoadNumber<std::int32_t>(one.data(), numbers_.swap_bytes) != 1) {
            text().FailHere("the number that tells the byte order is damaged");
        }
    }

    void ReadSection(const std::string& section) {
        const bool nodes = section == "$Nodes" || section == "$NOD";
        const bool elements = section == "$Elements" || section == "$ELM";
        if (elements && !have_nodes_) text().FailHere("the elements come before the nodes");
        if ((elements && have_elements_) || (nodes && have_nodes_)) text().FailHere("a second section " + section);
        if (nodes) {
            version_ == Version::FourOne ? ReadGmsh4Nodes(numbers_, mesh_) : ReadGmsh2Nodes(numbers_, mesh_);
            have_nodes_ = true;
        } else if (elements) {
            if (version_ == Version::FourOne) {
                ReadGmsh4Elements(numbers_, entities_, mesh_);
            } else {
                version_ == Version::One ? ReadGmsh1Elements(numbers_, mesh_) : ReadGmsh2Elements(numbers_, mesh_);
            }
            have_elements_ = true;
        } else if (section == "$Entities" && version_ == Version::FourOne) {
            entities_ = ReadGmsh4Entities(numbers_);
        } else if (section == "$NodeData" || section == "$ElementData") {
            if (!have_elements_) text().FailHere(section + " comes before the elements");
            ReadData(section == "$NodeData");
        } else {
            if (section == "$ParametricNodes") {
                text().FailHere("$ParametricNodes can't be read; save the mesh without parametric coordinates");
            }
            if (section == "$PartitionedEntities")
                mesh_.AddNote("the mesh is partitioned; its physical labels may be lost");
            if (section == "$ElementNodeData") mesh_.AddNote("$ElementNodeData is left out");
            return SkipSection(section);
        }
        End(section);
    }

    static std::string EndOf(const std::string& section) {
        const bool first_version = section == "$NOD" || section == "$ELM";
        return (first_version ? "$END" : "$End") + section.substr(1);
    }

    void End(const std::string& section) {
        const std::string end = EndOf(section);
        if (text().PeekWord() != end) text().FailExpected(end);
        text().Word();
    }

    void SkipSection(const std::string& section) {
        if (!text().SkipPast(EndOf(section))) text().FailHere("section " + Quoted(section) + " has no end");
    }

    /// String tags (the name first), real tags (the time), integer tags (step, components, rows), then the rows.
    void ReadData(bool of_nodes) {
        std::string name = of_nodes ? "node data" : "element data";
        const std::int64_t n_strings = text().Count("names of the data");
        for (std::int64_t i = 0; i < n_strings; ++i) {
            text().SkipSpace();
            std::string line(text().RestOfLine());
            if (i > 0) continue;
            while (!line.empty() && IsSpace(line.back())) line.pop_back();
            name =
                line.size() > 1 && line.front() == '"' && line.back() == '"' ? line.substr(1, line.size() - 2) : line;
        }
        const std::int64_t n_reals = text().Count("real tags of the data");
        for (std::int64_t i = 0; i < n_reals; ++i) text().Real("a real tag of the data");
        const std::int64_t n_integers = text().Count("integer tags of the data");
        std::int64_t width = 1, n = 0;
        for (std::int64_t i = 0; i < n_integers; ++i) {
            const std::int64_t value = text().Integer("an integer tag of the data");
            if (i == 1) width = value;
            if (i == 2) n = value;
        }
        const std::int64_t row_bytes = numbers_.binary ? 4 + 8 * width : 2 + 2 * width;
        if (width < 1 || width > kMostComponents || n < 0 || n > (text().remaining() + 1) / row_bytes) {
            text().FailHere(std::to_string(n) + " rows of " + std::to_string(width) +
                            " are announced; the rest of the file does not hold them");
        }
        numbers_.BeginBinary();
        std::vector<std::int64_t> tags;
        std::vector<double> values;
        for (std::int64_t i = 0; i < n; ++i) {
            tags.push_back(numbers_.Int("the number of a node or element"));
            for (std::int64_t k = 0; k < width; ++k) values.push_back(numbers_.Real("a value"));
        }
        mesh_.AddData(of_nodes, name, static_cast<int>(width), tags, values);
    }

    GmshNumbers numbers_;
    GmshMesh mesh_;
    Version version_ = Version::Two;
    std::vector<GmshEntity> entities_;
    bool have_nodes_ = false;
    bool have_elements_ = false;
};

}  // namespace

Mesh ParseGmsh(std::string_view bytes, const std::string& file) { return GmshReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal
