// SPDX-License-Identifier: Apache-2.0
// Choosing from a list of formats by a file's name, and reading what may not fit the memory.
#pragma once

#include <filesystem>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

/// The first format whose extension ends the file's name, or null.
template <class Format>
const Format* FindFormat(std::span<const Format> formats, const std::filesystem::path& path) {
    const std::string name = LowerCase(path.filename().string());
    for (const Format& format : formats) {
        if (name.size() > format.extension.size() && name.ends_with(format.extension)) return &format;
    }
    return nullptr;
}

/// The same. @throws IoError naming the file and the known extensions
template <class Format>
const Format& ChooseFormat(std::span<const Format> formats, const std::filesystem::path& path) {
    if (const Format* format = FindFormat(formats, path)) return *format;
    const std::string extension = LowerCase(path.extension().string());
    std::string known;
    for (const Format& format : formats) known += (known.empty() ? "" : ", ") + std::string(format.extension);
    Fail(NameOf(path),
         (extension.empty() ? "the name has no extension" : "the extension " + Quoted(extension) + " is unknown") +
             "; known are " + known);
}

/// What read() gives. @throws IoError too if there is not enough memory for it
template <class Read>
auto ReadWithinMemory(const std::filesystem::path& path, const std::string& what_to_do, Read&& read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    Fail(NameOf(path), "needs more memory than there is; " + what_to_do);
}

}  // namespace SolidSubdiv::Io::Internal
