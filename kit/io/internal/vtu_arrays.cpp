// SPDX-License-Identifier: Apache-2.0
// The arrays of a VTK XML file.
#include <solidsubdiv/kit/io/internal/vtu_arrays.h>

#include <bit>
#include <optional>

#include <solidsubdiv/kit/io/internal/base64.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/zlib_blocks.h>

namespace SolidSubdiv::Io::Internal {

namespace {

std::optional<NumberType> TypeNamed(std::string_view name) {
    constexpr std::string_view names[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                          "UInt32", "Int64", "UInt64", "Float32", "Float64"};
    for (int i = 0; i < 10; ++i) {
        if (names[i] == name) return static_cast<NumberType>(i);
    }
    return std::nullopt;
}

/// Raw bytes with the reading interface of Base64Stream.
class RawStream {
  public:
    explicit RawStream(std::string_view bytes) : bytes_(bytes) {}
    std::string Read(std::uint64_t n) {
        const std::string part(bytes_.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(n, bytes_.size()))));
        bytes_.remove_prefix(part.size());
        return part;
    }

  private:
    std::string_view bytes_;
};

}  // namespace

VtuArrays::VtuArrays(const pugi::xml_node& vtk_file, std::string_view appended, bool appended_is_raw, std::string file)
    : appended_(appended), appended_is_raw_(appended_is_raw), file_(std::move(file)) {
    const std::string_view order = vtk_file.attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") {
        Fail(file_, "byte_order is " + Quoted(order) + "; it must be LittleEndian or BigEndian");
    }
    swap_bytes_ = (order == "BigEndian") != (std::endian::native == std::endian::big);

    const std::string_view header = vtk_file.attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64") {
        Fail(file_, "header_type is " + Quoted(header) + "; it must be UInt32 or UInt64");
    }
    if (header == "UInt64") header_type_ = NumberType::UInt64;

    const std::string_view compressor = vtk_file.attribute("compressor").as_string();
    compressed_ = compressor == "vtkZLibDataCompressor";
    if (!compressed_ && !compressor.empty()) {
        Fail(file_, "is compressed with " + Quoted(compressor) +
                        ", which can't be read; save it with vtkZLibDataCompressor or without compression");
    }
}

bool VtuArrays::HoldsNumbers(const pugi::xml_node& array) {
    return TypeNamed(array.attribute("type").as_string()).has_value();
}

std::string VtuArrays::PlaceOf(const pugi::xml_node& array) {
    const std::string_view name = array.attribute("Name").as_string();
    if (name.empty()) return "an array of " + std::string(array.parent().name());
    return "array " + Quoted(name) + " of " + array.parent().name();
}

std::uint64_t VtuArrays::HeaderNumber(std::string_view bytes) const {
    if (header_type_ == NumberType::UInt32) return LoadNumber<std::uint32_t>(bytes.data(), swap_bytes_);
    return LoadNumber<std::uint64_t>(bytes.data(), swap_bytes_);
}

/// Uncompressed: a number of bytes and the bytes. Compressed: the number of blocks, the size of a block and of the last
/// one if that is shorter, the compressed sizes; then the blocks.
template <class Source>
std::string VtuArrays::ReadFrom(Source source, const std::string& place) const {
    const auto word_size = static_cast<std::uint64_t>(SizeOf(header_type_));
    const auto require = [&](bool complete) {
        if (!complete) Fail(file_, place + ": its data end too early or are no Base64; is the file complete?");
    };
    const auto next_word = [&] {
        const std::string bytes = source.Read(word_size);
        require(bytes.size() == word_size);
        return HeaderNumber(bytes);
    };
    if (!compressed_) {
        const std::uint64_t n_bytes = next_word();
        CountAppended(n_bytes, place);
        std::string data = source.Read(n_bytes);
        require(data.size() == n_bytes);
        return data;
    }
    CompressedBlocks blocks;
    const std::uint64_t n_blocks = next_word();
    blocks.block_size = next_word();
    blocks.last_block_size = next_word();
    std::uint64_t total = 0;
    for (std::uint64_t i = 0; i < n_blocks; ++i) {
        blocks.compressed_sizes.push_back(next_word());
        require(blocks.compressed_sizes.back() <= UINT64_MAX - total);
        total += blocks.compressed_sizes.back();
    }
    CountAppended(total, place);
    const std::string bytes = source.Read(total);
    require(bytes.size() == total);
    return Expand(blocks, bytes, file_, place);
}

/// Arrays may share appended data, but thousands that all name the same large block are an attack on the memory.
void VtuArrays::CountAppended(std::uint64_t n_bytes, const std::string& place) const {
    constexpr std::uint64_t most_sharers = 16;
    n_appended_read_ += std::min<std::uint64_t>(n_bytes, appended_.size());
    if (n_appended_read_ > most_sharers * appended_.size())
        Fail(file_, place + ": too many arrays share the appended data");
}

std::string VtuArrays::Data(const pugi::xml_node& array) const {
    const std::string place = PlaceOf(array);
    const std::string_view format = array.attribute("format").as_string("ascii");
    if (format == "binary") return ReadFrom(Base64Stream(array.text().get()), place);
    if (format != "appended") Fail(file_, place + " has the unknown format " + Quoted(format));
    const std::uint64_t offset = array.attribute("offset").as_ullong();
    if (offset >= appended_.size())
        Fail(file_, place + " starts behind the end of the appended data; is the file complete?");
    const std::string_view rest = appended_.substr(static_cast<std::size_t>(offset));
    return appended_is_raw_ ? ReadFrom(RawStream(rest), place) : ReadFrom(Base64Stream(rest), place);
}

template <class T>
std::vector<T> VtuArrays::Numbers(const pugi::xml_node& array) const {
    const std::string place = PlaceOf(array);
    const std::optional<NumberType> type = TypeNamed(array.attribute("type").as_string());
    if (!type) Fail(file_, place + " has the unknown type " + Quoted(array.attribute("type").as_string()));

    if (std::string_view(array.attribute("format").as_string("ascii")) == "ascii") {
        std::vector<T> numbers;
        TextCursor text(array.text().get(), file_, place);
        while (text.SkipSpace()) {
            if constexpr (std::is_same_v<T, double>) {
                numbers.push_back(text.Real("a number"));
            } else {
                numbers.push_back(text.Integer("an integer"));
            }
        }
        return numbers;
    }
    const std::string data = Data(array);
    if (data.size() % static_cast<std::size_t>(SizeOf(*type)) != 0) {
        Fail(file_, place + " has " + std::to_string(data.size()) + " bytes, not a multiple of its numbers' size");
    }
    return ConvertNumbers<T>(data, *type, swap_bytes_);
}

std::vector<std::int64_t> VtuArrays::Integers(const pugi::xml_node& array) const {
    const std::optional<NumberType> type = TypeNamed(array.attribute("type").as_string());
    if (type && !IsInteger(*type)) Fail(file_, PlaceOf(array) + " must be of an integer type");
    return Numbers<std::int64_t>(array);
}

template std::vector<double> VtuArrays::Numbers<double>(const pugi::xml_node&) const;

}  // namespace SolidSubdiv::Io::Internal
