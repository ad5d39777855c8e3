// SPDX-License-Identifier: Apache-2.0
// Fuzzes files of embeddings: what is read deforms, all or in part, and is the same when it is saved and read again.
//
// Half of the inputs, those whose last byte is odd, get a checksum that fits: else hardly any would be read.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/deformer.h>

#include "bytes.h"

using namespace SolidSubdiv;
using Fuzz::Require;

namespace {

/// A file of this process that goes with it; in memory where the system has a folder for that: twenty times as fast.
struct File {
    std::filesystem::path path =
        (std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path()) /
        ("solidsubdiv_fuzz_embedding_" + std::to_string(getpid()));
    ~File() {
        std::error_code error;
        std::filesystem::remove(path, error);
    }
};
const File file;

/// As docs/embedding_file.md has it.
void MakeChecksumFit(std::string& bytes) {
    bytes.resize(bytes.size() / 8 * 8 - 8);
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word;
        std::memcpy(&word, &bytes[i], 8);
        sum = (sum ^ word) * 0x100000001b3u;
    }
    bytes.append(reinterpret_cast<const char*>(&sum), 8);
}

std::string ReadFile() {
    std::ifstream stream(file.path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Weights of any size give numbers of any kind.
template <class Real>
bool IsSame(Real a, Real b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// An update after a move of the first control point gives what deforming anew gives, and names what it wrote.
template <class Real>
void CheckDeformer(const Deform::Embedding& embedding) {
    Deform::DeformerReal<Real> deformer(embedding);
    const std::vector<Index> first(embedding.n_control_points() > 0 ? 1 : 0, 0);
    const std::vector<Index> affected = deformer.Affected(first);
    for (Index point : affected) Require(point >= 0 && point < embedding.n_points());
    if (embedding.n_control_points() > 1 << 16) return;  // the caller's numbers, not the deformer's, are many then

    std::vector<Real> control(3 * static_cast<std::size_t>(embedding.n_control_points()));
    std::vector<Real> points(3 * static_cast<std::size_t>(embedding.n_points())), anew = points;
    deformer.Deform(control, points);
    if (!first.empty()) control[0] = 1;
    const auto written = deformer.Update(first, control, points);
    std::vector<Index> sorted(written.begin(), written.end());
    std::sort(sorted.begin(), sorted.end());
    Require(sorted == affected);
    Deform::DeformerReal<Real>(embedding).Deform(control, anew);
    for (std::size_t i = 0; i < points.size(); ++i) Require(IsSame(points[i], anew[i]));
}

void CheckControlRows(const Deform::Embedding& embedding) {
    std::vector<Index> points;
    while (points.size() < 8 && static_cast<Index>(points.size()) < embedding.n_points()) {
        points.push_back(static_cast<Index>(points.size()));
    }
    const auto rows = embedding.ControlRows(points);
    Require(rows.n_rows() == static_cast<Index>(points.size()) && rows.n_sources == embedding.n_control_points());
    for (Index i = 0; i < rows.n_rows(); ++i) {
        Index before = -1;
        for (Index column : rows.Indices(i)) {
            Require(column > before && column < rows.n_sources);
            before = column;
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    if (size >= 8 && data[size - 1] % 2 == 1) MakeChecksumFit(bytes);
    std::ofstream(file.path, std::ios::binary) << bytes;
    try {
        const auto embedding = Deform::Embedding::Load(file.path);
        CheckDeformer<double>(embedding);
        CheckDeformer<float>(embedding);
        CheckControlRows(embedding);
        embedding.Save(file.path);
        const std::string saved = ReadFile();  // not always `bytes`: what fills items up may be anything there
        Deform::Embedding::Load(file.path).Save(file.path);
        Require(ReadFile() == saved);
    } catch (const IoError& error) {
        Require(std::string(error.what()).find_first_of("\r\n") == std::string::npos);
    }
    return 0;
}
