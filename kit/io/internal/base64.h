// SPDX-License-Identifier: Apache-2.0
// Base64 text as a stream of bytes. Padding may stand anywhere: VTK encodes an array's header and its data one by one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

class Base64Stream {
  public:
    explicit Base64Stream(std::string_view text) : text_(text) {}

    /// The next n bytes, or less where the text ends or isn't Base64.
    std::string Read(std::uint64_t n);

  private:
    bool DecodeGroup();

    std::string_view text_;
    std::size_t at_ = 0;
    std::string waiting_;  // decoded, not read yet: up to three bytes
};

}  // namespace SolidSubdiv::Io::Internal
