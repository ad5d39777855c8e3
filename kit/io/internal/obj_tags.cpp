// SPDX-License-Identifier: Apache-2.0
// Reads OpenSubdiv's tags line by line.
#include <solidsubdiv/kit/io/internal/obj_tags.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include <solidsubdiv/kit/io/holes.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// Tags that OpenSubdiv knows and that change nothing here: corners' data, edits of single levels.
constexpr std::array<std::string_view, 6> kUnusedTags = {"facevaryinginterpolateboundary",
                                                         "facevaryingpropagatecorners",
                                                         "smoothtriangles",
                                                         "vertexedit",
                                                         "edgeedit",
                                                         "faceedit"};

}  // namespace

void ObjTags::NoteFace() {
    const std::int64_t row = builder_.n_rows();
    if (face_runs_.empty() || row - n_faces_ != face_runs_.back().first_row - face_runs_.back().first_face) {
        face_runs_.push_back({n_faces_, row});
    }
    ++n_faces_;
}

std::int64_t ObjTags::RowOfFace(std::int64_t face) const {
    const auto after = std::upper_bound(face_runs_.begin(), face_runs_.end(), face,
                                        [](std::int64_t f, const FaceRun& run) { return f < run.first_face; });
    const FaceRun& run = *std::prev(after);
    return run.first_row + (face - run.first_face);
}

void ObjTags::AddElement(std::span<const std::int64_t> vertices) {
    if (merging_) {
        const auto row = static_cast<std::size_t>(rows_.FindOrAdd(vertices, builder_.n_rows()));
        if (row < sharpness_.size() && sharpness_[row] > 0) return;
    } else {
        early_.push_back({{vertices.front(), vertices.back()}, vertices.size(), builder_.n_rows()});
    }
    builder_.NextRow();
    builder_.AddElement(vertices.size() == 1 ? ElementKind::Vertex : ElementKind::Edge, vertices);
}

void ObjTags::BeginMerging() {
    if (merging_) return;
    merging_ = true;
    for (const EarlyElement& e : early_) {
        rows_.FindOrAdd(std::span<const std::int64_t>(e.vertices.data(), e.n_vertices), e.row);
    }
    early_ = {};
}

void ObjTags::ReadTag(TextCursor& line) {
    const std::string_view name = line.PeekWord();
    if (line.AtComment()) line.FailExpected("the name of a tag");
    if (name == "crease") return ReadSharp(line, 2, "pairs of vertices and one sharpness, or one for each");
    if (name == "corner") return ReadSharp(line, 1, "vertices and one sharpness, or one for each");
    if (name == "hole") return ReadHoles(line);
    if (name == "interpolateboundary") return ReadBoundary(line);
    if (name == "creasemethod") return ReadCreasing(line);
    CountUnused(name);
}

ObjTags::Tag ObjTags::ReadHead(TextCursor& line) {
    Tag tag{line.Word(), {}};
    const std::string_view word = line.PeekWord();
    const char *at = word.data(), *const end = word.data() + word.size();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [last, error] = std::from_chars(at, end, tag.counts[i]);
        const bool ends_well = i < 2 ? last != end && *last == '/' : last == end;
        if (error != std::errc() || tag.counts[i] < 0 || !ends_well) {
            line.FailExpected("how many integers, numbers and words follow, as in 2/1/0");
        }
        at = last + (i < 2);
    }
    line.Word();
    // Each takes at least a blank and one byte; a single one that is missing is better named by what it should be.
    const std::int64_t most = line.remaining() / 2 + 1;
    if (*std::max_element(tag.counts.begin(), tag.counts.end()) > most) {
        line.FailHere("tag " + Quoted(tag.name) + " announces more values (" + std::string(word.substr(0, 40)) +
                      ") than its line can hold");
    }
    return tag;
}

void ObjTags::FailCounts(const TextCursor& line, const Tag& tag, const std::string& needed) {
    const auto& n = tag.counts;
    line.FailHere("tag " + Quoted(tag.name) + " needs " + needed + "; it has " + Counted(n[0], "integer", "integers") +
                  ", " + Counted(n[1], "number", "numbers") + " and " + Counted(n[2], "word", "words"));
}

void ObjTags::RequireEnd(TextCursor& line, const Tag& tag) {
    if (line.AtComment()) return;
    line.FailHere("tag " + Quoted(tag.name) + " has more values than it announces, from " + Quoted(line.PeekWord()) +
                  " on");
}

void ObjTags::ReadSharp(TextCursor& line, std::size_t n_vertices, const char* needed) {
    const Tag tag = ReadHead(line);
    const std::int64_t n_elements = tag.counts[0] / static_cast<std::int64_t>(n_vertices);
    if (n_elements == 0 || tag.counts[0] % static_cast<std::int64_t>(n_vertices) != 0 ||
        (tag.counts[1] != 1 && tag.counts[1] != n_elements) || tag.counts[2] != 0) {
        FailCounts(line, tag, needed);
    }
    const std::string label = " of tag " + Quoted(tag.name);
    const std::string vertex_label = "a vertex" + label, sharpness_label = "a sharpness" + label;
    std::vector<std::int64_t> vertices(static_cast<std::size_t>(tag.counts[0]));
    for (std::int64_t& v : vertices) {
        v = line.Integer(vertex_label);
        if (v < 0) line.FailHere("vertex " + std::to_string(v) + label + ": its vertices are counted from 0");
        if (v > std::numeric_limits<Index>::max())
            line.FailHere("vertex " + std::to_string(v) + label + " is not there");
        if (v <= largest_vertex_) continue;
        largest_vertex_ = v;
        largest_line_ = line;
    }
    std::vector<double> sharpness(static_cast<std::size_t>(tag.counts[1]));
    for (double& s : sharpness) {
        const std::string_view word = line.PeekWord();
        s = line.Real(sharpness_label);
        if (!(s >= 0) || !std::isfinite(s)) {
            line.FailHere("sharpness " + std::string(word.substr(0, 40)) + label +
                          ": it must be 0 (no crease) or greater, 10 for infinitely sharp");
        }
    }
    RequireEnd(line, tag);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_elements); ++i) {
        const auto element = std::span<const std::int64_t>(vertices).subspan(n_vertices * i, n_vertices);
        if (n_vertices == 2 && element[0] == element[1]) {
            line.FailHere("tag 'crease' has vertex " + std::to_string(element[0]) + " twice in one pair");
        }
        Sharpen(element, sharpness[sharpness.size() == 1 ? 0 : i]);
    }
}

void ObjTags::ReadHoles(TextCursor& line) {
    const Tag tag = ReadHead(line);
    if (tag.counts[0] == 0 || tag.counts[1] != 0 || tag.counts[2] != 0) FailCounts(line, tag, "faces");
    for (std::int64_t i = 0; i < tag.counts[0]; ++i) {
        const std::int64_t face = line.Integer("a face of tag 'hole'");
        if (face < 0) line.FailHere("face " + std::to_string(face) + " of tag 'hole': its faces are counted from 0");
        holes_.push_back(face);
        if (face <= largest_hole_) continue;
        largest_hole_ = face;
        hole_line_ = line;
    }
    RequireEnd(line, tag);
}

void ObjTags::ReadBoundary(TextCursor& line) {
    const Tag tag = ReadHead(line);
    if (tag.counts != std::array<std::int64_t, 3>{1, 0, 0}) FailCounts(line, tag, "one integer");
    const std::int64_t value = line.Integer("an integer of tag 'interpolateboundary'");
    if (value < 0 || value >= static_cast<std::int64_t>(kBoundaryNames.size())) {
        line.FailHere("tag 'interpolateboundary' must be 0, 1 or 2; it is " + std::to_string(value));
    }
    RequireEnd(line, tag);
    SetOption("boundary", kBoundaryNames[static_cast<std::size_t>(value)]);
}

void ObjTags::ReadCreasing(TextCursor& line) {
    const Tag tag = ReadHead(line);
    if (tag.counts != std::array<std::int64_t, 3>{0, 0, 1}) FailCounts(line, tag, "one word");
    const std::string_view word = line.PeekWord();
    const auto found =
        std::find_if(kCreasingNames.begin(), kCreasingNames.end(), [&](const auto& name) { return name.tag == word; });
    if (found == kCreasingNames.end()) line.FailExpected("'normal' or 'chaikin' for tag 'creasemethod'");
    line.Word();
    RequireEnd(line, tag);
    SetOption("creasing", found->option);
}

void ObjTags::Sharpen(std::span<const std::int64_t> vertices, double sharpness) {
    if (sharpness == 0) return;
    BeginMerging();
    const std::int64_t next = builder_.n_rows();
    const std::int64_t row = rows_.FindOrAdd(vertices, next);
    if (row == next) AddElement(vertices);
    if (static_cast<std::size_t>(row) >= sharpness_.size()) sharpness_.resize(static_cast<std::size_t>(row) + 1, 0.0);
    double& there = sharpness_[static_cast<std::size_t>(row)];
    n_repeated_ += there > 0;
    there = std::max(there, sharpness);
}

void ObjTags::SetOption(const char* name, std::string_view value) {
    // As in OpenSubdiv, the last one counts.
    std::erase_if(scheme_options_, [&](const auto& option) { return option.first == name; });
    scheme_options_.emplace_back(name, value);
}

void ObjTags::CountUnused(std::string_view name) {
    const auto known = std::find(kUnusedTags.begin(), kUnusedTags.end(), name);
    if (known == kUnusedTags.end()) {
        if (n_unknown_++ == 0) first_unknown_ = Quoted(name);
        return;
    }
    for (auto& [used, n] : unused_) {
        if (used == *known) {
            ++n;
            return;
        }
    }
    unused_.emplace_back(*known, 1);
}

void ObjTags::Finish() {
    if (largest_vertex_ >= builder_.n_vertices()) {
        largest_line_->FailHere("a tag names vertex " + std::to_string(largest_vertex_) + ", but there " +
                                (builder_.n_vertices() == 1 ? "is " : "are ") +
                                Counted(builder_.n_vertices(), "vertex", "vertices") + ", counted from 0 in tags");
    }
    if (largest_hole_ >= n_faces_) {
        hole_line_->FailHere("a tag names face " + std::to_string(largest_hole_) + ", but there " +
                             (n_faces_ == 1 ? "is " : "are ") + Counted(n_faces_, "face", "faces") +
                             ", counted from 0 in tags");
    }
    if (!holes_.empty()) {
        std::vector<double> is_hole(static_cast<std::size_t>(builder_.n_rows()), 0.0);
        for (const std::int64_t face : holes_) is_hole[static_cast<std::size_t>(RowOfFace(face))] = 1;
        builder_.AddCellData({std::string(kHole), 1, std::move(is_hole)});
    }
    if (!sharpness_.empty()) {
        sharpness_.resize(static_cast<std::size_t>(builder_.n_rows()), 0.0);
        builder_.AddCellData({"sharpness", 1, std::move(sharpness_)});
    }
    if (n_repeated_ > 0) {
        builder_.AddNote(Counted(n_repeated_, "crease or corner is", "creases or corners are") +
                         " there more than once; the largest sharpness counts");
    }
    for (const auto& [name, n] : unused_) {
        builder_.AddNote(Counted(n, "OpenSubdiv tag ", "OpenSubdiv tags ") + Quoted(name) + " not used");
    }
    if (n_unknown_ > 0) {
        builder_.AddNote(Counted(n_unknown_, "unknown tag", "unknown tags") + " ('t' lines) skipped, the first is " +
                         first_unknown_);
    }
}

}  // namespace SolidSubdiv::Io::Internal
