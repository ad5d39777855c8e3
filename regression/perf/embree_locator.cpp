// SPDX-License-Identifier: Apache-2.0
// The only source of the benchmarks that includes Embree.
#include "perf/embree_locator.h"

#if SOLIDSUBDIV_HAS_EMBREE

#include <embree3/rtcore.h>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/internal/cell_places.h>
#include <solidsubdiv/kit/geometry/internal/curve_order.h>
#include <solidsubdiv/sdc/parallel.h>

#include <string>

namespace SolidSubdiv::Perf {

using namespace Geometry::Internal;

struct EmbreeLocator::State {
    CellPlaces cells;
    std::span<const double> positions;
    Vec3 middle{};
    double scale = 1, reach = 0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Vec3 Scaled(const Vec3& p) const { return scale * (p - middle); }

    static void Bounds(const RTCBoundsFunctionArguments* arguments) {
        const State& s = *static_cast<const State*>(arguments->geometryUserPtr);
        Geometry::Box box;
        for (Index v : s.cells.Vertices(static_cast<Index>(arguments->primID))) {
            const Vec3 p = s.Scaled(PointAt(s.positions, v));
            box.Include(std::array{p.x, p.y, p.z});
        }
        RTCBounds& out = *arguments->bounds_o;
        const auto r = static_cast<float>(2 * s.reach);
        out.lower_x = static_cast<float>(box.low[0]) - r, out.upper_x = static_cast<float>(box.high[0]) + r;
        out.lower_y = static_cast<float>(box.low[1]) - r, out.upper_y = static_cast<float>(box.high[1]) + r;
        out.lower_z = static_cast<float>(box.low[2]) - r, out.upper_z = static_cast<float>(box.high[2]) + r;
    }

    struct Candidate {
        Index point, cell;
    };
    /// Cells whose nodes hold a point, to be tested when those of a few points are together, as ours are.
    struct Query {
        const State* state;
        std::vector<Candidate>* candidates;
        Index point;
    };
    static bool Visit(RTCPointQueryFunctionArguments* arguments) {
        const Query& q = *static_cast<const Query*>(arguments->userPtr);
        const auto cell = static_cast<Index>(arguments->primID);
        q.candidates->push_back({q.point, cell});
        q.state->cells.FetchIndices(cell);
        return false;  // the radius stays
    }
};

bool EmbreeLocator::IsThere() { return true; }

EmbreeLocator::EmbreeLocator(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
                             int n_threads)
    : state_(std::make_unique<State>(State{.cells = CellPlaces(refiner, level, positions), .positions = positions})) {
    State& s = *state_;
    const Geometry::Box box = Geometry::BoundingBox(positions);
    s.middle = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0.5 * (box.low[2] + box.high[2])};
    s.scale = 2 / box.Diagonal();
    s.reach = 1e-13;
    s.device = rtcNewDevice(("threads=" + std::to_string(n_threads)).c_str());
    s.scene = rtcNewScene(s.device);
    const RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(s.cells.n_cells()));
    rtcSetGeometryUserData(geometry, &s);
    rtcSetGeometryBoundsFunction(geometry, &State::Bounds, nullptr);
    rtcSetGeometryPointQueryFunction(geometry, &State::Visit);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s.scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(s.scene);
}

EmbreeLocator::~EmbreeLocator() {
    rtcReleaseScene(state_->scene);
    rtcReleaseDevice(state_->device);
}

std::vector<Far::Place> EmbreeLocator::Locate(std::span<const double> points) const {
    const State& s = *state_;
    const auto n = static_cast<Offset>(points.size() / 3);
    std::vector<std::uint32_t> keys(static_cast<std::size_t>(n));
    const auto rounded = [&](Index i) {
        const Vec3 p = s.Scaled(PointAt(points, i));
        return std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    };
    Sdc::ParallelFor(n, 1024, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) keys[i] = CurveKey(rounded(static_cast<Index>(i)).data());
    });
    const std::vector<Index> order = OrderByKey(keys);
    std::vector<Far::Place> places(static_cast<std::size_t>(n));
    constexpr Offset kAtATime = 16;
    Sdc::ParallelFor(n, 1024, [&](Offset begin, Offset end) {
        std::vector<State::Candidate> candidates;
        for (Offset first = begin; first < end; first += kAtATime) {
            candidates.clear();
            for (Offset k = first; k < std::min(end, first + kAtATime); ++k) {
                const Index i = order[static_cast<std::size_t>(k)];
                places[static_cast<std::size_t>(i)].element = kNoIndex;
                const auto p = rounded(i);
                RTCPointQuery query{.x = p[0], .y = p[1], .z = p[2], .time = 0, .radius = 0};
                RTCPointQueryContext context;
                rtcInitPointQueryContext(&context);
                State::Query mine{&s, &candidates, i};
                rtcPointQuery(s.scene, &query, &context, nullptr, &mine);
            }
            for (const auto& c : candidates) s.cells.FetchPositions(c.cell);
            for (const auto& c : candidates) {
                Far::Place& best = places[static_cast<std::size_t>(c.point)];
                if (best.element != kNoIndex && c.cell > best.element) continue;
                const CellPlace found = s.cells.Hold(c.cell, PointAt(points, c.point), s.scale, s.reach);
                if (found.distance <= s.reach) best = found.place;
            }
        }
    });
    return places;
}

}  // namespace SolidSubdiv::Perf

#else

namespace SolidSubdiv::Perf {
struct EmbreeLocator::State {};
bool EmbreeLocator::IsThere() { return false; }
EmbreeLocator::EmbreeLocator(const Far::TopologyRefiner&, int, std::span<const double>, int) {}
EmbreeLocator::~EmbreeLocator() = default;
std::vector<Far::Place> EmbreeLocator::Locate(std::span<const double>) const { return {}; }
}  // namespace SolidSubdiv::Perf

#endif
