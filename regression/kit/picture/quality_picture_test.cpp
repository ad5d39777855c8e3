// SPDX-License-Identifier: Apache-2.0
// The picture of quality: faces know their cells, and bad cells are red.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/quality_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include "kit/picture/solid_testing.h"

namespace SolidSubdiv::Picture {
namespace {

TEST(SolidFacesTest, TellTheCellBehindEachTriangle) {
    const Io::Mesh mesh = OneOfEach();  // tet 0, oct 1, hex 2, wedge 3, pyramid 4 in the order of cell data
    const SolidFaces skin = SolidBoundary(mesh);
    ASSERT_EQ(skin.cells.size(), skin.kinds.size());
    constexpr CellKind kinds[] = {CellKind::Tet, CellKind::Oct, CellKind::Hex, CellKind::Wedge, CellKind::Pyramid};
    for (std::size_t t = 0; t < skin.cells.size(); ++t) EXPECT_EQ(kinds[skin.cells[t]], skin.kinds[t]);
}

/// Pixels that are clearly red.
int RedPixels(const Image& image) {
    int n = 0;
    for (std::size_t i = 0; i + 2 < image.bytes().size(); i += 3) {
        const auto* p = &image.bytes()[i];
        n += p[0] > 120 && p[1] < 60 && p[2] < 80;
    }
    return n;
}

TEST(QualityPictureTest, BadCellsAreRedAndGoodOnesAreNot) {
    const Io::Mesh mesh = OneOfEach();
    const QualityPictureOptions small{.render = {.width = 160, .height = 120, .samples = 4, .light_rays = 0}};
    const std::vector<double> good{0.9, 0.8, 1, 0.5, 0.3}, bad{0.9, 0.8, -0.1, 0.5, 0.3};
    EXPECT_EQ(RedPixels(QualityPicture(mesh, good, small)), 0);
    EXPECT_GT(RedPixels(QualityPicture(mesh, bad, small)), 100);
}

TEST(QualityPictureTest, AnotherNumberOfQualitiesIsRefused) {
    EXPECT_THROW(QualityPicture(OneOfEach(), std::vector<double>(4, 1.0)), InvalidInput);
    EXPECT_THROW(QualityPicture(Io::Mesh(), {}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
