// SPDX-License-Identifier: Apache-2.0
// The order of things in a file is that of OpenVDB's Archive, Grid, RootNode, InternalNode and LeafNode.
#include <solidsubdiv/apps/voxel/internal/vdb_file.h>

#include <openvdb/openvdb.h>

#include <algorithm>
#include <array>
#include <bit>
#include <istream>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace SolidSubdiv::Voxel::Internal {

namespace {

using Mask = std::vector<std::uint64_t>;

/// What a type of grid has in a file.
struct GridType {
    const char* name;
    std::size_t value_bytes, half_bytes;  ///< half: saved as numbers of 16 bits, 0 where they never are
    std::size_t leaf_bytes = 0;           ///< of leaves without values: bits and where they are
};
constexpr GridType kGridTypes[] = {
    {"Tree_float_5_4_3", 4, 2},  {"Tree_double_5_4_3", 8, 2},   {"Tree_int32_5_4_3", 4, 0},
    {"Tree_int64_5_4_3", 8, 0},  {"Tree_vec3i_5_4_3", 12, 0},   {"Tree_vec3s_5_4_3", 12, 6},
    {"Tree_vec3d_5_4_3", 24, 6}, {"Tree_mask_5_4_3", 1, 0, 76}, {"Tree_bool_5_4_3", 1, 0, 140}};

class FileCheck {
  public:
    explicit FileCheck(std::istream& file) : file_(file) {
        file_.seekg(0, std::ios::end);
        left_ = size_ = static_cast<std::uint64_t>(file_.tellg());
        file_.seekg(0);
    }

    void Check() {
        Expect(Read<std::int64_t>() == openvdb::OPENVDB_MAGIC, "not a VDB file");
        const auto version = Read<std::uint32_t>();
        Expect(
            version >= openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION && version <= openvdb::OPENVDB_FILE_VERSION,
            "its format has the number " + std::to_string(version) + "; 222 to " +
                std::to_string(openvdb::OPENVDB_FILE_VERSION) + " can be read");
        openvdb::io::setCurrentVersion(file_);  // from 222 on the same for all that is read here
        Skip(4 + 4 + 1 + 36);                   // the library's version, whether there are offsets, a unique name
        CheckMetadata();
        const auto n_grids = Read<std::int32_t>();
        Expect(n_grids >= 0 && static_cast<std::uint64_t>(n_grids) <= left_ / 36,  // what a grid takes at least
               "it can't have " + std::to_string(n_grids) + " grids");
        for (std::int32_t i = 0; i < n_grids; ++i) CheckGrid();
    }

  private:
    /// @throws std::runtime_error
    void Expect(bool is_right, const std::string& otherwise) const {
        if (!is_right) throw std::runtime_error((grid_.empty() ? "" : "grid '" + grid_ + "': ") + otherwise);
    }
    /// The next n bytes must be there. @throws std::ios::failure
    void Take(std::uint64_t n) {
        if (n > left_) throw std::ios::failure("the file ends");
        left_ -= n;
    }
    void Skip(std::uint64_t n) {
        Take(n);
        file_.ignore(static_cast<std::streamsize>(n));
    }
    template <class Number>
    Number Read() {
        Number number;
        Take(sizeof(Number));
        file_.read(reinterpret_cast<char*>(&number), sizeof(Number));
        return number;
    }
    std::string ReadString() {
        const auto n = Read<std::uint32_t>();
        Take(n);
        std::string text(n, ' ');
        file_.read(text.data(), n);
        return text;
    }
    Mask ReadMask(int log2) {
        Mask mask(std::size_t{1} << (3 * log2 - 6));
        for (std::uint64_t& word : mask) word = Read<std::uint64_t>();
        return mask;
    }
    std::uint64_t Here() const { return size_ - left_; }
    void GoTo(std::uint64_t place) {
        file_.seekg(static_cast<std::streamoff>(place));
        left_ = size_ - place;
    }

    openvdb::MetaMap CheckMetadata() {
        const std::uint64_t begin = Here();
        const auto n = Read<std::uint32_t>();
        for (std::uint32_t i = 0; i < n; ++i) {
            Skip(Read<std::uint32_t>());  // the name
            const bool is_of_leaves = ReadString() == openvdb::io::DelayedLoadMetadata::staticTypeName();
            const auto bytes = Read<std::uint32_t>();
            is_of_leaves ? CheckDelayedLoad(bytes) : Skip(bytes);
        }
        // OpenVDB knows how long numbers are, whatever the file says, and must get as far.
        const std::uint64_t end = Here();
        GoTo(begin);
        openvdb::MetaMap metadata;
        metadata.readMeta(file_);
        Expect(static_cast<std::uint64_t>(file_.tellg()) == end, "an entry of its metadata has a wrong length");
        GoTo(end);
        return metadata;
    }
    /// Two numbers of every leaf, each list as it is or packed.
    void CheckDelayedLoad(std::uint32_t bytes) {
        if (bytes == 0) return;
        const std::uint64_t n_leaves = Read<std::uint32_t>();
        CheckPacked(Read<std::uint32_t>(), n_leaves * sizeof(openvdb::io::DelayedLoadMetadata::MaskType));
        const auto packed = Read<std::uint32_t>();
        if (packed != std::numeric_limits<std::uint32_t>::max()) {
            CheckPacked(packed, n_leaves * sizeof(openvdb::io::DelayedLoadMetadata::CompressedSizeType));
        }
    }
    void CheckPacked(std::uint64_t packed, std::uint64_t bytes) {
        constexpr std::uint64_t kLeast = 128;  // up to which OpenVDB fills shorter lists before it packs them
        packed == 0 ? Skip(bytes) : CheckBlosc(packed, std::max(bytes, kLeast));
    }
    /// Blosc's own header of 16 bytes says both sizes.
    void CheckBlosc(std::uint64_t packed, std::uint64_t bytes) {
        const auto header = Read<std::array<std::uint32_t, 4>>();
        Expect(header[1] == bytes && header[3] == packed && packed >= sizeof(header),
               std::to_string(bytes) + " bytes are packed into " + std::to_string(packed) + ", but Blosc has " +
                   std::to_string(header[1]) + " and " + std::to_string(header[3]));
        Skip(packed - sizeof(header));
    }

    void CheckGrid() {
        grid_.clear();
        const std::string name = ReadString();
        grid_ = name.substr(0, name.find('\x1e'));  // numbers that make names unique follow
        std::string type = ReadString();
        constexpr std::string_view kHalf = "_HalfFloat";
        const bool is_half = type.ends_with(kHalf);
        if (is_half) type.resize(type.size() - kHalf.size());
        const auto* known = std::find_if(std::begin(kGridTypes), std::end(kGridTypes),
                                         [&](const GridType& t) { return type == t.name; });
        Expect(known != std::end(kGridTypes), "those of type '" + type + "' can't be read");
        type_ = *known;
        is_half_ = is_half && type_.half_bytes > 0;
        const bool has_tree_of_another = !ReadString().empty();
        Skip(8 + 8 + 8);  // where its parts are

        compression_ = Read<std::uint32_t>();
        const openvdb::MetaMap metadata = CheckMetadata();
        const auto half = metadata[openvdb::GridBase::META_SAVE_HALF_FLOAT];
        Expect((half && half->asBool()) == is_half, "it says both that its numbers have 16 bits and that they don't");
        const std::uint64_t transform = Here();
        Take(Read<std::uint32_t>());  // its type's name
        GoTo(transform);
        openvdb::math::Transform().read(file_);
        GoTo(static_cast<std::uint64_t>(file_.tellg()));
        if (!has_tree_of_another) CheckTree();
    }

    void CheckTree() {
        Expect(Read<std::int32_t>() == 1, "it has more than one buffer a leaf");
        Skip(type_.value_bytes);  // the background
        const auto n_tiles = Read<std::uint32_t>(), n_children = Read<std::uint32_t>();
        std::set<std::array<std::int32_t, 3>> origins;
        const auto check_origin = [&] {
            const auto origin = Read<std::array<std::int32_t, 3>>();
            const std::string place =
                std::to_string(origin[0]) + " " + std::to_string(origin[1]) + " " + std::to_string(origin[2]);
            Expect((origin[0] | origin[1] | origin[2]) % 4096 == 0, "no node can begin at " + place);
            Expect(origins.insert(origin).second, "two nodes begin at " + place);
        };
        for (std::uint32_t i = 0; i < n_tiles; ++i) {
            check_origin();
            Skip(type_.value_bytes);
            Expect(Read<std::uint8_t>() <= 1, "a tile is neither active nor inactive");
        }
        n_leaves_ = 0;
        for (std::uint32_t i = 0; i < n_children; ++i) {
            check_origin();
            CheckNode(5);
        }
        for (; n_leaves_ > 0; --n_leaves_) {
            if (type_.leaf_bytes > 0) {
                Skip(type_.leaf_bytes);
            } else {
                CheckValues(ReadMask(3), false);
            }
        }
    }
    /// Of 2^log2 voxels, tiles or nodes along each side.
    void CheckNode(int log2) {
        if (log2 == 3) {
            Skip(64);  // which voxels are active
            ++n_leaves_;
            return;
        }
        const Mask children = ReadMask(log2), values = ReadMask(log2);
        int n_children = 0;
        for (std::size_t i = 0; i < children.size(); ++i) {
            Expect((children[i] & values[i]) == 0, "a node has both a node and an active value in one place");
            n_children += std::popcount(children[i]);
        }
        CheckValues(values, true);
        for (; n_children > 0; --n_children) CheckNode(log2 - 1);
    }
    void CheckValues(const Mask& active, bool is_inner) {
        const int form = Read<std::int8_t>();
        Expect(form >= 0 && form <= openvdb::io::NO_MASK_AND_ALL_VALS,
               "there is no form " + std::to_string(form) + " of values");
        constexpr int kInactiveValues[] = {0, 0, 1, 0, 1, 2, 0};
        Skip(kInactiveValues[form] * type_.value_bytes);
        const bool has_mask =
            form >= openvdb::io::MASK_AND_NO_INACTIVE_VALS && form < openvdb::io::NO_MASK_AND_ALL_VALS;
        if (has_mask) Skip(8 * active.size());

        std::size_t n = 64 * active.size();
        if ((compression_ & openvdb::io::COMPRESS_ACTIVE_MASK) != 0 && form != openvdb::io::NO_MASK_AND_ALL_VALS) {
            n = 0;
            for (std::uint64_t word : active) n += static_cast<std::size_t>(std::popcount(word));
        }
        if (is_half_ && n == 0) return;
        const std::size_t bytes = n * (is_half_ ? type_.half_bytes : type_.value_bytes);
        const bool is_blosc = (compression_ & openvdb::io::COMPRESS_BLOSC) != 0;
        if (!is_blosc && (compression_ & openvdb::io::COMPRESS_ZIP) == 0) return Skip(bytes);

        const std::uint64_t begin = Here();
        const auto packed = Read<std::int64_t>();
        if (packed <= 0) {
            Expect(packed == -static_cast<std::int64_t>(bytes), "values of a node of " + std::to_string(bytes) +
                                                                    " bytes are said to have " +
                                                                    std::to_string(packed).substr(packed < 0));
            Skip(bytes);
        } else if (is_blosc) {
            CheckBlosc(static_cast<std::uint64_t>(packed), bytes);
        } else {
            Skip(static_cast<std::uint64_t>(packed));
        }
        if (is_inner) {  // where OpenVDB would forget what it has, and never free it
            const std::uint64_t end = Here();
            GoTo(begin);
            unpacked_.resize(bytes);
            (is_blosc ? openvdb::io::bloscFromStream : openvdb::io::unzipFromStream)(file_, unpacked_.data(), bytes);
            GoTo(end);
        }
    }

    std::istream& file_;
    std::uint64_t size_ = 0, left_ = 0;
    std::string grid_;  ///< the name of the one that is read
    GridType type_{};
    bool is_half_ = false;
    std::uint32_t compression_ = 0;
    std::size_t n_leaves_ = 0;
    std::vector<char> unpacked_;
};

}  // namespace

void CheckVdbFile(std::istream& file) {
    FileCheck(file).Check();
    file.seekg(0);
}

}  // namespace SolidSubdiv::Voxel::Internal
