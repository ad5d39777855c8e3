// SPDX-License-Identifier: Apache-2.0
// Sparse rows as a Matrix Market file.
#include <solidsubdiv/apps/cli/matrix_market.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Cli {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20;
constexpr std::size_t kLongestLine = 80;

/// Text that grows without a check for each number. @pre room for them was made
class Line {
  public:
    explicit Line(std::string& text) : text_(text) {}
    template <class Number>
    void Add(Number number, char after) {
        char digits[40];
        const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
        text_.append(digits, end);
        text_ += after;
    }

  private:
    std::string& text_;
};

}  // namespace

void WriteMatrixMarket(const std::filesystem::path& path, const Far::StencilRows<double>& rows,
                       const Progress& progress) {
    std::ofstream file(path, std::ios::binary);
    std::string text = "%%MatrixMarket matrix coordinate real general\n";
    text += "% refined vertices (rows) from control vertices (columns), written by SolidSubdiv\n";
    Line line(text);
    line.Add(rows.n_rows(), ' ');
    line.Add(rows.n_sources, ' ');
    line.Add(rows.n_weights(), '\n');
    const auto flush = [&] {
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        if (!file) throw IoError(path.string() + ": can't be written; is the disk full?");
        text.clear();
    };
    text.reserve(kBuffer + kLongestLine);
    for (Index row = 0; row < rows.n_rows(); ++row) {
        const auto indices = rows.Indices(row);
        const auto weights = rows.Weights(row);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            line.Add(row + 1, ' ');
            line.Add(indices[k] + 1, ' ');
            line.Add(weights[k], '\n');
            if (text.size() < kBuffer) continue;
            flush();
            Report(progress, "write stencils", static_cast<double>(row) / rows.n_rows());
        }
    }
    flush();
    file.close();
    if (!file) throw IoError(path.string() + ": can't be written; is the disk full?");
}

}  // namespace SolidSubdiv::Cli
