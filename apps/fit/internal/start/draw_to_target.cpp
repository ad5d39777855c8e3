// SPDX-License-Identifier: Apache-2.0
// One vertex after another, in their order: few enough, and the same for any number of threads.
#include <solidsubdiv/apps/fit/internal/start/draw_to_target.h>

#include <algorithm>

#include <solidsubdiv/apps/fit/internal/start/cell_corners.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

using Lists = std::vector<std::vector<Index>>;

constexpr int kRounds = 40;

class Drawing {
  public:
    Drawing(ControlMesh& mesh, std::span<const Index> faces, std::size_t n_corners, const DrawingTarget& target,
            double size)
        : p_(mesh.positions),
          faces_(faces),
          n_corners_(n_corners),
          target_(target),
          size_(size),
          corners_(CornersOf(mesh)),
          corners_at_(static_cast<std::size_t>(mesh.n_vertices())),
          along_(corners_at_.size()) {
        for (std::size_t c = 0; c < corners_.size(); ++c) {
            const auto& v = corners_[c].v;
            for (Index i : v) corners_at_[At(i)].push_back(static_cast<Index>(c));
        }
        for (std::size_t f = 0; f < faces.size(); f += n_corners) {
            for (std::size_t k = 0; k < n_corners; ++k) {
                along_[At(faces[f + k])].push_back(faces[f + (k + 1) % n_corners]);
                along_[At(faces[f + k])].push_back(faces[f + (k + n_corners - 1) % n_corners]);
            }
        }
        for (Lists* lists : {&corners_at_, &along_}) {
            for (auto& list : *lists) {
                std::sort(list.begin(), list.end());
                list.erase(std::unique(list.begin(), list.end()), list.end());
            }
        }
    }

    double Run() {
        steps_.assign(along_.size(), .1 * size_);
        for (int round = 0; round < kRounds; ++round) Round(round / (kRounds - 1.));
        double least = corners_.empty() ? 0 : 1;
        for (const CellCorner& c : corners_) least = std::min(least, c.Quality(p_));
        return least;
    }

  private:
    static std::size_t At(Index v) { return static_cast<std::size_t>(v); }

    /// Where a boundary vertex shall go: to a plane, mostly, so that it may slide.
    struct Aim {
        Vec3 place, normal;
        double weight = 0;
    };

    double EnergyAt(Index v, const Aim& aim) const {
        double sum = 0;
        for (Index c : corners_at_[At(v)]) sum += corners_[At(c)].Energy(p_);
        const Vec3 off = 1 / size_ * (PointAt(p_, v) - aim.place);
        const double along_normal = Dot(off, aim.normal);
        return sum / static_cast<double>(corners_at_[At(v)].size()) +
               aim.weight * (.8 * along_normal * along_normal + .2 * Dot(off, off));
    }

    /// A step downhill, shorter after each that leads up.
    void Descend(Index v, const Aim& aim) {
        const Vec3 start = PointAt(p_, v);
        const double energy = EnergyAt(v, aim), h = 1e-4 * size_;
        const auto energy_at = [&](const Vec3& place) {
            SetPoint(p_, v, place);
            return EnergyAt(v, aim);
        };
        const Vec3 slope{energy_at(start + Vec3{h, 0, 0}) - energy, energy_at(start + Vec3{0, h, 0}) - energy,
                         energy_at(start + Vec3{0, 0, h}) - energy};
        double& step = steps_[At(v)];
        for (int attempt = 0; attempt < 6; ++attempt) {
            if (energy_at(start - step * Unit(slope)) < energy) {
                step *= 1.5;
                return;
            }
            step /= 3;
        }
        SetPoint(p_, v, start);
        step = std::max(step, 1e-4 * size_);
    }

    Vec3 MeanOf(const std::vector<Index>& vertices) const {
        Vec3 sum;
        for (Index v : vertices) sum = sum + PointAt(p_, v);
        return 1. / static_cast<double>(vertices.size()) * sum;
    }

    std::vector<double> Normals() const {
        std::vector<double> normals(p_.size(), 0.);
        for (std::size_t f = 0; f < faces_.size(); f += n_corners_) {
            const auto corner = [&](std::size_t k) { return PointAt(p_, faces_[f + k]); };
            const Vec3 n = n_corners_ == 3 ? Cross(corner(1) - corner(0), corner(2) - corner(0))
                                           : Cross(corner(2) - corner(0), corner(3) - corner(1));
            for (std::size_t k = 0; k < n_corners_; ++k) {
                SetPoint(normals, faces_[f + k], PointAt(normals, faces_[f + k]) + n);
            }
        }
        for (Index v = 0; At(v) < along_.size(); ++v) SetPoint(normals, v, Unit(PointAt(normals, v)));
        return normals;
    }

    /// Of each boundary vertex, in order: where the target is.
    std::vector<Vec3> Places(std::span<const double> normals) const {
        constexpr double kWays[3] = {0, .5, -.5};
        std::vector<double> queries;
        std::vector<Index> vertices;
        for (Index v = 0; At(v) < along_.size(); ++v) {
            if (along_[At(v)].empty()) continue;
            vertices.push_back(v);
            for (double way : kWays) {
                const Vec3 q = PointAt(p_, v) + way * size_ * PointAt(normals, v);
                queries.insert(queries.end(), {q.x, q.y, q.z});
            }
        }
        const auto nearest = target_.surface.Find(queries);
        std::vector<Vec3> places(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < 3; ++k) {
                const Geometry::ClosestPoint& at = nearest[3 * i + k];
                const Vec3 place{at.position[0], at.position[1], at.position[2]};
                const Vec3 off = 1 / size_ * (place - PointAt(p_, vertices[i]));
                const double against = target_.shape.IsOriented()
                                           ? 1 - Dot(target_.shape.NormalOf(at.element), PointAt(normals, vertices[i]))
                                           : 0;
                const double cost = Dot(off, off) + against * against;
                if (cost < least) least = cost, places[i] = place;
            }
        }
        return places;
    }

    /// @param done the part of the rounds that is over
    void Round(double done) {
        const std::vector<double> normals = Normals();
        const std::vector<Vec3> places = Places(normals);
        std::size_t next = 0;
        for (Index v = 0; At(v) < along_.size(); ++v) {
            if (along_[At(v)].empty()) {
                Descend(v, {});
                continue;
            }
            const Vec3 place = places[next++], normal = PointAt(normals, v), p = PointAt(p_, v), way = p - place;
            if (corners_.empty()) {
                const Vec3 apart = MeanOf(along_[At(v)]) - p;
                SetPoint(p_, v, p - .5 * way + .5 * (apart - Dot(apart, normal) * normal));
            } else {
                // From afar the way to the target says where it lies, near it the boundary does.
                Descend(v, {place, Length(way) > .05 * size_ ? Unit(way) : normal, 1 + 30 * done});
            }
        }
    }

    std::vector<double>& p_;
    std::span<const Index> faces_;
    std::size_t n_corners_;
    DrawingTarget target_;
    double size_;
    std::vector<CellCorner> corners_;
    Lists corners_at_, along_;     ///< of vertices; neighbours along the boundary
    std::vector<double> steps_{};  ///< (vertices)
};

}  // namespace

double DrawToTarget(ControlMesh& mesh, std::span<const Index> faces, std::size_t n_corners, const DrawingTarget& target,
                    double size) {
    return Drawing(mesh, faces, n_corners, target, size).Run();
}

}  // namespace SolidSubdiv::Fit::Starting
