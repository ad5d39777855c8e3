// SPDX-License-Identifier: Apache-2.0
// One soft key light with shadows, a fill light without, a sky whose light is blocked by what is near. See
// internal/studio.h.
#include <solidsubdiv/kit/picture/internal/srgb.h>
#include <solidsubdiv/kit/picture/internal/studio.h>

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Picture::Internal {
namespace {

// Strengths of the lights, chosen by eye: a white surface that faces the key light is just below white.
constexpr float kKey = 0.74f, kFill = 0.15f, kSky = 0.40f, kBounce = 0.22f;
constexpr float kHighlight = 0.30f, kHighlightPower = 50.f;
constexpr float kKeySize = 0.14f;  // radius of the key light's disc at distance 1: how soft shadows are
constexpr float kSkyReach = 0.7f;  // what is farther, in scene radii, does not block the sky
constexpr float kGroundKey = 0.36f, kGroundSky = 0.45f;  // how dark shadows on the ground are
constexpr float kFadeStart = 1.0f, kFadeEnd = 2.4f;      // scene radii from the centre
constexpr float kFadeEdge = 0.12f;                       // of the picture's size

Vec3f ToVec(const std::array<double, 3>& a) { return static_cast<Vec3f>(Vec3d{a[0], a[1], a[2]}); }
Vec3f Decode(Color c) { return {DecodeSrgb(c.r), DecodeSrgb(c.g), DecodeSrgb(c.b)}; }

/// Bright light bends towards 1 instead of being cut off there.
float Shoulder(float x) {
    constexpr float start = 0.7f, room = 1 - start;
    return x <= start ? x : start + room * (1 - std::exp(-(x - start) / room));
}

/// From 0 to 1 without corners.
float Smooth(float x) { return x * x * (3 - 2 * x); }

constexpr float kStripeEdge = 0.25f;  // how soft stripes end, 1: like a sine
constexpr float kStripeDark = 0.12f;  // share of the colour that is left

/// What a mirror with this normal would show of `n` dark tubes that lie around the scene, all along `right`: 0 to 1.
float StripeBrightness(int n, Vec3f normal, Vec3f direction, Vec3f right, Vec3f up) {
    const Vec3f mirrored = direction - (2 * Dot(direction, normal)) * normal;
    const float angle = std::atan2(Dot(mirrored, up), Dot(mirrored, Cross(right, up)));
    const float wave = std::cos(static_cast<float>(n) * angle) / kStripeEdge;
    return kStripeDark + (1 - kStripeDark) * Smooth(std::clamp(0.5f + 0.5f * wave, 0.f, 1.f));
}

}  // namespace

Studio::Studio(const Scene& scene, const Camera& camera, const RenderOptions& options)
    : options_(options), traced_(scene.data(), camera, options.width) {
    eye_ = traced_.ToScaled({camera.position[0], camera.position[1], camera.position[2]});
    right_ = ToVec(camera.right);
    up_ = ToVec(camera.up);
    forward_ = ToVec(camera.forward);
    sky_ = ToVec(camera.world_up);
    half_width_ = static_cast<float>(camera.half_width);
    half_height_ = static_cast<float>(camera.half_height);
    // The lights move with the camera around the vertical, so that every side of a shape is lit alike.
    const Vec3f to_viewer = Cross(right_, sky_);
    key_ = Unit(-0.62f * right_ + 0.95f * sky_ + 0.70f * to_viewer);
    fill_ = Unit(0.85f * right_ + 0.10f * sky_ + 0.55f * to_viewer);
    if (options.ground_shadow && !scene.IsEmpty()) {
        ground_ = traced_.LowestPoint(sky_) - 1e-3f;
        has_ground_ = Dot(eye_, sky_) > ground_;
    }
}

Fragment Studio::Look(float x, float y) const {
    const float across = x / static_cast<float>(options_.width), down = y / static_cast<float>(options_.height);
    Fragment fragment;
    fragment.direction =
        Unit(forward_ + ((2 * across - 1) * half_width_) * right_ + ((1 - 2 * down) * half_height_) * up_);
    Hit hit;
    if (traced_.Intersect(eye_, fragment.direction, hit)) {
        fragment.kind = hit.shaded ? Fragment::Kind::Lit : Fragment::Kind::Plain;
        fragment.color = Decode(hit.color);
        fragment.position = hit.position;
        fragment.origin = hit.origin;
        fragment.normal = hit.normal;
        fragment.gloss = hit.gloss;
        if (hit.stripes > 0) {
            fragment.color =
                StripeBrightness(hit.stripes, hit.normal, fragment.direction, right_, up_) * fragment.color;
        }
        return fragment;
    }
    const float mix = std::clamp(down, 0.f, 1.f);
    fragment.color = (1 - mix) * Decode(options_.background_top) + mix * Decode(options_.background_bottom);
    const float descent = Dot(fragment.direction, sky_);
    if (has_ground_ && descent < 0) {
        fragment.kind = Fragment::Kind::Ground;
        fragment.position = fragment.origin = eye_ + ((ground_ - Dot(eye_, sky_)) / descent) * fragment.direction;
        fragment.normal = sky_;
        // Shadows fade out away from the shape, so that no horizon is seen.
        const float distance = Length(fragment.position - Dot(fragment.position, sky_) * sky_);
        const float fade = std::clamp((kFadeEnd - distance) / (kFadeEnd - kFadeStart), 0.f, 1.f);
        // Nor does a shadow end at the picture's edge.
        const float to_edge = std::min({across, 1 - across, down, 1 - down});
        fragment.fade = Smooth(fade) * Smooth(std::clamp(to_edge / kFadeEdge, 0.f, 1.f));
    }
    return fragment;
}

LightShare Studio::Gather(const Fragment& fragment, const PixelSequence& sequence, int first, int n_rays) const {
    if (!fragment.NeedsLight() || n_rays == 0) return {};
    const Frame<float> around_key(key_), around_normal(fragment.normal);
    int key = 0, sky = 0;
    for (int i = first; i < first + n_rays; ++i) {
        const auto k = OnDisc(sequence.Get(0, i)), s = OnDisc(sequence.Get(1, i));
        const Vec3f to_key = Unit(around_key.ToWorld({kKeySize * k.u, kKeySize * k.v, 1}));
        key += traced_.IsOccluded(fragment.origin, to_key, HUGE_VALF) ? 0 : 1;
        // Up from the disc to the half sphere: as many rays as the cosine law asks for.
        const float height = std::sqrt(std::max(0.f, 1 - s.u * s.u - s.v * s.v));
        sky += traced_.IsOccluded(fragment.origin, around_normal.ToWorld({s.u, s.v, height}), kSkyReach) ? 0 : 1;
    }
    return {static_cast<float>(key) / static_cast<float>(n_rays), static_cast<float>(sky) / static_cast<float>(n_rays)};
}

Vec3f Studio::Develop(const Fragment& fragment, LightShare light) const {
    if (fragment.kind == Fragment::Kind::Ground) {
        return (1 - fragment.fade * (kGroundKey * (1 - light.key) + kGroundSky * (1 - light.sky))) * fragment.color;
    }
    if (fragment.kind != Fragment::Kind::Lit) return fragment.color;

    const Vec3f& normal = fragment.normal;
    const float upward = 0.5f + 0.5f * Dot(normal, sky_), towards_key = std::max(0.f, Dot(normal, key_));
    const float brightness = light.sky * (kBounce + (kSky - kBounce) * upward) +
                             kFill * std::max(0.f, Dot(normal, fill_)) + kKey * light.key * towards_key;
    float highlight = 0;
    if (towards_key > 0) {
        const float half = std::max(0.f, Dot(normal, Unit(key_ - fragment.direction)));
        highlight = kHighlight * fragment.gloss * light.key * std::pow(half, kHighlightPower);
    }
    const Vec3f linear = brightness * fragment.color + Vec3f{highlight, highlight, highlight};
    return {Shoulder(linear.x), Shoulder(linear.y), Shoulder(linear.z)};
}

float Studio::PixelSize(const Fragment& fragment) const {
    return 2 * half_width_ / static_cast<float>(options_.width) * Dot(fragment.position - eye_, forward_);
}

}  // namespace SolidSubdiv::Picture::Internal
