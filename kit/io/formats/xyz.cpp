// SPDX-License-Identifier: Apache-2.0
// Reads points as lines of text (.xyz, .pts, .txt).
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <solidsubdiv/kit/io/internal/point_readers.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

class XyzReader {
  public:
    XyzReader(std::string_view bytes, const std::string& file) : text_(bytes, file) {}

    Geometry::PointCloud Read() {
        TextCursor line = text_;
        while (text_.NextLine(line)) {
            if (!line.AtComment()) ReadLine(line);
        }
        if (n_announced_ && *n_announced_ != cloud_.n_points()) {
            Fail(text_.file(), std::to_string(*n_announced_) + " points are announced, " +
                                   std::to_string(cloud_.n_points()) + " are there; is the file complete?");
        }
        if (n_columns_ == 4 || n_columns_ == 7) {
            cloud_.notes.push_back("columns behind the first three (intensities, colours) are left out");
        }
        // Exporters write colours where others write normals: whole numbers, some of them beyond any unit vector.
        const std::vector<double>& last = cloud_.normals;
        const bool are_bytes =
            std::all_of(last.begin(), last.end(), [](double x) { return x >= 0 && x <= 255 && x == std::floor(x); });
        if (are_bytes && std::any_of(last.begin(), last.end(), [](double x) { return x > 1; })) {
            cloud_.normals.clear();
            cloud_.notes.push_back("columns 4 to 6 are integers from 0 to 255: colours, which are left out");
        }
        return std::move(cloud_);
    }

  private:
    void ReadLine(TextCursor& line) {
        if (line.PeekWord() == "p") line.Word();
        row_.clear();
        while (!line.AtComment()) {
            row_.push_back(line.Real("a coordinate"));
            if (!std::isfinite(row_.back())) line.FailHere("a coordinate is not a finite number; remove the line");
        }
        const bool is_first = n_columns_ == 0;
        if (is_first && row_.size() == 1 && !n_announced_) {
            const bool is_count = row_[0] >= 0 && row_[0] < 1e15 && row_[0] == std::floor(row_[0]);
            if (!is_count) line.FailHere("a single number must be the number of points");
            n_announced_ = static_cast<Offset>(row_[0]);
            return;
        }
        if (is_first) n_columns_ = row_.size();
        if (n_columns_ != 3 && n_columns_ != 4 && n_columns_ != 6 && n_columns_ != 7) {
            line.FailHere(Counted(static_cast<std::int64_t>(n_columns_), "number", "numbers") +
                          "; a point needs x y z, or x y z nx ny nz");
        }
        if (row_.size() != n_columns_) {
            line.FailHere(Counted(static_cast<std::int64_t>(row_.size()), "number", "numbers") + ", but " +
                          std::to_string(n_columns_) + " in the lines before");
        }
        cloud_.positions.insert(cloud_.positions.end(), row_.begin(), row_.begin() + 3);
        if (n_columns_ == 6) cloud_.normals.insert(cloud_.normals.end(), row_.begin() + 3, row_.end());
    }

    TextCursor text_;
    Geometry::PointCloud cloud_;
    std::vector<double> row_;
    std::size_t n_columns_ = 0;
    std::optional<Offset> n_announced_;
};

}  // namespace

Geometry::PointCloud ParseXyz(std::string_view bytes, const std::string& file) { return XyzReader(bytes, file).Read(); }

}  // namespace SolidSubdiv::Io::Internal
