// SPDX-License-Identifier: Apache-2.0
// Pixels: few rays where a pixel sees one smooth thing, with its light averaged over like neighbours; many at edges.
#include <solidsubdiv/kit/picture/internal/srgb.h>
#include <solidsubdiv/kit/picture/internal/studio.h>
#include <solidsubdiv/kit/picture/render.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

using Internal::Fragment;
using Internal::LightShare;
using Internal::PixelSequence;
using Internal::Studio;
using Internal::Vec3f;

/// Where every pixel is looked at first, from its middle in pixels: at the corners, and in the middle for thin lines.
constexpr std::array<std::array<float, 2>, 5> kProbes{
    {{-0.5f, -0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}, {0, 0}}};
constexpr int kCorners = 4;
constexpr float kFootprint = 1.3f;  // side of the square that a pixel's other rays fill: a little over 1 softens stairs
constexpr int kReach = 3;  // light is averaged with weights 1 2 3 4 3 2 1: all pixels of a 4 x 4 tile count alike
constexpr int kBand = 96;  // rows worked on together

/// A pixel after its rays: finished, or calm: one fragment whose light is still to be averaged.
struct Pixel {
    bool calm = false;
    Fragment fragment;  // calm: the mean
    LightShare light;   // calm
    Vec3f color;        // finished
};

using Probes = std::array<Fragment, kProbes.size()>;

Vec3f Mean(const Probes& probes, Vec3f Fragment::*field) {
    Vec3f sum{};
    for (const Fragment& f : probes) sum += f.*field;
    return (1 / static_cast<float>(probes.size())) * sum;
}

float Largest(Vec3f v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Distance of b from the tangent plane of a.
float OffPlane(const Fragment& a, const Fragment& b) { return std::abs(Dot(a.normal, b.position - a.position)); }

bool LookAlike(const Fragment& a, const Fragment& b, float pixel_size) {
    if (a.kind != b.kind || Largest(a.color - b.color) > 0.02f) return false;
    if (a.kind == Fragment::Kind::Plain) return false;  // a stroke may be hardly wider than the probes' square
    if (!a.NeedsLight() && !b.NeedsLight()) return true;
    return Dot(a.normal, b.normal) > 0.97f && OffPlane(a, b) < 0.5f * pixel_size;
}

Pixel TracePixel(const Studio& studio, const RenderOptions& options, int x, int y) {
    const float middle_x = static_cast<float>(x) + 0.5f, middle_y = static_cast<float>(y) + 0.5f;
    Probes probes;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        probes[i] = studio.Look(middle_x + kProbes[i][0], middle_y + kProbes[i][1]);
    }
    Pixel pixel;
    const float size = studio.PixelSize(probes[0]);
    pixel.calm =
        std::all_of(probes.begin() + 1, probes.end(), [&](const Fragment& f) { return LookAlike(probes[0], f, size); });
    if (pixel.calm) {
        pixel.fragment = probes[0];
        for (auto field :
             {&Fragment::color, &Fragment::position, &Fragment::origin, &Fragment::direction, &Fragment::normal}) {
            pixel.fragment.*field = Mean(probes, field);
        }
        pixel.fragment.normal = Unit(pixel.fragment.normal);
        pixel.fragment.direction = Unit(pixel.fragment.direction);
        // Rays start from the corners' own places: their mean may lie inside a bent surface.
        const int each = (options.light_rays + kCorners - 1) / kCorners;
        const PixelSequence sequence(x, y, kCorners * each);
        pixel.light = {0, 0};
        for (int i = 0; i < kCorners; ++i) {
            const LightShare share = studio.Gather(probes[static_cast<std::size_t>(i)], sequence, i * each, each);
            pixel.light.key += share.key / kCorners;
            pixel.light.sky += share.sky / kCorners;
        }
        return pixel;
    }
    const int each = options.light_rays == 0 ? 0 : std::max(1, options.light_rays / options.samples);
    const PixelSequence sequence(x, y, options.samples * each);
    for (int i = 0; i < options.samples; ++i) {
        const Internal::Pair place = Internal::EvenPoint(static_cast<unsigned>(i));
        const Fragment fragment =
            studio.Look(middle_x + kFootprint * (place.u - 0.5f), middle_y + kFootprint * (place.v - 0.5f));
        pixel.color += studio.Develop(fragment, studio.Gather(fragment, sequence, i * each, each));
    }
    pixel.color = (1 / static_cast<float>(options.samples)) * pixel.color;
    return pixel;
}

/// A stripe of the picture's pixels, with the rows above and below that averaging looks at.
struct Stripe {
    int width, first_row, n_rows;
    std::vector<Pixel> pixels;

    const Pixel* Find(int x, int y) const {
        if (x < 0 || x >= width || y < first_row || y >= first_row + n_rows) return nullptr;
        return &pixels[static_cast<std::size_t>(y - first_row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
    }
};

/// The mean light over like pixels near a calm one, nearer ones counting more.
LightShare AverageLight(const Studio& studio, const Stripe& stripe, int x, int y) {
    const Pixel& centre = *stripe.Find(x, y);
    const float size = studio.PixelSize(centre.fragment);
    LightShare sum{0, 0};
    float total = 0;
    for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const Pixel* other = stripe.Find(x + dx, y + dy);
            if (other == nullptr || !other->calm || other->fragment.kind != centre.fragment.kind) continue;
            const float alike = Dot(centre.fragment.normal, other->fragment.normal);
            if (alike < 0.9f || OffPlane(centre.fragment, other->fragment) > 2 * size) continue;
            const float weight =
                static_cast<float>((kReach + 1 - std::abs(dx)) * (kReach + 1 - std::abs(dy))) * (alike - 0.9f);
            sum.key += weight * other->light.key;
            sum.sky += weight * other->light.sky;
            total += weight;
        }
    }
    return {sum.key / total, sum.sky / total};
}

Color Finish(const Studio& studio, const Stripe& stripe, int x, int y) {
    const Pixel& pixel = *stripe.Find(x, y);
    Vec3f linear = pixel.color;
    if (pixel.calm) {
        const bool lit = pixel.fragment.NeedsLight();
        linear = studio.Develop(pixel.fragment, lit ? AverageLight(studio, stripe, x, y) : LightShare{});
    }
    return {Internal::EncodeSrgb(linear.x), Internal::EncodeSrgb(linear.y), Internal::EncodeSrgb(linear.z)};
}

void CheckRange(const char* name, int value, int low, int high) {
    if (value < low || value > high) {
        throw InvalidInput(std::string("picture: ") + name + " is " + std::to_string(value) + "; must be from " +
                           std::to_string(low) + " to " + std::to_string(high));
    }
}

}  // namespace

void RenderOptions::Validate() const {
    CheckRange("width", width, 1, 32768);
    CheckRange("height", height, 1, 32768);
    CheckRange("samples", samples, 1, 1024);
    CheckRange("light_rays", light_rays, 0, 4096);
}

Image Render(const Scene& scene, const Camera& camera, const RenderOptions& options, const Progress& progress) {
    options.Validate();
    const Studio studio(scene, camera, options);
    Image image(options.width, options.height);
    for (int top = 0; top < options.height; top += kBand) {
        Report(progress, "render", static_cast<double>(top) / options.height);
        const int bottom = std::min(options.height, top + kBand);
        // Rows beside the band are traced twice; keeping them would tie a picture's memory to its size.
        Stripe stripe{options.width, std::max(0, top - kReach), 0, {}};
        stripe.n_rows = std::min(options.height, bottom + kReach) - stripe.first_row;
        stripe.pixels.resize(static_cast<std::size_t>(stripe.n_rows) * static_cast<std::size_t>(options.width));
        Sdc::ParallelFor(stripe.n_rows, 1, [&](Offset begin, Offset end) {
            for (Offset row = begin; row < end; ++row) {
                for (int x = 0; x < options.width; ++x) {
                    stripe.pixels[static_cast<std::size_t>(row * options.width + x)] =
                        TracePixel(studio, options, x, stripe.first_row + static_cast<int>(row));
                }
            }
        });
        Sdc::ParallelFor(bottom - top, 1, [&](Offset begin, Offset end) {
            for (Offset row = begin; row < end; ++row) {
                const int y = top + static_cast<int>(row);
                for (int x = 0; x < options.width; ++x) image.Set(x, y, Finish(studio, stripe, x, y));
            }
        });
    }
    Report(progress, "render", 1);
    return image;
}

Image Render(const Scene& scene, const View& view, const RenderOptions& options, const Progress& progress) {
    options.Validate();
    return Render(scene, FitCamera(view, options.width, options.height, scene), options, progress);
}

}  // namespace SolidSubdiv::Picture
