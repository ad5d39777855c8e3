// SPDX-License-Identifier: Apache-2.0
// Embeddings in files: a header, the tables as arrays of little-endian numbers, a checksum. docs/embedding_file.md.
#include <solidsubdiv/apps/deform/embedding.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <solidsubdiv/apps/deform/internal/embedding_check.h>

namespace SolidSubdiv::Deform {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

constexpr char kMagic[8] = {'S', 'S', 'D', 'E', 'M', 'B', 'E', 'D'};
constexpr std::uint64_t kVersion = 1;

/// FNV-1a of 64 bits, eight bytes a step. @pre the length is a multiple of eight
std::uint64_t Checksum(std::string_view bytes) {
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data() + i, 8);
        sum = (sum ^ word) * 0x100000001b3u;
    }
    return sum;
}

/// Every item is filled up with zeros to a multiple of eight bytes.
class Writer {
  public:
    void Bytes(const void* from, std::size_t n) {
        bytes_.append(static_cast<const char*>(from), n);
        bytes_.resize((bytes_.size() + 7) / 8 * 8);
    }
    void Number(std::uint64_t n) { Bytes(&n, 8); }
    void Count(Index& n) { Number(static_cast<std::uint64_t>(n)); }
    template <class List>
    void List64(const List& list) {
        Number(list.size());
        Bytes(list.data(), list.size() * sizeof(typename List::value_type));
    }
    template <class T>
    void Items(Array<T>& array) {
        List64(array);
    }
    void Items(std::string& text) { List64(text); }
    template <class T>
    std::size_t Resize(std::vector<T>& list) {
        Number(list.size());
        return list.size();
    }
    void Double(double& x) { Bytes(&x, 8); }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    std::string_view Bytes(std::size_t n) {
        if (n > rest_.size()) throw InvalidInput("it ends in the middle of its tables");
        const std::string_view bytes = rest_.substr(0, n);
        rest_.remove_prefix(std::min(rest_.size(), (n + 7) / 8 * 8));
        return bytes;
    }
    std::uint64_t Number() {
        std::uint64_t n;
        std::memcpy(&n, Bytes(8).data(), 8);
        return n;
    }
    void Count(Index& n) {
        const std::uint64_t number = Number();
        if (number > static_cast<std::uint64_t>(std::numeric_limits<Index>::max())) {
            throw InvalidInput("a count is " + std::to_string(number) + ", more than fit");
        }
        n = static_cast<Index>(number);
    }
    /// A length of things that take at least `size` bytes each.
    std::size_t Length(std::size_t size) {
        const std::uint64_t n = Number();
        if (n > rest_.size() / size) throw InvalidInput("it ends in the middle of its tables");
        return static_cast<std::size_t>(n);
    }
    template <class T>
    void Items(Array<T>& array) {
        array.resize(Length(sizeof(T)));
        const std::string_view bytes = Bytes(array.size() * sizeof(T));
        if (!bytes.empty()) std::memcpy(array.data(), bytes.data(), bytes.size());
    }
    void Items(std::string& text) { text = Bytes(Length(1)); }
    template <class T>
    std::size_t Resize(std::vector<T>& list) {
        list.resize(Length(8));
        return list.size();
    }
    void Double(double& x) { std::memcpy(&x, Bytes(8).data(), 8); }

    bool is_at_end() const { return rest_.empty(); }

  private:
    std::string_view rest_;
};

template <class Archive>
void Rows(Archive& archive, Far::StencilRows<double>& rows) {
    archive.Count(rows.n_sources);
    archive.Items(rows.offsets);
    archive.Items(rows.indices);
    archive.Items(rows.weights);
}

template <class Archive, int kCorners>
void Cells(Archive& archive, EmbeddedCells<kCorners>& cells) {
    archive.Items(cells.corners);
    archive.Items(cells.offsets);
    archive.Items(cells.points);
    archive.Items(cells.at);
}

/// What is in a file between the header and the checksum, in its order: written and read by the same lines.
template <class Archive>
void Contents(Archive& archive, std::vector<std::pair<std::string, std::string>>& settings, EmbeddingTables& tables) {
    archive.Resize(settings);
    for (auto& setting : settings) {
        archive.Items(setting.first);
        archive.Items(setting.second);
    }
    archive.Count(tables.n_points);
    archive.Count(tables.n_control_points);
    archive.Resize(tables.cascade);
    for (auto& level : tables.cascade) Rows(archive, level);
    Cells(archive, tables.hexes);
    Cells(archive, tables.tets);
    Rows(archive, tables.rows);
    archive.Items(tables.row_points);
    archive.Resize(tables.outside);
    for (OutsidePoint& out : tables.outside) {
        archive.Count(out.point);
        archive.Double(out.distance);
        archive.Double(out.factor);
        for (double& x : out.constant) archive.Double(x);
    }
}

std::string ReadAll(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file || !std::filesystem::is_regular_file(path)) throw IoError(path.string() + ": can't be opened");
    const std::streamoff size = file.tellg();
    if (size < 0) throw IoError(path.string() + ": can't be read");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.seekg(0);
    file.read(bytes.data(), size);
    if (!file) throw IoError(path.string() + ": can't be read");
    return bytes;
}

}  // namespace

void Embedding::Save(const std::filesystem::path& path) const {
    Embedding copy = *this;  // the same lines read: they take what they could change
    Writer writer;
    writer.Bytes(kMagic, sizeof kMagic);
    writer.Number(kVersion);
    Contents(writer, copy.settings_, copy.tables_);
    writer.Number(Checksum(writer.bytes()));

    std::filesystem::path beside = path;
    beside += ".part";
    std::ofstream file(beside, std::ios::binary);
    file.write(writer.bytes().data(), static_cast<std::streamsize>(writer.bytes().size()));
    file.close();
    std::error_code error;
    if (file) std::filesystem::rename(beside, path, error);
    if (!file || error) {
        std::filesystem::remove(beside, error);
        throw IoError(path.string() + ": can't be written");
    }
}

Embedding Embedding::Load(const std::filesystem::path& path) {
    const std::string bytes = ReadAll(path);
    Embedding embedding;
    try {
        if (bytes.size() < 24 || bytes.compare(0, sizeof kMagic, kMagic, sizeof kMagic) != 0) {
            throw InvalidInput("is no embedding");
        }
        Reader reader(std::string_view(bytes).substr(sizeof kMagic, bytes.size() - sizeof kMagic - 8));
        const std::uint64_t version = reader.Number();
        if (version != kVersion) {
            throw InvalidInput("has version " + std::to_string(version) +
                               " of embeddings; this program reads version " + std::to_string(kVersion) +
                               "; embed the model anew");
        }
        std::uint64_t sum;
        std::memcpy(&sum, bytes.data() + bytes.size() - 8, 8);
        if (bytes.size() % 8 != 0 || sum != Checksum(std::string_view(bytes).substr(0, bytes.size() - 8))) {
            throw InvalidInput("is damaged: its checksum does not fit; embed the model anew");
        }
        Contents(reader, embedding.settings_, embedding.tables_);
        if (!reader.is_at_end()) throw InvalidInput("goes on behind its tables");
        Internal::CheckTables(embedding.tables_);
    } catch (const InvalidInput& error) {
        throw IoError(path.string() + ": " + error.what());
    }
    return embedding;
}

}  // namespace SolidSubdiv::Deform
