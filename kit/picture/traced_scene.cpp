// SPDX-License-Identifier: Apache-2.0
// Embree behind a small door; see internal/traced_scene.h.
#include <embree3/rtcore.h>
#include <solidsubdiv/kit/picture/internal/corner_normals.h>
#include <solidsubdiv/kit/picture/internal/traced_scene.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace SolidSubdiv::Picture::Internal {
namespace {

constexpr float kNudge = 2e-4f;  ///< off the surface, in scene radii: 1000 times the rounding of a float coordinate

Vec3d ToVec(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

Color MapColor(const SurfaceData& surface, const Index* v, float u, float w) {
    const auto value = [&](int i) { return surface.values[static_cast<std::size_t>(v[i])]; };
    return Lookup(surface.map, (1 - u - w) * value(0) + u * value(1) + w * value(2));
}

/// A geometry of an Embree scene, and where it came from.
struct Part {
    const SurfaceData* surface = nullptr;
    std::vector<Vec3f> corner_normals;  ///< of smooth surfaces
    Color color;                        ///< of lines and points
    bool shaded = true;
};

}  // namespace

struct TracedScene::Impl {
    RTCDevice device = nullptr;
    /// What casts shadows, and what is only drawn with a pen: two scenes, so that shadow rays never meet the second.
    struct Layer {
        RTCScene scene = nullptr;
        std::vector<Part> parts;
    };
    Layer solid, pen;

    Impl() {
        // Embree's option "threads=1" would hold every loop of the process to one thread while the device lives.
        device = rtcNewDevice(nullptr);
        if (device == nullptr)
            throw Error("Embree could not be started (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
        for (Layer* layer : {&solid, &pen}) {
            layer->scene = rtcNewScene(device);
            rtcSetSceneFlags(layer->scene, RTC_SCENE_FLAG_ROBUST);  // no light through the joints of triangles
        }
    }
    ~Impl() {
        for (Layer* layer : {&solid, &pen}) rtcReleaseScene(layer->scene);
        rtcReleaseDevice(device);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    template <class Element>
    Element* NewBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) const {
        void* data = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), count);
        if (data == nullptr) throw Error("Embree has no memory for " + std::to_string(count) + " elements");
        return static_cast<Element*>(data);
    }
    void Attach(Layer& layer, RTCGeometry geometry, Part part) const {
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(layer.scene, geometry, static_cast<unsigned>(layer.parts.size()));
        rtcReleaseGeometry(geometry);
        layer.parts.push_back(std::move(part));
    }
    void Commit() const {
        // One thread builds (Embree's builder runs on the same oneTBB), so that the tree, and with it which of two
        // triangles a ray through their edge meets, is the same for any number of threads.
        const Sdc::ThreadLimit one_thread(1);
        for (const Layer* layer : {&solid, &pen}) rtcCommitScene(layer->scene);
        const RTCError error = rtcGetDeviceError(device);
        if (error != RTC_ERROR_NONE)
            throw Error("Embree could not take the scene (error " + std::to_string(error) + ")");
    }
};

TracedScene::TracedScene(const SceneData& scene, const Camera& camera, int width_in_pixels)
    : scene_(scene), impl_(std::make_unique<Impl>()) {
    Vec3d low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -low;
    scene.ForEachUsedPoint([&](const Vec3d& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    });
    if (low.x > high.x) low = high = {};
    centre_ = 0.5 * (low + high);
    const double radius = 0.5 * Length(high - low);
    scale_ = 1 / (radius > 0 ? radius : 1);

    pixel_ = static_cast<float>(2 * camera.half_width / width_in_pixels);
    const Vec3d eye = ToVec(camera.position), forward = ToVec(camera.forward);
    struct Ball {
        float x, y, z, radius;
    };
    // Half of `pixels` pixels at the point's distance from the camera.
    const auto ball = [&](const Vec3d& p, double pixels) {
        const double distance = std::max(1e-6 / scale_, Dot(p - eye, forward));
        const Vec3f scaled = ToScaled(p);
        return Ball{scaled.x, scaled.y, scaled.z,
                    static_cast<float>(scale_ * pixels * camera.half_width / width_in_pixels * distance)};
    };

    for (const SurfaceData& surface : scene.surfaces) {
        const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        if (!surface.triangles.empty()) {
            auto* points =
                impl_->NewBuffer<Vec3f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, surface.positions.size());
            for (const Vec3d& p : surface.positions) *points++ = ToScaled(p);
            auto* indices = impl_->NewBuffer<unsigned[3]>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                                          surface.triangles.size() / 3);
            std::copy(surface.triangles.begin(), surface.triangles.end(), &indices[0][0]);
        }
        Part part{.surface = &surface, .corner_normals = {}, .color = {}};
        if (surface.material.smooth) {
            part.corner_normals = CornerNormals(surface.positions, surface.triangles, surface.material.crease_angle);
        }
        impl_->Attach(impl_->solid, geometry, std::move(part));
    }
    for (const LinesData& lines : scene.lines) {
        const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
        if (!lines.edges.empty()) {
            auto* ends =
                impl_->NewBuffer<Ball>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, lines.edges.size());
            for (Index v : lines.edges) *ends++ = ball(lines.positions[static_cast<std::size_t>(v)], lines.width);
            auto* first =
                impl_->NewBuffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, lines.edges.size() / 2);
            for (unsigned e = 0; e < lines.edges.size() / 2; ++e) first[e] = 2 * e;
        }
        impl_->Attach(lines.shaded ? impl_->solid : impl_->pen, geometry,
                      {.surface = nullptr, .corner_normals = {}, .color = lines.color, .shaded = lines.shaded});
    }
    for (const PointsData& points : scene.points) {
        const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        if (!points.positions.empty()) {
            auto* balls =
                impl_->NewBuffer<Ball>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, points.positions.size());
            for (const Vec3d& p : points.positions) *balls++ = ball(p, points.diameter);
        }
        impl_->Attach(points.shaded ? impl_->solid : impl_->pen, geometry,
                      {.surface = nullptr, .corner_normals = {}, .color = points.color, .shaded = points.shaded});
    }
    impl_->Commit();
}

TracedScene::~TracedScene() = default;

float TracedScene::LowestPoint(Vec3f up) const {
    float lowest = HUGE_VALF;
    scene_.ForEachUsedPoint([&](const Vec3d& p) { lowest = std::min(lowest, Dot(ToScaled(p), up)); });
    return lowest;
}

bool TracedScene::Intersect(Vec3f origin, Vec3f direction, Hit& hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = {.org_x = origin.x,
                 .org_y = origin.y,
                 .org_z = origin.z,
                 .tnear = 0,
                 .dir_x = direction.x,
                 .dir_y = direction.y,
                 .dir_z = direction.z,
                 .time = 0,
                 .tfar = HUGE_VALF,
                 .mask = ~0u,
                 .id = 0,
                 .flags = 0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->solid.scene, &context, &query);
    const bool found_solid = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    // A stroke along an edge lies half in the solid; in a valley its sides must not drown.
    const float stroke_lead = 2 * pixel_ * query.ray.tfar;
    RTCRayHit stroke = query;
    stroke.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    stroke.ray.tfar = found_solid ? query.ray.tfar + stroke_lead : HUGE_VALF;
    rtcIntersect1(impl_->pen.scene, &context, &stroke);
    const bool by_pen = stroke.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    if (!by_pen && !found_solid) return false;
    if (by_pen) query = stroke;
    const Part& part = (by_pen ? impl_->pen : impl_->solid).parts[query.hit.geomID];

    hit.distance = query.ray.tfar;
    hit.position = origin + hit.distance * direction;
    hit.facing = Unit(Vec3f{query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
    if (Dot(hit.facing, direction) > 0) hit.facing = -hit.facing;
    hit.normal = hit.facing;
    hit.color = part.color;
    hit.gloss = 0.15f;
    hit.stripes = 0;
    hit.shaded = part.shaded;
    if (part.surface != nullptr) {
        const SurfaceData& surface = *part.surface;
        const std::size_t triangle = query.hit.primID;
        const Index* v = &surface.triangles[3 * triangle];
        const float u = query.hit.u, w = query.hit.v;
        hit.gloss = static_cast<float>(surface.material.gloss);
        hit.stripes = surface.material.stripes;
        hit.color = !surface.values.empty()            ? MapColor(surface, v, u, w)
                    : !surface.triangle_colors.empty() ? surface.triangle_colors[triangle]
                                                       : surface.material.color;
        if (!part.corner_normals.empty()) {
            const Vec3f* n = &part.corner_normals[3 * triangle];
            const float weights[3] = {1 - u - w, u, w};
            const Vec3f mean = Unit(weights[0] * n[0] + u * n[1] + w * n[2]);
            const float side = Dot(mean, hit.facing) < 0 ? -1.f : 1.f;
            if (Length(mean) > 0) hit.normal = side * mean;
            // Shadow rays start from the rounded shape that the normals pretend, or flat triangles would shade their
            // own neighbours' curved-looking light (Hanika, Ray Tracing Gems II, chapter 4).
            Vec3f lift{};
            for (int i = 0; i < 3; ++i) {
                const Vec3f corner = ToScaled(surface.positions[static_cast<std::size_t>(v[i])]);
                const float below = std::min(0.f, side * Dot(hit.position - corner, n[i]));
                lift += (-weights[i] * below * side) * n[i];
            }
            hit.origin = lift;
        }
    }
    hit.origin = hit.position + kNudge * hit.facing + (part.corner_normals.empty() ? Vec3f{} : hit.origin);
    return true;
}

bool TracedScene::IsOccluded(Vec3f origin, Vec3f direction, float reach) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{.org_x = origin.x,
               .org_y = origin.y,
               .org_z = origin.z,
               .tnear = 0,
               .dir_x = direction.x,
               .dir_y = direction.y,
               .dir_z = direction.z,
               .time = 0,
               .tfar = reach,
               .mask = ~0u,
               .id = 0,
               .flags = 0};
    rtcOccluded1(impl_->solid.scene, &context, &ray);
    return ray.tfar < 0;  // Embree's mark for "something was met"
}

}  // namespace SolidSubdiv::Picture::Internal
