// SPDX-License-Identifier: Apache-2.0
// The arrays of a VTK XML file: text, Base64 or raw bytes, compressed or not, inside their element or appended.
#pragma once

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/internal/numbers.h>

namespace SolidSubdiv::Io::Internal {

/// What the file says of all its arrays, and the section that they may be appended in.
class VtuArrays {
  public:
    /// `appended` is the text or the raw bytes behind the underscore of AppendedData.
    VtuArrays(const pugi::xml_node& vtk_file, std::string_view appended, bool appended_is_raw, std::string file);

    /// All numbers of an array, whatever their type.
    std::vector<double> Reals(const pugi::xml_node& array) const { return Numbers<double>(array); }
    /// All numbers of an array of an integer type.
    std::vector<std::int64_t> Integers(const pugi::xml_node& array) const;

    /// False for arrays that hold no numbers (String).
    static bool HoldsNumbers(const pugi::xml_node& array);
    static std::string PlaceOf(const pugi::xml_node& array);

  private:
    template <class T>
    std::vector<T> Numbers(const pugi::xml_node& array) const;
    std::string Data(const pugi::xml_node& array) const;
    template <class Source>
    std::string ReadFrom(Source source, const std::string& place) const;
    std::uint64_t HeaderNumber(std::string_view bytes) const;
    void CountAppended(std::uint64_t n_bytes, const std::string& place) const;

    std::string_view appended_;
    bool appended_is_raw_;
    std::string file_;
    bool swap_bytes_ = false;
    bool compressed_ = false;
    NumberType header_type_ = NumberType::UInt32;
    mutable std::uint64_t n_appended_read_ = 0;
};

}  // namespace SolidSubdiv::Io::Internal
