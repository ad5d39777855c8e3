// SPDX-License-Identifier: Apache-2.0
// Canonical codes of small polygonal spheres and of rings.
#include <solidsubdiv/kit/analysis/internal/link.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace SolidSubdiv::Analysis::Internal {

namespace {

using Sides = std::map<std::pair<int, int>, std::array<int, 2>>;  // the two faces at each side of the link

/// Empty where a side has other than two faces.
Sides SidesOf(const std::vector<LinkFace>& link) {
    std::map<std::pair<int, int>, int> counts;
    Sides sides;
    for (std::size_t f = 0; f < link.size(); ++f) {
        const auto& corners = link[f].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto side = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
            const int n = counts[side]++;
            if (n == 2) return {};
            sides[side][static_cast<std::size_t>(n)] = static_cast<int>(f);
        }
    }
    const bool is_closed = std::all_of(counts.begin(), counts.end(), [](const auto& c) { return c.second == 2; });
    return is_closed ? sides : Sides{};
}

/// A face entered at a side: walked from `first` on, and over `second` next.
struct Step {
    int face, first, second;
};

class Walk {
  public:
    Walk(const std::vector<LinkFace>& link, const Sides& sides, int n_corners)
        : link_(link), sides_(sides), numbers_(static_cast<std::size_t>(n_corners), -1), seen_(link.size(), false) {}

    /// What is written from this start on: of each face in turn its size, the numbers of its corners in the order in
    /// which they were met, and their marks.
    std::u16string From(const Step& start) {
        std::vector<Step> steps{start};
        seen_[static_cast<std::size_t>(start.face)] = true;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const LinkFace& face = link_[static_cast<std::size_t>(steps[i].face)];
            const int n = static_cast<int>(face.corners.size());
            const auto at = [&](int k) { return static_cast<std::size_t>((k % n + n) % n); };
            const int first = Find(face, steps[i].first);
            const int sense = face.corners[at(first + 1)] == steps[i].second ? 1 : -1;
            text_.push_back(static_cast<char16_t>(n));
            for (int k = 0; k < n; ++k) {
                const std::size_t corner = at(first + sense * k);
                int& number = numbers_[static_cast<std::size_t>(face.corners[corner])];
                if (number < 0) number = n_numbers_++;
                text_.push_back(static_cast<char16_t>(number));
                text_.push_back(face.marks[corner]);
            }
            for (int k = 0; k < n; ++k) {
                const int a = face.corners[at(first + sense * k)], b = face.corners[at(first + sense * (k + 1))];
                const auto& pair = sides_.at(std::minmax(a, b));
                const int other = pair[0] == steps[i].face ? pair[1] : pair[0];
                if (seen_[static_cast<std::size_t>(other)]) continue;
                seen_[static_cast<std::size_t>(other)] = true;
                steps.push_back({other, b, a});
            }
        }
        return steps.size() == link_.size() ? text_ : std::u16string();
    }

  private:
    static int Find(const LinkFace& face, int corner) {
        return static_cast<int>(std::find(face.corners.begin(), face.corners.end(), corner) - face.corners.begin());
    }

    const std::vector<LinkFace>& link_;
    const Sides& sides_;
    std::vector<int> numbers_;
    std::vector<bool> seen_;
    int n_numbers_ = 0;
    std::u16string text_;
};

}  // namespace

std::u16string CodeOf(const std::vector<LinkFace>& link) {
    const Sides sides = SidesOf(link);
    if (sides.empty()) return {};
    int n_corners = 0;
    std::size_t rarest = 0;
    std::map<std::pair<std::size_t, std::vector<std::uint8_t>>, std::size_t> kinds;  // by size and sorted marks
    const auto kind_of = [](const LinkFace& face) {
        auto marks = face.marks;
        std::sort(marks.begin(), marks.end());
        return std::make_pair(face.corners.size(), marks);
    };
    for (const LinkFace& face : link) {
        ++kinds[kind_of(face)];
        for (int c : face.corners) n_corners = std::max(n_corners, c + 1);
    }
    for (const auto& kind : kinds) rarest = rarest == 0 ? kind.second : std::min(rarest, kind.second);
    // Walks from faces of the rarest kind are enough: which kind that is does not depend on numbers.
    const auto start_kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.second == rarest; })->first;
    std::u16string least;
    for (std::size_t f = 0; f < link.size(); ++f) {
        if (kind_of(link[f]) != start_kind) continue;
        const auto& corners = link[f].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const int a = corners[k], b = corners[(k + 1) % corners.size()];
            for (const Step& start : {Step{static_cast<int>(f), a, b}, Step{static_cast<int>(f), b, a}}) {
                std::u16string text = Walk(link, sides, n_corners).From(start);
                if (text.empty()) return {};
                if (least.empty() || text < least) least = std::move(text);
            }
        }
    }
    return least;
}

std::u16string CodeOf(std::vector<RingCell> cells, const RingMarks& marks) {
    if (cells.empty()) return {};
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {  // one after another
        std::size_t next = i + 1;
        while (next < cells.size() && cells[next].from != cells[i].to && cells[next].to != cells[i].to) ++next;
        if (next == cells.size()) return {};
        std::swap(cells[i + 1], cells[next]);
        RingCell& cell = cells[i + 1];
        if (cell.from != cells[i].to) cell = {cell.to, cell.from, marks.backwards(cell.mark)};
    }
    if (cells.back().to != cells.front().from) return {};
    std::u16string text;
    for (const RingCell& cell : cells) text.push_back(cell.mark);
    std::u16string least;
    for (int view = 0; view < 4; ++view) {
        std::u16string seen = text;
        if (view % 2 == 1) {
            std::reverse(seen.begin(), seen.end());
            std::transform(seen.begin(), seen.end(), seen.begin(), marks.backwards);
        }
        if (view >= 2) std::transform(seen.begin(), seen.end(), seen.begin(), marks.upside_down);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            std::rotate(seen.begin(), seen.begin() + 1, seen.end());
            if (least.empty() || seen < least) least = seen;
        }
    }
    return least;
}

}  // namespace SolidSubdiv::Analysis::Internal
