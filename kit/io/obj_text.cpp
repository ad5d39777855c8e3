// SPDX-License-Identifier: Apache-2.0
// Lines are found as the reader finds them; those with positions, normals or indices of normals are written anew.
#include <solidsubdiv/kit/io/obj_text.h>

#include <charconv>
#include <unordered_map>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io {

using namespace Internal;

namespace {

/// An index of a corner, counted from 1 or back from the latest; from 0 on.
std::int64_t IndexOf(std::string_view digits, std::int64_t n_now, const TextCursor& line) {
    std::int64_t i = 0;
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), i);
    if (error != std::errc() || last != digits.data() + digits.size() || i == 0 || i < -n_now) {
        line.FailHere("the corner's index " + Quoted(digits) + " is none");
    }
    return i < 0 ? n_now + i : i - 1;
}

}  // namespace

ObjText::ObjText(const std::filesystem::path& path) : bytes_(ReadWholeFile(path)) {
    const std::string file = NameOf(path);
    TextCursor text(bytes_, file);
    std::vector<double> file_normals;
    std::vector<std::int64_t> normal_of_pair;
    std::unordered_map<std::uint64_t, Index> pairs;
    TextCursor line = text;
    for (;;) {
        const std::size_t begin = bytes_.size() - static_cast<std::size_t>(text.remaining());
        if (!text.NextLine(line, true)) break;
        const std::size_t end = bytes_.size() - static_cast<std::size_t>(text.remaining());
        const std::string_view keyword = line.Word();
        if (keyword == "v") {
            for (int c = 0; c < 3; ++c) line.Real("a coordinate");
            Edit edit{begin, end, Edit::Vertex};
            for (std::string_view word = line.Word(); !word.empty(); word = line.Word()) {
                edit.text += ' ';
                edit.text += word;
            }
            edits_.push_back(std::move(edit));
            ++n_vertices_;
        } else if (keyword == "vn") {
            for (int c = 0; c < 3; ++c) file_normals.push_back(line.Real("a normal"));
            edits_.push_back({begin, end, Edit::Normal});
        } else if (keyword == "f" || keyword == "fo") {
            Edit edit{begin, end, Edit::Element, std::string(keyword)};
            while (!line.AtComment()) {
                const std::string_view word = line.Word();
                edit.text += ' ';
                const std::size_t first = word.find('/');
                const std::size_t second = first == word.npos ? first : word.find('/', first + 1);
                if (second == word.npos || second + 1 == word.size()) {
                    edit.text += word;
                    continue;
                }
                const auto n_normals = static_cast<std::int64_t>(file_normals.size() / 3);
                const std::int64_t vertex = IndexOf(word.substr(0, first), n_vertices_, line);
                const std::int64_t normal = IndexOf(word.substr(second + 1), n_normals, line);
                const auto next = static_cast<Index>(normal_vertices_.size());
                const std::uint64_t key = static_cast<std::uint64_t>(vertex) << 32 | static_cast<std::uint64_t>(normal);
                const auto [pair, is_new] = pairs.try_emplace(key, next);
                if (is_new) {
                    normal_vertices_.push_back(static_cast<Index>(vertex));
                    normal_of_pair.push_back(normal);
                }
                edit.text += word.substr(0, second + 1);
                edit.text += '\1';
                edit.pairs.push_back(pair->second);
            }
            if (!edit.pairs.empty()) edits_.push_back(std::move(edit));
        }
    }
    for (std::size_t i = 0; i < normal_of_pair.size(); ++i) {
        const auto at = static_cast<std::size_t>(normal_of_pair[i]);
        if (3 * at >= file_normals.size() || normal_vertices_[i] >= n_vertices_) {
            Fail(file, "a face names normal " + std::to_string(at + 1) + " of vertex " +
                           std::to_string(normal_vertices_[i] + 1) + "; the file has " +
                           Counted(static_cast<std::int64_t>(file_normals.size() / 3), "normal", "normals") + " and " +
                           Counted(n_vertices_, "vertex", "vertices"));
        }
        normals_.insert(normals_.end(), file_normals.begin() + static_cast<std::ptrdiff_t>(3 * at),
                        file_normals.begin() + static_cast<std::ptrdiff_t>(3 * at + 3));
    }
}

void ObjText::Write(const std::filesystem::path& path, std::span<const double> positions,
                    std::span<const double> normals) const {
    if (positions.size() != 3 * static_cast<std::size_t>(n_vertices_) || normals.size() != normals_.size()) {
        throw InvalidInput("OBJ text to write: " + std::to_string(positions.size()) + " coordinates and " +
                           std::to_string(normals.size()) + " numbers of normals for " + std::to_string(n_vertices_) +
                           " vertices and " + std::to_string(normal_vertices_.size()) + " normals");
    }
    OutputFile file(path);
    const auto write_three = [&](const char* keyword, std::span<const double> rows, std::size_t i) {
        file << keyword << rows[3 * i] << ' ' << rows[3 * i + 1] << ' ' << rows[3 * i + 2];
    };
    std::size_t at = 0, vertex = 0;
    bool has_normals = false;
    for (const Edit& edit : edits_) {
        file << std::string_view(bytes_).substr(at, edit.begin - at);
        at = edit.end;
        if (edit.kind == Edit::Normal) continue;
        if (edit.kind == Edit::Vertex) {
            write_three("v ", positions, vertex++);
            file << edit.text << '\n';
            continue;
        }
        for (std::size_t i = 0; i < normal_vertices_.size() && !has_normals; ++i) {
            write_three("vn ", normals, i);
            file << '\n';
        }
        has_normals = true;
        std::size_t next = 0;
        for (char c : edit.text) {
            if (c == '\1') {
                file << edit.pairs[next++] + 1;
            } else {
                file << c;
            }
        }
        file << '\n';
    }
    file << std::string_view(bytes_).substr(at);
    file.Commit();
}

}  // namespace SolidSubdiv::Io
