// SPDX-License-Identifier: Apache-2.0
// Embeddings in files: what is written is read, what is damaged is refused.
#include <solidsubdiv/apps/deform/deformer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "apps/deform/deform_testing.h"
#include "temporary_folder.h"

namespace SolidSubdiv::Deform {
namespace {

class EmbeddingFiles : public testing::Test {
  protected:
    std::string Read() const {
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void Write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
    /// What Load says of these bytes.
    std::string Message(const std::string& bytes) const {
        Write(bytes);
        try {
            Embedding::Load(path_);
        } catch (const IoError& error) {
            return error.what();
        }
        return "no error";
    }

    const TemporaryFolder folder_;
    const std::filesystem::path path_ = folder_ / "embedding";
};

/// The bytes with a checksum that fits: as docs/embedding_file.md says.
std::string WithChecksum(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        std::uint64_t word;
        std::memcpy(&word, &bytes[i], 8);
        sum = (sum ^ word) * 0x100000001b3u;
    }
    bytes.append(reinterpret_cast<const char*>(&sum), 8);
    return bytes;
}

TEST_F(EmbeddingFiles, WhatIsRead_DeformsToTheSameBits) {
    for (const LatticeCase& c : LatticeCases()) {
        const auto points = PointsAround(c.lattice, 50, 1);
        for (bool limit : {false, true}) {
            if (limit && c.name.find("block") == std::string::npos) continue;
            const auto e =
                Embedding::Create(c.lattice.View(), c.lattice.positions, points,
                                  {.scheme = c.scheme, .levels = 1, .limit = limit, .notes = {{"by", "me"}}});
            e.Save(path_);
            const Embedding read = Embedding::Load(path_);
            EXPECT_EQ(read.settings(), e.settings());
            EXPECT_EQ(read.outside().size(), e.outside().size());
            const auto control = Moved(c.lattice.positions, 0.2, 2);
            std::vector<double> a(points.size()), b(points.size());
            Deformer(e).Deform(control, a);
            Deformer(read).Deform(control, b);
            EXPECT_EQ(a, b) << c.name;
        }
    }
}

TEST_F(EmbeddingFiles, OfOtherKindsAndDamagedOnes_AreRefused) {
    const ControlLattice lattice = LatticeOf(TestShapes::MixedCells());
    Embedding::Create(lattice.View(), lattice.positions, PointsAround(lattice, 20, 1), {.levels = 1}).Save(path_);
    const std::string good = Read();
    using testing::HasSubstr;
    EXPECT_EQ(Message(good), "no error");
    EXPECT_THAT(Message(""), HasSubstr("is no embedding"));
    EXPECT_THAT(Message("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("is no embedding"));
    std::string version = good;
    version[8] = 2;
    EXPECT_THAT(Message(version), HasSubstr("version 2"));
    for (std::size_t i = 16; i < good.size(); i += 97) {
        std::string damaged = good;
        damaged[i] = static_cast<char>(damaged[i] ^ 16);
        EXPECT_THAT(Message(damaged), HasSubstr("checksum")) << i;
        EXPECT_THAT(Message(good.substr(0, i)), HasSubstr(path_.string() + ": ")) << i;
    }
    std::filesystem::remove(path_);
    EXPECT_THROW(Embedding::Load(path_), IoError);
    EXPECT_THROW(Embedding::Load(testing::TempDir()), IoError);
}

/// Any word may be wrong though the checksum is right: what comes back deforms without reading out of bounds.
TEST_F(EmbeddingFiles, OfWrongWords_AreReadOrRefused) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(2));
    Embedding::Create(lattice.View(), lattice.positions, PointsAround(lattice, 8, 1), {.levels = 1}).Save(path_);
    const std::string good = Read();
    TestShapes::Random random(1);
    int n_refused = 0, n_read = 0;
    for (std::size_t i = 16; i + 16 <= good.size(); i += 8) {
        std::string wrong = good;
        const std::uint64_t word = i % 3 == 0 ? random.Next() : i % 3 == 1 ? random.Next() % 64 : ~std::uint64_t{0};
        std::memcpy(&wrong[i], &word, 8);
        Write(WithChecksum(wrong));
        try {
            const Embedding read = Embedding::Load(path_);
            std::vector<double> points(3 * static_cast<std::size_t>(read.n_points()));
            std::vector<double> control(3 * static_cast<std::size_t>(read.n_control_points()));
            Deformer(read).Deform(control, points);
            ++n_read;
        } catch (const IoError&) {
            ++n_refused;
        }
    }
    EXPECT_GT(n_refused, 10);
    EXPECT_GT(n_read, 10);
}

TEST_F(EmbeddingFiles, ThatCantBeWritten_LeaveNothing) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(1));
    const auto e = Embedding::Create(lattice.View(), lattice.positions, {}, {});
    EXPECT_THROW(e.Save("/nowhere/at/all"), IoError);
    std::filesystem::create_directory(path_);
    EXPECT_THROW(e.Save(path_), IoError);
    EXPECT_FALSE(std::filesystem::exists(path_.string() + ".part"));
}

}  // namespace
}  // namespace SolidSubdiv::Deform
