// SPDX-License-Identifier: Apache-2.0
// Text and panels.
#include "kit/picture/picture_testing.h"

#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/sdc/errors.h>

#include <set>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

Image Written(const std::string& text, const TextStyle& style = {.size = 20, .color = kBlack}) {
    Image image(400, 60);
    DrawText(image, 20, 40, text, style);
    return image;
}

TEST(TextTest, EveryPrintableLetterLooksDifferent) {
    std::set<std::string> looks;
    for (char c = '!'; c <= '~'; ++c) {
        const Image image = Written(std::string(1, c));
        EXPECT_GT(Darkness(image), 4) << c;
        looks.insert(std::string(image.bytes().begin(), image.bytes().end()));
    }
    EXPECT_EQ(looks.size(), static_cast<std::size_t>('~' - '!' + 1));
    EXPECT_EQ(Darkness(Written(" ")), 0);
}

TEST(TextTest, TextStaysWithinItsWidth) {
    const TextStyle style{.size = 20, .color = kBlack};
    const std::string text = "level 3: 578,432 cells";
    const double end = 20 + TextWidth(text, style);
    const Image image = Written(text, style);
    int first = 400, last = 0, top = 60, bottom = 0;
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 400; ++x) {
            if (image.At(x, y).g > 0.5f) continue;
            first = std::min(first, x), last = std::max(last, x), top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    const double stroke = 0.5 * style.weight * style.size + 0.5;
    EXPECT_NEAR(first, 20, stroke + 0.5);
    EXPECT_NEAR(last + 1, end, stroke + 0.5);
    EXPECT_NEAR(top, 20, stroke + 0.5);  // capitals and l are as high as the size, on the line y = 40
    EXPECT_GE(bottom, 40);
    EXPECT_NEAR(TextWidth(text, {.size = 40}), 2 * TextWidth(text, {.size = 20}), 1e-9);
    EXPECT_EQ(TextWidth(""), 0);
}

TEST(TextTest, OtherCharactersAreOneBoxEach) {
    EXPECT_EQ(Written("\xc3\xa9"), Written("\x01"));      // e with an accent: two bytes
    EXPECT_EQ(Written("\xe2\x86\x92"), Written("\x01"));  // an arrow: three
    EXPECT_EQ(TextWidth("\xc3\xa9\xc3\xa9"), TextWidth("\x01\x01"));
}

TEST(TextTest, TextMayRunOutOfTheImageAndStylesOutOfRangeAreRefused) {
    Image image(10, 10);
    DrawText(image, -30, 8, "a long text over all borders", {.size = 30, .color = kBlack});
    EXPECT_GT(Darkness(image), 0);
    EXPECT_THROW(TextWidth("a", {.size = 3}), InvalidInput);
    EXPECT_THROW(DrawText(image, 0, 0, "a", {.weight = NAN}), InvalidInput);
}

TEST(PanelsTest, PanelsStandInRowsWithoutOverlap) {
    const Color colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<Panel> panels;
    for (Color c : colors) panels.push_back({.image = Image(40, 30, c)});
    const Image row = Arrange(panels, {.gap = 5});
    EXPECT_EQ(row.width(), 3 * 40 + 4 * 5);
    EXPECT_EQ(row.height(), 30 + 2 * 5);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(row.At(5 + 45 * i, 5), colors[i]);
        EXPECT_EQ(row.At(44 + 45 * i, 34), colors[i]);
        EXPECT_EQ(row.At(45 + 45 * i, 20), (Color{1, 1, 1}));
    }
    const Image grid = Arrange(panels, {.columns = 2, .gap = 5});
    EXPECT_EQ(grid.width(), 2 * 40 + 3 * 5);
    EXPECT_EQ(grid.height(), 2 * 30 + 3 * 5);
    EXPECT_EQ(grid.At(25, 55), colors[2]);
    EXPECT_EQ(grid.At(70, 55), (Color{1, 1, 1}));
}

TEST(PanelsTest, CaptionsAndColourBarsStandUnderTheirPanel) {
    const std::vector<Panel> panels = {{.image = Image(100, 50), .caption = "one", .color_bar = {}},
                                       {.image = Image(100, 50), .caption = "", .color_bar = ColorBar{.title = "t"}}};
    const TextStyle style{.size = 10, .color = kBlack};
    const Image image = Arrange(panels, {.gap = 0, .caption = style});
    ASSERT_EQ(image.height(), 50 + 22 + 34);
    double caption = 0, bar = 0;
    for (int y = 50; y < image.height(); ++y) {
        for (int x = 0; x < 200; ++x) {
            const double ink = 1 - image.At(x, y).g;
            (y < 72 ? caption : bar) += ink;
            if (ink > 0.2) {
                EXPECT_EQ(x < 100, y < 72);
            }
        }
    }
    EXPECT_GT(caption, 20);
    EXPECT_GT(bar, 200);
    EXPECT_NEAR(image.At(120, 75).b, Lookup(ColorMap::Sequential, 0).b, 1 / 255.f);
}

TEST(PanelsTest, RowsTakeNoRoomForWhatTheyLack) {
    const std::vector<Panel> panels = {{.image = Image(10, 10)}, {.image = Image(10, 10), .caption = "a"}};
    const TextStyle style{.size = 10};
    EXPECT_EQ(Arrange(panels, {.columns = 1, .gap = 0, .caption = style}).height(), 10 + 10 + 22);
}

TEST(PanelsTest, AllPanelsAreOnOneScale) {
    const Triangles large = MakeSphere(4), small = MakeSphere(4, 0.5);
    const Material black{.color = kBlack, .gloss = 0};
    Scene a, b;
    a.Add(Surface{.positions = large.positions, .triangles = large.triangles, .material = black});
    b.Add(Surface{.positions = small.positions, .triangles = small.triangles, .material = black});
    const ScenePanel panels[] = {{&a}, {&b}};
    const Image image =
        RenderPanels(panels, {.field_of_view = 5}, {.width = 150, .height = 150, .ground_shadow = false}, {.gap = 0});
    ASSERT_EQ(image.width(), 300);
    Image left(150, 150), right(150, 150);
    left.Paste(image, 0, 0);
    right.Paste(image, -150, 0);
    // A quarter of the area, but for the perspective: from 24 radii away the nearer silhouette is larger by 1e-3.
    EXPECT_NEAR(Darkness(right) / Darkness(left), 0.25, 0.003);
}

TEST(PanelsTest, NothingToArrangeIsRefused) {
    EXPECT_THROW(Arrange({}), InvalidInput);
    const ScenePanel empty[] = {{}};
    EXPECT_THROW(RenderPanels(empty, View{}), InvalidInput);
    const std::vector<Panel> one = {{.image = Image(5, 5)}};
    EXPECT_THROW(Arrange(one, {.columns = -1}), InvalidInput);
    EXPECT_THROW(Arrange(one, {.gap = -1}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
