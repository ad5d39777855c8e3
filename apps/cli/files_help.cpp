// SPDX-License-Identifier: Apache-2.0
// The formats that work, for the help.
#include <solidsubdiv/apps/cli/files_help.h>

#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/kit/io/points.h>
#include <solidsubdiv/kit/io/volumes.h>

namespace SolidSubdiv::Cli {

namespace {

template <class Predicate>
std::string Extensions(Predicate&& is_wanted) {
    std::string list;
    for (const Io::Format& format : Io::Formats()) {
        if (is_wanted(format)) list += (list.empty() ? "" : ", ") + std::string(format.extension);
    }
    return list;
}

}  // namespace

std::string ReadableFilesHelp() {
    return "Files read: " + Extensions([](const Io::Format& f) { return f.read != nullptr; });
}

std::string ReadableTargetsHelp() {
    const auto list = [](const auto& formats) {
        std::string text;
        for (const auto& format : formats) text += (text.empty() ? "" : ", ") + std::string(format.extension);
        return text;
    };
    return "Volumes: " + list(Io::VolumeFormats()) + "; points: " + list(Io::PointFormats());
}

std::string WritableFilesHelp() {
    return "Files written: solids " + Extensions([](const Io::Format& f) { return f.write && f.solids; }) +
           "; surfaces " + Extensions([](const Io::Format& f) { return f.write && f.surfaces; });
}

}  // namespace SolidSubdiv::Cli
